#include <algorithm>
#include <cmath>
#include <numeric>

#include "validators/fix/fixer.hpp"
#include "validators/shape/flight.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

Point middle(const Segment& segment) {
  return 0.5 * segment.a + 0.5 * segment.b;
}

/// How the steps of a flight lie one behind the other.
class StepOrder {
 public:
  StepOrder(const Obstacle& stairs, const Flight& flight) : stairs_(stairs), flight_(flight) {
    Point along;
    for (std::size_t n = 0; n < flight.steps.size(); ++n) {
      const Segment& step = stairs.segments[flight.steps[n]];
      along = along + (flight.faces_as_most[n] ? 1.0 : -1.0) * (step.b - step.a);
    }
    // Free space, where one comes up, lies on the right of the steps: up is to their left.
    up_ = {-along.y, along.x};
  }

  /// The segments from the foot to the closing one; nothing if they do not rise that way one by
  /// one, by nearly equal steps.
  std::optional<std::vector<std::size_t>> upwards() const {
    if (flight_.steps.size() < 2 || squared_length(up_) == 0.0) return std::nullopt;
    std::vector<std::size_t> order = flight_.steps;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t p, std::size_t q) { return progress(p) < progress(q); });
    for (std::size_t n = 1; n < order.size(); ++n) {
      const double rise_m =
          stairs_.segments[order[n]].height_m - stairs_.segments[order[n - 1]].height_m;
      if (!(rise_m > 0.0) || !(progress(order[n]) > progress(order[n - 1]))) return std::nullopt;
    }
    if (flight_.closing.size() > 1) return std::nullopt;
    if (!flight_.closing.empty()) {
      if (progress(flight_.closing.front()) < progress(order.back())) return std::nullopt;
      order.push_back(flight_.closing.front());
    }
    return order;
  }

  /// The same where neighbouring heights were written at each other's steps: heights by size, if
  /// the steps are then equally high.
  std::optional<std::vector<double>> sorted_heights(std::vector<std::size_t>& by_place) const {
    if (flight_.steps.size() < 3 || squared_length(up_) == 0.0) return std::nullopt;
    by_place = flight_.steps;
    std::stable_sort(by_place.begin(), by_place.end(),
                     [&](std::size_t p, std::size_t q) { return progress(p) < progress(q); });
    std::vector<double> heights;
    for (const std::size_t k : by_place) heights.push_back(stairs_.segments[k].height_m);
    std::sort(heights.begin(), heights.end());
    const double rise_m = heights.back() / static_cast<double>(heights.size());
    constexpr double kMostDeviation = 0.2;
    for (std::size_t n = 0; n < heights.size(); ++n) {
      const double step_m = heights[n] - (n == 0 ? 0.0 : heights[n - 1]);
      if (std::abs(step_m - rise_m) > kMostDeviation * rise_m) return std::nullopt;
    }
    return heights;
  }

 private:
  double progress(std::size_t k) const { return dot(middle(stairs_.segments[k]), up_); }

  const Obstacle& stairs_;
  const Flight& flight_;
  Point up_;
};

// The record k gets the fields of the record order[k].
std::vector<OffsetEdit> permuting_edits(const std::vector<SegmentText>& texts,
                                        const std::vector<std::size_t>& order) {
  std::vector<OffsetEdit> edits;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    for (std::size_t i = 0; i < texts[k].fields.size(); ++i) {
      const auto& field = texts[k].fields[i];
      const auto text = texts[order[k]].fields[i].text;
      if (field.text != text) edits.push_back(field_edit(field, std::string(text)));
    }
  }
  return edits;
}

// Finds the record of the stairs that has this height, to copy its digits.
std::string digits_of(double height_m, const Obstacle& stairs,
                      const std::vector<SegmentText>& texts) {
  const auto found = std::find_if(stairs.segments.begin(), stairs.segments.end(),
                                  [&](const Segment& s) { return s.height_m == height_m; });
  return std::string(
      texts[static_cast<std::size_t>(found - stairs.segments.begin())].fields[4].text);
}

std::optional<Proposal> reordered(const Obstacle& stairs, std::size_t position,
                                  const std::vector<SegmentText>& texts) {
  const Flight flight = flight_of(stairs);
  auto order = StepOrder(stairs, flight).upwards();
  if (!order || order->size() != stairs.segments.size()) return std::nullopt;
  if (!flight.rises) std::reverse(order->begin(), order->end());
  auto edits = permuting_edits(texts, *order);
  if (edits.empty()) return std::nullopt;
  return Proposal{{},
                  position,
                  name_of(stairs) + ": its steps printed in the order they rise",
                  std::move(edits)};
}

std::optional<Proposal> with_heights_sorted(const Obstacle& stairs, std::size_t position,
                                            const std::vector<SegmentText>& texts) {
  const Flight flight = flight_of(stairs);
  std::vector<std::size_t> by_place;
  const auto heights = StepOrder(stairs, flight).sorted_heights(by_place);
  if (!heights) return std::nullopt;
  Proposal proposal{{}, position, name_of(stairs) + ": heights of its steps put in order", {}};
  for (std::size_t n = 0; n < by_place.size(); ++n) {
    if (stairs.segments[by_place[n]].height_m == (*heights)[n]) continue;
    proposal.edits.push_back(
        field_edit(texts[by_place[n]].fields[4], digits_of((*heights)[n], stairs, texts)));
  }
  std::sort(proposal.edits.begin(), proposal.edits.end(),
            [](const OffsetEdit& p, const OffsetEdit& q) { return p.begin < q.begin; });
  if (proposal.edits.empty()) return std::nullopt;
  return proposal;
}

}  // namespace

Proposals fix_stairs_order(const FixContext& context) {
  Proposals proposals;
  for (const FindingCode code : {FindingCode::T101, FindingCode::T102}) {
    for (const std::size_t position : blamed(context, code)) {
      const Obstacle& stairs = context.document.map.obstacles[position];
      const auto texts = segment_texts(context.document, position);
      if (!texts) continue;
      auto proposal = reordered(stairs, position, *texts);
      if (!proposal) proposal = with_heights_sorted(stairs, position, *texts);
      if (!proposal) continue;
      proposal->code = code;
      proposals.push_back(*std::move(proposal));
    }
  }
  return proposals;
}

}  // namespace mapwright::validators
