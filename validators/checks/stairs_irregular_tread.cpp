#include <algorithm>
#include <cmath>

#include "mapcore/tolerances.hpp"
#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Two treads say nothing about which of them is usual.
constexpr std::size_t kLeastTreads = 3;

std::vector<double> treads_m(const Obstacle& stairs, const std::vector<Riser>& risers) {
  std::vector<double> treads;
  for (std::size_t n = 1; n < risers.size(); ++n) {
    treads.push_back(tread_m(stairs, risers[n - 1], risers[n]));
  }
  return treads;
}

}  // namespace

void check_stairs_irregular_tread(const CheckContext& context, FindingSink& sink) {
  const auto& options = context.options();
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    const auto risers = risers_of(stairs, flight);
    const auto treads = treads_m(stairs, risers);
    // Impossible treads are told of already (T120).
    if (treads.size() < kLeastTreads ||
        *std::min_element(treads.begin(), treads.end()) < options.min_step_tread_m) {
      return;
    }
    const double usual_m = median(treads);
    for (std::size_t n = 0; n < treads.size(); ++n) {
      const bool is_landing = treads[n] >= tolerance::kLanding_m;
      if (is_landing || std::abs(treads[n] - usual_m) <= options.max_tread_variation_m) continue;
      const std::size_t k = risers[n + 1].pieces.front();
      sink.segment(FindingCode::T122, i, k,
                   name_of(stairs, k) + " lies " + metres(treads[n]) +
                       " m behind the one below it, the others of its flight " + metres(usual_m) +
                       " m; move it into line");
    }
  });
}

}  // namespace mapwright::validators
