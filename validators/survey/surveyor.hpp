// Private to this folder: Makes a survey, one obstacle after another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mapcore/text/obstacle_stream.hpp"
#include "validators/survey/chain_proof.hpp"
#include "validators/survey/survey.hpp"
#include "validators/survey/word_proof.hpp"

namespace mapwright::validators {

/// What a walk over an obstacle's segments shows.
struct SegmentLook;

/// Looks at the obstacles of a map in their order.
class Surveyor {
 public:
  explicit Surveyor(const ValidationOptions& options)
      : options_(options), chains_(options.sliver_width_m) {}

  /// Expects so many obstacles in all.
  void reserve(std::size_t obstacles) { survey_.boxes_.reserve(obstacles); }

  void look_at(const ObstacleView& obstacle);

  /// True if an obstacle was put in doubt, or shares its id with another, or maybe its name.
  bool has_doubts() const { return has_doubts_ || survey_.ids_may_repeat_; }

  /// True if an obstacle names the GIS feature it comes from.
  bool saw_a_source() const { return saw_a_source_; }

  /// No more obstacles come.
  Survey survey() &&;

 private:
  void doubt(Doubt doubt);
  void doubt_if(bool condition, Doubt which) {
    if (condition) doubt(which);
  }

  void look_at_id(std::int64_t id);
  void look_at_words(const ObstacleView& obstacle);
  void look_at_name(const Words& words);
  void look_at_segments(const ObstacleView& obstacle);
  void add_box(const Box& box);
  void look_at_attributes(const ObstacleView& obstacle, const SegmentLook& look);
  void look_at_shape(const ObstacleView& obstacle, const SegmentLook& look);
  void look_at_stairs(const ObstacleView& stairs, const SegmentLook& look);
  void look_at_chain(const ObstacleView& obstacle, const SegmentLook& look);

  const ValidationOptions& options_;
  Survey survey_;
  ChainProver chains_;
  WordProver words_;
  NameSet names_;
  bool has_doubts_ = false;
  bool saw_a_source_ = false;
  bool has_outer_ = false;    // the obstacle looked at calls itself an inner ring
  std::int64_t last_id_ = 0;  // of the obstacle before
  std::string_view last_semantic_;
};

}  // namespace mapwright::validators
