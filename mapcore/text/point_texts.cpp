#include "mapcore/text/point_texts.hpp"

#include <cassert>

#include "mapcore/text/digits.hpp"

namespace mapwright::text {
namespace {

// Writes a number and says where it ends; 16 bytes may be written.
template <class WriteNumber>
std::size_t write_line(char* const line, GridPoint point, const WriteNumber& write) {
  char* at = write(line, point.x);
  *at = ';';
  at = write(at + 1, point.y);
  at[0] = ';';
  at[1] = '\n';
  return static_cast<std::size_t>(at + 2 - line);
}

constexpr bool kHasQuickDigits = std::endian::native == std::endian::little;

}  // namespace

void PointTexts::set(std::span<const GridPoint> points, const DecimalFormat& format) {
  assert(points.size() <= kMost);
  const auto set_all = [&](const auto& write) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      sizes_[i] = static_cast<std::uint8_t>(write_line(lines_[i].data(), points[i], write));
    }
  };
  if (kHasQuickDigits && format.decimals() == 3) return set_all(write_thousandths_of_one);
  set_all([&](char* at, std::int32_t units) { return format.write_units(at, units); });
}

}  // namespace mapwright::text
