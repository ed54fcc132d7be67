#include "validators/deployment/blame.hpp"

#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

using Position = std::optional<std::uint32_t>;

std::string side_text(const Map& map, Position obstacle, Position segment) {
  if (!obstacle) return "the border";
  const Obstacle& subject = map.obstacles[*obstacle];
  std::string text = segment ? name_of(subject, *segment) : "a flank of " + name_of(subject);
  if (!subject.semantic.empty()) text += " (" + subject.semantic.str() + ")";
  return text;
}

}  // namespace

std::string gap_text(const Map& map, const navcore::Bottleneck& gap) {
  return metres(gap.width_m) + " m wide at " + place_text(gap.at) + ", between " +
         side_text(map, gap.obstacle_from, gap.segment_from) + " and " +
         side_text(map, gap.obstacle_to, gap.segment_to);
}

void show(const navcore::Bottleneck& gap, Finding& finding) {
  finding.geometry.lines.push_back({gap.from, gap.to});
}

void blame(const MapDocument& document, const navcore::Bottleneck& gap, Finding& finding) {
  show(gap, finding);
  const Position obstacle = gap.obstacle_from ? gap.obstacle_from : gap.obstacle_to;
  if (!obstacle) return;  // a border hardly wider than the robot
  const Position segment = gap.obstacle_from ? gap.segment_from : gap.segment_to;
  finding.obstacle = document.map.obstacles[*obstacle].id;
  if (segment) finding.segment = *segment + 1;
  finding.place = segment
                      ? document.index.place(document.text, *obstacle, *segment, SegmentField::kAx)
                      : document.index.place(document.text, *obstacle, ObstacleField::kId);
}

}  // namespace mapwright::validators
