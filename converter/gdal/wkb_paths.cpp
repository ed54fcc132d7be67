#include "converter/gdal/wkb_paths.hpp"

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
  WkbReader(std::span<const std::byte> wkb, SourceGeometry& out) : left_(wkb), out_(out) {}

  bool read() {
    std::uint32_t type = 0;
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
    if (is_whole) dimensions_ = dimensions;
    has_heights_ =
        dimensions_ == kOldWithHeights || dimensions_ == kWithHeights || dimensions_ == kWithBoth;
    const bool is_known = dimensions_ == 0 || has_heights_ || dimensions_ == kWithMeasures;
    numbers_ = 2U + (has_heights_ ? 1U : 0U) +
               (dimensions_ >= kWithMeasures && dimensions_ != kOldWithHeights ? 1U : 0U);
    return is_known && dimensions == dimensions_ && type >= kPoint && type <= kMultiPolygon;
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
    return append(1, PathRole::kPoint) &&
           !(std::isnan(out_.xs.back()) || std::isnan(out_.ys.back()));
  }

  bool read_path(PathRole role) {
    std::uint32_t count = 0;
    return take(count) && count > 0 && append(count, role);
  }

  bool append(std::uint32_t count, PathRole role) {
    if (count > left_.size() / (numbers_ * sizeof(double))) return false;
    const std::size_t first = out_.xs.size();
    out_.xs.resize(first + count);
    out_.ys.resize(first + count);
    if (has_heights_) out_.zs.resize(first + count);
    const std::byte* at = left_.data();
    for (std::size_t i = first; i < first + count; ++i, at += numbers_ * sizeof(double)) {
      std::memcpy(&out_.xs[i], at, sizeof(double));
      std::memcpy(&out_.ys[i], at + sizeof(double), sizeof(double));
      if (has_heights_) std::memcpy(&out_.zs[i], at + 2 * sizeof(double), sizeof(double));
    }
    left_ = left_.subspan(count * numbers_ * sizeof(double));
    out_.paths.push_back({static_cast<std::uint32_t>(first), count, role, false});
    return true;
  }

  std::span<const std::byte> left_;
  SourceGeometry& out_;
  std::uint32_t dimensions_ = 0;
  std::size_t numbers_ = 2;  // of a point
  bool has_heights_ = false;
};

}  // namespace

bool append_wkb(std::span<const std::byte> wkb, SourceGeometry& paths) {
  return WkbReader(wkb, paths).read();
}

}  // namespace mapwright::converter
