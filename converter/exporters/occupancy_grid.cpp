// Occupancy grids for map servers (ROS map_server, nav2): an image and what it means.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

#include "converter/exchange/decimal_text.hpp"
#include "converter/exporters/export_map.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

// Grey values of a trinary map with negate 0: p = (255 - grey) / 255.
constexpr std::uint8_t kOccupied = 0;
constexpr std::uint8_t kFree = 254;
constexpr std::uint8_t kUnknown = 205;
constexpr double kMostCells = 1.0e9;

class Grid {
 public:
  Grid(const Border& border, double cell_m)
      : left_(border.left),
        bottom_(border.bottom),
        cell_m_(cell_m),
        columns_(
            static_cast<std::int64_t>(std::ceil((border.right - border.left) / cell_m - 1e-9))),
        rows_(static_cast<std::int64_t>(std::ceil((border.top - border.bottom) / cell_m - 1e-9))),
        cells_(static_cast<std::size_t>(columns_ * rows_), kFree) {}

  std::int64_t columns() const { return columns_; }
  std::int64_t rows() const { return rows_; }
  const std::vector<std::uint8_t>& cells() const { return cells_; }

  /// Occupies every cell whose closed square the segment touches.
  void draw(Point a, Point b) {
    if (a.y > b.y) std::swap(a, b);
    const auto first = std::max<std::int64_t>(0, row_at(a.y, false));
    const auto last = std::min<std::int64_t>(rows_ - 1, row_at(b.y, true));
    for (std::int64_t row = first; row <= last; ++row) {
      const double low = bottom_ + cell_m_ * static_cast<double>(row);
      const double x1 = x_at(a, b, std::max(a.y, low));
      const double x2 = x_at(a, b, std::min(b.y, low + cell_m_));
      const bool flat = a.y == b.y;
      occupy_row(row, flat ? std::min(a.x, b.x) : std::min(x1, x2),
                 flat ? std::max(a.x, b.x) : std::max(x1, x2));
    }
  }

  /// Gives `value` to the cells whose centres lie inside of a ring, by the odd-even rule.
  void fill(const std::vector<Point>& ring, std::uint8_t value) {
    Box box = kEmptyBox;
    for (const Point p : ring) box.add(p);
    const auto first = std::max<std::int64_t>(0, row_at(box.min_y, false));
    const auto last = std::min<std::int64_t>(rows_ - 1, row_at(box.max_y, true));
    std::vector<double> cuts;
    for (std::int64_t row = first; row <= last; ++row) {
      const double y = bottom_ + cell_m_ * (static_cast<double>(row) + 0.5);
      cuts.clear();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
        if ((a.y <= y) != (b.y <= y)) cuts.push_back(x_at(a, b, y));
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
        fill_row(row, cuts[i], cuts[i + 1], value);
    }
  }

 private:
  // The row of a height; of a height between two rows the one below or above it.
  std::int64_t row_at(double y, bool upper) const { return index((y - bottom_) / cell_m_, upper); }
  static std::int64_t index(double cells, bool upper) {
    const double bounded = std::clamp(cells, -2.0, 4.0e9);
    return static_cast<std::int64_t>(upper ? std::floor(bounded) : std::ceil(bounded) - 1.0);
  }
  static double x_at(Point a, Point b, double y) {
    if (a.y == b.y) return a.x;
    return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
  }

  std::uint8_t* row_begin(std::int64_t row) {
    return cells_.data() + static_cast<std::size_t>((rows_ - 1 - row) * columns_);
  }
  void occupy_row(std::int64_t row, double x1, double x2) {
    const auto first = std::max<std::int64_t>(0, index((x1 - left_) / cell_m_, false));
    const auto last = std::min<std::int64_t>(columns_ - 1, index((x2 - left_) / cell_m_, true));
    for (auto column = first; column <= last; ++column) row_begin(row)[column] = kOccupied;
  }
  void fill_row(std::int64_t row, double x1, double x2, std::uint8_t value) {
    const double from = std::clamp((x1 - left_) / cell_m_ - 0.5, -1.0, 4.0e9);
    const double to = std::clamp((x2 - left_) / cell_m_ - 0.5, -1.0, 4.0e9);
    const auto first = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(from)));
    const auto last =
        std::min<std::int64_t>(columns_ - 1, static_cast<std::int64_t>(std::floor(to)));
    for (auto column = first; column <= last; ++column) row_begin(row)[column] = value;
  }

  double left_, bottom_, cell_m_;
  std::int64_t columns_, rows_;
  std::vector<std::uint8_t> cells_;  // rows from the top, as images have them
};

bool is_outline(const Obstacle& obstacle) {
  return obstacle.shape_type == ShapeType::kClosedPolygon ||
         obstacle.shape_type == ShapeType::kClosedCurve;
}

