#include "converter/source/wkb.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace mapwright::converter {
namespace {

enum Type : std::uint32_t {
  kPoint = 1,
  kLineString = 2,
  kPolygon = 3,
  kMultiPoint = 4,
  kMultiLineString = 5,
  kMultiPolygon = 6
};

constexpr std::array<std::string_view, 7> kNames{
    "", "POINT", "LINESTRING", "POLYGON", "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON"};

// Type numbers of geometries with heights, measures and both begin at these.
constexpr std::uint32_t kWithHeights = 1000;
constexpr std::uint32_t kWithMeasures = 2000;
constexpr std::uint32_t kWithBoth = 3000;
constexpr std::uint32_t kOldWithHeights = 0x80000000U;  // as OGC wrote them before ISO

class WkbReader {
 public:
  WkbReader(std::span<const std::byte> wkb, WkbPaths& out) : left_(wkb), out_(out) {}

  bool read() {
    std::uint32_t type = 0;
    out_.paths.clear();
    if (!take_header(type, true)) return false;
    out_.type = kNames[type];
    return type <= kPolygon ? read_single(type) : read_parts(type - 3);
  }

 private:
  template <class T>
  bool take(T& value) {
    if (left_.size() < sizeof value) return false;
    std::memcpy(&value, left_.data(), sizeof value);
    left_ = left_.subspan(sizeof value);
    return true;
  }

  // Parts must have the whole's dimensions.
  bool take_header(std::uint32_t& type, bool is_whole) {
    std::uint8_t is_little_endian = 0;
    if (!take(is_little_endian) || !take(type)) return false;
    if (is_little_endian != 1 || std::endian::native != std::endian::little) return false;
    std::uint32_t dimensions = type & kOldWithHeights;
    type &= ~kOldWithHeights;
    if (dimensions == 0) dimensions = type / 1000 * 1000;
    if (dimensions != kOldWithHeights) type -= dimensions;
    if (is_whole) set_dimensions(dimensions);
    const bool is_known = dimensions_ == 0 || out_.has_heights || dimensions_ == kWithMeasures;
    return is_known && dimensions == dimensions_ && type >= kPoint && type <= kMultiPolygon;
  }

  void set_dimensions(std::uint32_t dimensions) {
    const bool has_measures = dimensions >= kWithMeasures && dimensions != kOldWithHeights;
    dimensions_ = dimensions;
    out_.has_heights =
        dimensions == kOldWithHeights || dimensions == kWithHeights || dimensions == kWithBoth;
    out_.numbers = 2U + (out_.has_heights ? 1U : 0U) + (has_measures ? 1U : 0U);
  }

  bool read_parts(std::uint32_t part) {
    std::uint32_t count = 0;
    if (!take(count) || count == 0) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
      std::uint32_t type = 0;
      if (!take_header(type, false) || type != part || !read_single(type)) return false;
    }
    return true;
  }

  bool read_single(std::uint32_t type) {
    if (type == kPoint) return read_point();
    if (type == kLineString) return read_path(PathRole::kLine);
    std::uint32_t rings = 0;
    if (!take(rings) || rings == 0) return false;
    for (std::uint32_t i = 0; i < rings; ++i) {
      if (!read_path(i == 0 ? PathRole::kOuterRing : PathRole::kInnerRing)) return false;
    }
    return true;
  }

  // An empty point is written as one that is not a number.
  bool read_point() {
    if (!append(1, PathRole::kPoint)) return false;
    std::array<double, 2> place;
    std::memcpy(place.data(), out_.paths.back().points, sizeof place);
    return !(std::isnan(place[0]) || std::isnan(place[1]));
  }

  bool read_path(PathRole role) {
    std::uint32_t count = 0;
    return take(count) && count > 0 && append(count, role);
  }

  bool append(std::uint32_t count, PathRole role) {
    const std::size_t bytes = out_.numbers * sizeof(double);
    if (count > left_.size() / bytes) return false;
    out_.paths.push_back({role, count, left_.data()});
    left_ = left_.subspan(count * bytes);
    return true;
  }

  std::span<const std::byte> left_;
  WkbPaths& out_;
  std::uint32_t dimensions_ = 0;
};

}  // namespace

std::uint32_t WkbPaths::point_count() const {
  std::uint32_t count = 0;
  for (const auto& path : paths) count += path.count;
  return count;
}

bool find_paths(std::span<const std::byte> wkb, WkbPaths& paths) {
  return WkbReader(wkb, paths).read();
}

char* copy_numbers(const WkbPaths& paths, std::size_t place, char* to) {
  const std::size_t step = paths.numbers * sizeof(double);
  for (const auto& path : paths.paths) {
    const std::byte* from = path.points + place * sizeof(double);
    for (std::uint32_t i = 0; i < path.count; ++i, from += step, to += sizeof(double)) {
      std::memcpy(to, from, sizeof(double));
    }
  }
  return to;
}

}  // namespace mapwright::converter
