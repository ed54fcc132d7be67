#include <charconv>

#include "mapcore/defect_geometry.hpp"
#include "validators/check.hpp"

namespace mapwright::validators {
namespace {

// The token source=LAYER:FEATURE, which `convert --source-tokens` writes.
std::vector<GisFeature> features_of(const Obstacle& obstacle) {
  const auto token = obstacle.semantic.value(semantic_key::kSource);
  if (!token) return {};
  const auto colon = token->rfind(':');
  if (colon == token->npos) return {};
  const auto digits = token->substr(colon + 1);
  GisFeature feature{"", std::string(token->substr(0, colon)), 0};
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), feature.fid);
  if (error != std::errc{} || end != digits.data() + digits.size()) return {};
  return {std::move(feature)};
}

}  // namespace

void FindingSink::border(FindingCode code, std::string message) {
  Finding finding = make_finding(code, std::move(message));
  const Border& border = document_.map.border;
  finding.place = document_.index.border_place(document_.text);
  finding.at = Point{border.left, border.top};
  finding.geometry = geometry_of(border);
  findings_.push_back(std::move(finding));
}

void FindingSink::obstacle(FindingCode code, std::size_t obstacle, ObstacleField field,
                           std::string message) {
  const Obstacle& subject = document_.map.obstacles[obstacle];
  Finding finding = make_finding(code, std::move(message));
  finding.place = document_.index.place(document_.text, obstacle, field);
  if (!subject.segments.empty()) finding.at = subject.segments.front().a;
  finding.obstacle = subject.id;
  finding.geometry = geometry_of(subject);
  finding.features = features_of(subject);
  findings_.push_back(std::move(finding));
}

void FindingSink::segment(FindingCode code, std::size_t obstacle, std::size_t segment,
                          SegmentField field, Point at, std::string message) {
  Finding finding = make_finding(code, std::move(message));
  finding.place = document_.index.place(document_.text, obstacle, segment, field);
  finding.at = at;
  const Obstacle& subject = document_.map.obstacles[obstacle];
  const Segment& shown = subject.segments[segment];
  finding.obstacle = subject.id;
  finding.features = features_of(subject);
  finding.geometry = geometry_of(shown);
  if (at != shown.a) finding.geometry.points.push_back(at);
  finding.segment = segment + 1;
  findings_.push_back(std::move(finding));
}

void FindingSink::segment(FindingCode code, std::size_t obstacle, std::size_t segment,
                          std::string message) {
  const Point at = document_.map.obstacles[obstacle].segments[segment].a;
  this->segment(code, obstacle, segment, SegmentField::kAx, at, std::move(message));
}

}  // namespace mapwright::validators
