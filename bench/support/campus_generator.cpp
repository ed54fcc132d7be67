#include "bench/support/campus_generator.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/random.hpp"

namespace mapwright::bench {
namespace {

// The square is cut into plots, a plot into 5 × 5 cells. A building takes 4 × 4 of them, everything
// else one; nothing reaches beyond 2.2 m from its cell's middle, so that a robot gets through.
constexpr double kPlot_m = 25.0;
constexpr int kCellsPerSide = 5;
constexpr double kCell_m = kPlot_m / kCellsPerSide;
constexpr int kBuildingCells = 4;
constexpr double kCellReach_m = 2.2;

double on_grid(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

/// A frame that things are drawn in: a middle, and a turn by quarters.
struct Frame {
  Point middle;
  int quarters = 0;

  Point turned(Point p) const {
    switch (quarters) {
      case 0:
        return p;
      case 1:
        return {-p.y, p.x};
      case 2:
        return {-p.x, -p.y};
      default:
        return {p.y, -p.x};
    }
  }
  Point at(Point p) const {
    const Point q = middle + turned(p);
    return {on_grid(q.x), on_grid(q.y)};
  }
};

/// The strings a campus repeats, shared by all its segments.
struct Labels {
  Semantic building{"building,campus"};
  Semantic column{"column,A5"};
  Semantic bench{"bench,A5"};
  Semantic wall{"wall,garden"};
  Semantic stairs{"step,square"};
  std::array<Semantic, 3> outside{Semantic("wall,orange,brick"), Semantic("wall,grey,cement"),
                                  Semantic("wall,glass")};
  Semantic cement{"wall,grey,cement"};
  Semantic metal{"fence,metal"};
};

class Campus {
 public:
  explicit Campus(const CampusOptions& options) : random_(options.seed) {
    map_.border = {0.0, options.side_m, options.side_m, 0.0};
  }

  /// Draws exactly `segments` segments into the plot with this lower left corner.
  void plot(Point corner, std::size_t segments);

  Map take() { return std::move(map_); }

 private:
  Obstacle& add(ShapeType shape_type, const Semantic& semantic);
  void chain(Obstacle& obstacle, const std::vector<Point>& points, double height_m,
             const Semantic& semantic);
  void building(Point middle, std::size_t corners);
  void rectangle(const Frame& frame, Point half, double height_m, const Semantic& what);
  void open_wall(const Frame& frame, std::size_t segments);
  void stairs(const Frame& frame, std::size_t segments);
  void ramp(const Frame& frame);
  std::size_t small_thing(const Frame& frame, std::size_t most);

  Random random_;
  Labels labels_;
  Map map_;
};

Obstacle& Campus::add(ShapeType shape_type, const Semantic& semantic) {
  const auto id = static_cast<std::int64_t>(map_.obstacles.size()) + 1;
  map_.obstacles.push_back({id, shape_type, semantic, {}});
  return map_.obstacles.back();
}

void Campus::chain(Obstacle& obstacle, const std::vector<Point>& points, double height_m,
                   const Semantic& semantic) {
  obstacle.segments.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    obstacle.segments.push_back({points[i], points[i + 1], height_m, InOut::kOutdoor, semantic});
  }
}

// Star-shaped, hence simple: corners at growing bearings, each at a distance of its own.
void Campus::building(Point middle, std::size_t corners) {
  const double start = random_.uniform(0.0, 2.0 * std::numbers::pi);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(corners);
  std::vector<Point> ring;
  for (std::size_t i = 0; i < corners; ++i) {
    const double bearing = start + step * (static_cast<double>(i) + random_.uniform(-0.25, 0.25));
    const Point outward = unit_vector(Angle::from_radians(bearing));
    ring.push_back(Frame{middle}.at(random_.uniform(6.0, 9.5) * outward));
  }
  ring.push_back(ring.front());
  chain(add(ShapeType::kClosedPolygon, labels_.building), ring,
        on_grid(3.0 * static_cast<double>(1 + random_.below(6))),
        labels_.outside[random_.below(3)]);
}

void Campus::rectangle(const Frame& frame, Point half, double height_m, const Semantic& what) {
  std::vector<Point> ring{frame.at({-half.x, -half.y}), frame.at({half.x, -half.y}),
                          frame.at({half.x, half.y}), frame.at({-half.x, half.y})};
  ring.push_back(ring.front());
  chain(add(ShapeType::kClosedPolygon, what), ring, height_m, labels_.cement);
}

// A zigzag across the cell: any number of segments, none meeting another but its neighbours.
void Campus::open_wall(const Frame& frame, std::size_t segments) {
  std::vector<Point> points;
  for (std::size_t i = 0; i <= segments; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(segments) - 0.5;
    const double across = (i % 2 == 0 ? -1.0 : 1.0) * random_.uniform(0.1, 0.5);
    points.push_back(frame.at({2.0 * kCellReach_m * along, across}));
  }
  chain(add(ShapeType::kOpenPolygon, labels_.wall), points, on_grid(random_.uniform(0.8, 2.5)),
        labels_.metal);
}

// The report's model: steps one behind the other, each higher by a riser, free space on the right
// of each; at the top one segment the other way round, of height 0.
void Campus::stairs(const Frame& frame, std::size_t segments) {
  constexpr double kHalfWidth_m = 2.0;
  constexpr double kTread_m = 0.3;
  constexpr double kRiser_m = 0.16;
  Obstacle& obstacle = add(ShapeType::kStairs, labels_.stairs);
  for (std::size_t i = 0; i < segments; ++i) {
    const double y = kTread_m * (static_cast<double>(i) - 0.5 * static_cast<double>(segments - 1));
    const Point left = frame.at({-kHalfWidth_m, y});
    const Point right = frame.at({kHalfWidth_m, y});
    const bool is_top = i + 1 == segments;
    obstacle.segments.push_back({is_top ? right : left, is_top ? left : right,
                                 is_top ? 0.0 : on_grid(kRiser_m * static_cast<double>(i + 1)),
                                 InOut::kOutdoor, labels_.cement});
  }
}

void Campus::ramp(const Frame& frame) {
  const double slope = random_.uniform(0.04, 0.12);
  const double length = std::hypot(slope, 1.0);
  const Point uphill = frame.turned({0.0, 1.0});
  const Normal normal{-slope / length * uphill.x, -slope / length * uphill.y, 1.0 / length};
  rectangle(frame, {1.0, 2.0}, 0.0, labels_.cement);
  Obstacle& obstacle = map_.obstacles.back();
  obstacle.shape_type = ShapeType::kRamp;
  obstacle.semantic = Semantic("ramp").with_value(semantic_key::kNormal, format_normal(normal));
}

// Returns how many segments it took, at most `most`.
std::size_t Campus::small_thing(const Frame& frame, std::size_t most) {
  constexpr std::size_t kRing = 4;
  const auto what = random_.below(20);
  if (most < kRing || what < 3) {
    const std::size_t segments = std::min<std::size_t>(most, 1 + random_.below(5));
    open_wall(frame, segments);
    return segments;
  }
  if (what == 3 && most >= 6) {
    const std::size_t segments = std::min<std::size_t>(most, 6 + random_.below(7));
    stairs(frame, segments);
    return segments;
  }
  if (what == 4) {
    ramp(frame);
  } else if (what < 12) {
    const double half = random_.uniform(0.2, 0.75);
    rectangle(frame, {half, half}, 5.0, labels_.column);
  } else {
    rectangle(frame, {random_.uniform(0.6, 2.0), 0.25}, 0.5, labels_.bench);
  }
  return kRing;
}

void Campus::plot(Point corner, std::size_t segments) {
  const bool has_building = segments >= 12 && random_.below(10) < 7;
  if (has_building) {
    constexpr double kMiddle_m = 0.5 * kBuildingCells * kCell_m;
    const std::size_t corners = 4 + random_.below(9);
    building(corner + Point{kMiddle_m, kMiddle_m}, corners);
    segments -= corners;
  }
  std::vector<Frame> cells;
  for (int i = 0; i < kCellsPerSide * kCellsPerSide; ++i) {
    const int column = i % kCellsPerSide;
    const int row = i / kCellsPerSide;
    if (has_building && column < kBuildingCells && row < kBuildingCells) continue;
    cells.push_back(
        {corner + kCell_m * Point{column + 0.5, row + 0.5}, static_cast<int>(random_.below(4))});
  }
  while (segments > 0) {
    std::swap(cells[random_.below(cells.size())], cells.back());
    const bool is_last = cells.size() == 1;
    if (is_last) open_wall(cells.back(), segments);
    segments -= is_last ? segments : small_thing(cells.back(), segments);
    cells.pop_back();
  }
}

}  // namespace

Map generate_campus(const CampusOptions& options) {
  const auto plots_per_side = static_cast<std::size_t>(options.side_m / kPlot_m);
  assert(plots_per_side > 0);
  const std::size_t plots = plots_per_side * plots_per_side;
  Campus campus(options);
  for (std::size_t i = 0; i < plots; ++i) {
    const Point corner{kPlot_m * static_cast<double>(i % plots_per_side),
                       kPlot_m * static_cast<double>(i / plots_per_side)};
    campus.plot(corner, options.segments * (i + 1) / plots - options.segments * i / plots);
  }
  return campus.take();
}

}  // namespace mapwright::bench
