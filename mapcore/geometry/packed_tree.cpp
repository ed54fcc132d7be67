#include "mapcore/geometry/packed_tree.hpp"

#include <utility>

namespace mapwright {
namespace {

constexpr std::uint32_t kSide = 1U << 16U;

// Position of a cell along the Hilbert curve through a grid of kSide × kSide cells.
std::uint32_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0;
  for (std::uint32_t step = kSide / 2; step > 0; step /= 2) {
    const std::uint32_t right = (x & step) != 0 ? 1 : 0;
    const std::uint32_t up = (y & step) != 0 ? 1 : 0;
    position += step * step * ((3 * right) ^ up);
    if (up == 0) {
      if (right == 1) {
        x = kSide - 1 - x;
        y = kSide - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return position;
}

std::uint32_t cell(double value, double low, double size) {
  if (!(size > 0.0)) return 0;
  const double scaled = (value - low) / size * (kSide - 1);
  return scaled > 0.0 ? std::min<std::uint32_t>(static_cast<std::uint32_t>(scaled), kSide - 1) : 0;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::size_t count, const Box& extent,
                                         std::span<const Point> centers) {
  const double width = extent.width(), height = extent.height();
  std::vector<std::uint64_t> keys(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = cell(centers[i].x, extent.min_x, width);
    const auto y = cell(centers[i].y, extent.min_y, height);
    keys[i] = static_cast<std::uint64_t>(hilbert_position(x, y)) << 32U | i;
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  for (std::size_t k = 0; k < count; ++k) order[k] = static_cast<std::uint32_t>(keys[k]);
  return order;
}

}  // namespace mapwright