// Outlines with the area that they enclose, the largest first: what lies within others comes later.
struct Outline {
  std::vector<Point> ring;
  double area_m2 = 0.0;  // negative: free within
  bool blocks = false;
};

std::vector<Outline> outlines_of(const Map& map, double above_m) {
  std::vector<Outline> outlines;
  for (const auto& obstacle : map.obstacles) {
    if (!is_outline(obstacle) || obstacle.segments.size() < 3) continue;
    auto ring = chain_points(obstacle);
    const double area = signed_area_m2(ring);
    outlines.push_back({std::move(ring), area, max_height_m(obstacle) > above_m});
  }
  std::stable_sort(outlines.begin(), outlines.end(), [](const auto& p, const auto& q) {
    return std::abs(p.area_m2) > std::abs(q.area_m2);
  });
  return outlines;
}

// Steps as lines, bottom-up or top-down as the map has them: runs of joined segments of one height.
std::vector<std::vector<Point>> step_lines(const Obstacle& stairs) {
  std::vector<std::vector<Point>> lines;
  const Segment* last = nullptr;
  for (const auto& s : stairs.segments) {
    const bool goes_on = last != nullptr && last->b == s.a && last->height_m == s.height_m;
    if (!goes_on) lines.push_back({s.a});
    lines.back().push_back(s.b);
    last = &s;
  }
  return lines;
}

// The robot cannot stand between steps: the strips from one to the next are filled.
void fill_stairs(const Obstacle& stairs, Grid& grid) {
  const auto lines = step_lines(stairs);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    std::vector<Point> strip = lines[i];
    std::vector<Point> next = lines[i + 1];
    const bool same_way = dot(strip.back() - strip.front(), next.back() - next.front()) > 0.0;
    if (same_way) std::reverse(next.begin(), next.end());
    strip.insert(strip.end(), next.begin(), next.end());
    grid.fill(strip, kOccupied);
    for (std::size_t k = 0; k < strip.size(); ++k) {
      grid.draw(strip[k], strip[k + 1 == strip.size() ? 0 : k + 1]);
    }
  }
}

void draw(const Map& map, double above_m, Grid& grid) {
  for (const auto& outline : outlines_of(map, above_m)) {
    if (!outline.blocks) continue;
    grid.fill(outline.ring, outline.area_m2 > 0.0 ? kUnknown : kFree);
  }
  for (const auto& obstacle : map.obstacles) {
    if (obstacle.shape_type == ShapeType::kStairs && above_m <= 0.0) fill_stairs(obstacle, grid);
    for (const auto& segment : obstacle.segments) {
      if (segment.height_m > above_m) grid.draw(segment.a, segment.b);
    }
  }
}

std::string yaml_text(const ExportJob& job) {
  const Border& border = job.map.border;
  return "image: \"" + job.stem +
         ".pgm\"\nmode: trinary\nresolution: " + shortest_decimal(job.grid.cell_m) + "\norigin: [" +
         shortest_decimal(border.left) + ", " + shortest_decimal(border.bottom) +
         ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

bool write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  return static_cast<bool>(out);
}

bool write_image(const std::string& path, const Grid& grid) {
  std::ofstream out(path, std::ios::binary);
  out << "P5\n" << grid.columns() << ' ' << grid.rows() << "\n255\n";
  out.write(reinterpret_cast<const char*>(grid.cells().data()),
            static_cast<std::streamsize>(grid.cells().size()));
  out.close();
  return static_cast<bool>(out);
}

Result<void> check(const ExportJob& job) {
  const Border& border = job.map.border;
  if (!(border.left < border.right && border.bottom < border.top)) {
    return usage_failure("the map's border spans no area: an occupancy grid has nothing to cover");
  }
  const double cells = border.area_m2() / (job.grid.cell_m * job.grid.cell_m);
  if (cells > kMostCells) {
    return usage_failure("the grid would have " + std::to_string(static_cast<std::int64_t>(cells)) +
                         " cells: --resolution must be coarser");
  }
  return {};
}

}  // namespace

Result<Exported> export_occupancy_grid(const ExportJob& job) {
  if (!job.crs.empty() && job.crs != "map") {
    return usage_failure("--crs: an occupancy grid is in metres of the map frame");
  }
  if (auto checked = check(job); !checked) return tl::unexpected(checked.error());
  Grid grid(job.map.border, job.grid.cell_m);
  draw(job.map, job.grid.above_m, grid);
  const std::string yaml = job.stem + ".yaml", image = job.stem + ".pgm";
  if (!write_text(job.folder + "/" + yaml, yaml_text(job))) {
    return output_failure(yaml + ": cannot be written to its end");
  }
  if (!write_image(job.folder + "/" + image, grid)) {
    return output_failure(image + ": cannot be written to its end");
  }
  return Exported{{yaml, image}, {}};
}

}  // namespace mapwright::converter
