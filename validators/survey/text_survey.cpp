#include "validators/survey/text_survey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mapcore/geometry/segment_index.hpp"
#include "mapcore/text/obstacle_stream.hpp"
#include "validators/shape/margins.hpp"
#include "validators/survey/surveyor.hpp"

namespace mapwright::validators {
namespace {

// Obstacles that show how many bytes of the text one takes.
constexpr std::size_t kSample = 1024;

// G101 and G102: it encloses an area, near enough.
bool is_plausible(const Border& border, const ValidationOptions& options) {
  const double farthest_m = std::max({std::abs(border.left), std::abs(border.top),
                                      std::abs(border.right), std::abs(border.bottom)});
  return border.left < border.right && border.bottom < border.top &&
         farthest_m <= options.max_coordinate_m;
}

// G107, G109, G125 and G126: obstacles keep a distance from the border on all sides, but no great
// one.
bool surrounds(const Border& border, const Box& obstacles, const ValidationOptions& options) {
  if (obstacles.is_empty()) return true;
  const auto margins = margins_m(border, obstacles);
  const auto [least, greatest] = std::minmax_element(margins.begin(), margins.end());
  return *least > std::max(0.0, options.min_border_margin_m) &&
         *greatest <=
             std::max({options.max_border_margin_m, obstacles.width(), obstacles.height()});
}

bool may_come_near_each_other(const std::vector<Box>& boxes, double reach_m) {
  bool found = false;
  for_each_meeting_pair(
      boxes, [&](std::size_t, std::size_t) { found = true; }, reach_m);
  return found;
}

bool is_sound(const Survey& survey, const Border& border, const ValidationOptions& options) {
  return !survey.names_may_repeat() && is_plausible(border, options) &&
         surrounds(border, survey.extent(), options) &&
         !may_come_near_each_other(survey.boxes(), std::max(0.0, options.near_miss_m));
}

}  // namespace

TextSurvey survey_text(const MapText& text, const ValidationOptions& options,
                       const Progress& progress) {
  Surveyor surveyor(options);
  std::size_t count = 0;
  const auto look = [&](const ObstacleView& obstacle) {
    surveyor.look_at(obstacle);
    if (++count == kSample) surveyor.reserve(text.size() / (obstacle.offset / kSample + 1));
    return !surveyor.has_doubts();
  };
  const auto border = visit_obstacles(text, look, progress);
  TextSurvey result;
  result.may_name_sources = !border || surveyor.saw_a_source();
  if (!border) return result;
  result.border = *border;
  result.survey = std::move(surveyor).survey();
  result.is_sound = is_sound(*result.survey, *border, options);
  return result;
}

}  // namespace mapwright::validators
