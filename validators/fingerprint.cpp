#include "validators/fingerprint.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "mapcore/text/characters.hpp"

namespace mapwright::validators {
namespace {

// FNV-1a, 64 bits: the same on every machine.
std::string hashed(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; hash >>= 4U) digits[i] = kDigits[hash & 0xFU];
  return digits;
}

// Whole millimetres; what has more of them than a number can count is far beyond any map.
std::string millimetres(double metres) {
  constexpr double kMost = 9.0e18;
  const double value = std::round(metres * 1000.0);
  return std::abs(value) < kMost ? std::to_string(static_cast<std::int64_t>(value)) : "far";
}

std::string point_text(Point p) {
  return "at " + millimetres(p.x) + " " + millimetres(p.y);
}

// The record around an offset, from the '#' before to the '#' behind, without white space.
std::string record_text(std::string_view text, std::size_t offset) {
  std::size_t begin = offset == 0 ? text.npos : text.rfind('#', offset - 1);
  begin = begin == text.npos ? 0 : begin + 1;
  std::string record = "record ";
  for (const char c : text.substr(begin, text.find('#', offset) - begin)) {
    if (!text::is_blank(c)) record += c;
  }
  return record;
}

/// The first point of the first obstacle of each id.
class FirstPoints {
 public:
  explicit FirstPoints(const Map& map) : map_(map) {}

  std::optional<Point> of(std::int64_t id) {
    if (points_.empty()) {
      for (const auto& obstacle : map_.obstacles) {
        if (!obstacle.segments.empty()) {
          points_.emplace(obstacle.id, obstacle.segments.front().a);
        }
      }
    }
    const auto found = points_.find(id);
    return found == points_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  const Map& map_;
  std::unordered_map<std::int64_t, Point> points_;
};

std::string place_of(const MapDocument& document, const Finding& finding, FirstPoints& points) {
  if (finding.at) return point_text(*finding.at);
  if (finding.obstacle && !finding.segment) {
    if (const auto point = points.of(*finding.obstacle)) return point_text(*point);
  }
  if (!finding.place) return "map";
  return record_text(document.text, document.index.offset_at(document.text, *finding.place));
}

std::string subject_of(const Finding& finding) {
  if (!finding.obstacle) return "map";
  std::string subject = "obstacle " + std::to_string(*finding.obstacle);
  if (finding.segment) subject += " segment " + std::to_string(*finding.segment);
  return subject;
}

/// Tells equal names apart.
class Counter {
 public:
  std::string numbered(std::string name) {
    const std::size_t count = ++counts_[name];
    return count == 1 ? name : name + "-" + std::to_string(count);
  }

 private:
  std::unordered_map<std::string, std::size_t> counts_;
};

}  // namespace

std::vector<Fingerprint> fingerprints(const MapDocument& document,
                                      const std::vector<Finding>& findings) {
  FirstPoints points(document.map);
  Counter places, subjects;
  std::vector<Fingerprint> names;
  names.reserve(findings.size());
  for (const auto& finding : findings) {
    const std::string code(finding_type(finding.code).id);
    names.push_back({places.numbered(hashed(code + " " + place_of(document, finding, points))),
                     subjects.numbered(hashed(code + " " + subject_of(finding)))});
  }
  return names;
}

}  // namespace mapwright::validators
