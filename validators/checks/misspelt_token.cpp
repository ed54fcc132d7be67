#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "validators/check.hpp"
#include "validators/vocabulary.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// A word that so many obstacles have is no slip of the pen.
constexpr std::size_t kMeant = 3;

struct Slip {
  std::string_view written, meant;
};

// Where a slip stands: the obstacle's own string, or that of one of its segments.
struct Occurrence {
  std::size_t obstacle = 0;
  std::optional<std::size_t> segment;
  const Slip* slip = nullptr;
};

std::vector<Slip> slips_in(const Semantic& semantic) {
  std::vector<Slip> slips;
  for (const auto token : semantic.tokens()) {
    const auto equals = token.find('=');
    const auto key = token.substr(0, equals);
    const auto written = key.substr(0, key.find_last_not_of(" \t") + 1);
    const auto meant = equals == token.npos ? label_meant(written) : key_meant(written);
    if (meant) slips.push_back({written, *meant});
  }
  return slips;
}

class Spelling {
 public:
  explicit Spelling(const CheckContext& context)
      : context_(context), obstacles_(context.map().obstacles) {}

  void look() {
    for (const auto i : context_.in_doubt(Doubt::kWords)) {
      add(obstacles_[i].semantic, {i, std::nullopt, nullptr});
      const char* last = nullptr;  // segments of an obstacle mostly share one string
      for (std::size_t k = 0; k < obstacles_[i].segments.size(); ++k) {
        const Semantic& semantic = obstacles_[i].segments[k].semantic;
        if (semantic.view().data() != last) add(semantic, {i, k, nullptr});
        last = semantic.view().data();
      }
    }
  }

  void report(FindingSink& sink) const {
    std::map<std::string_view, std::size_t> times;
    for (const auto& found : found_) ++times[found.slip->written];
    for (const auto& found : found_) {
      if (times[found.slip->written] < kMeant) report(found, sink);
    }
  }

 private:
  void add(const Semantic& semantic, Occurrence where) {
    const auto [entry, is_new] = known_.try_emplace(semantic.view().data());
    if (is_new) entry->second = slips_in(semantic);
    for (const Slip& slip : entry->second) {
      where.slip = &slip;
      found_.push_back(where);
    }
  }

  void report(const Occurrence& found, FindingSink& sink) const {
    const Obstacle& obstacle = obstacles_[found.obstacle];
    const std::string message =
        "'" + std::string(found.slip->written) + "' in the semantic string of " +
        (found.segment ? name_of(obstacle, *found.segment) : name_of(obstacle)) +
        " is no known word; did you mean '" + std::string(found.slip->meant) + "'?";
    if (found.segment) {
      sink.segment(FindingCode::S123, found.obstacle, *found.segment, SegmentField::kSemantic,
                   obstacle.segments[*found.segment].a, message);
    } else {
      sink.obstacle(FindingCode::S123, found.obstacle, ObstacleField::kSemantic, message);
    }
  }

  const CheckContext& context_;
  const std::vector<Obstacle>& obstacles_;
  std::unordered_map<const char*, std::vector<Slip>> known_;  // by where the string lies
  std::vector<Occurrence> found_;
};

}  // namespace

void check_misspelt_token(const CheckContext& context, FindingSink& sink) {
  Spelling spelling(context);
  spelling.look();
  spelling.report(sink);
}

}  // namespace mapwright::validators
