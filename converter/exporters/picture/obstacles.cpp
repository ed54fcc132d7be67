#include "converter/exporters/picture/obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::converter {
namespace {

constexpr double kLeastTickedLength_pt = 7.0;
constexpr double kTickDistance_pt = 42.0;
constexpr double kTickLength_pt = 2.8;
constexpr double kLeastArrow_pt = 7.0;

Stroke line_of(const Shape& shape, const View& view) {
  const auto& style = kind_style(shape.kind);
  return {style.line, style.width_pt * view.line_scale()};
}

void fill_shape(Canvas& canvas, const Shape& shape) {
  const Colour colour = fill_colour(*shape.obstacle, shape.kind);
  if (colour.opacity == 0.0) return;
  for (const auto& ring : shape.rings) canvas.add_path(ring, true);
  canvas.fill(colour);
}

// True where the segment begins at the end of the one before, so that both make one line.
bool continues(const std::vector<Segment>& segments, std::size_t i) {
  return i > 0 && segments[i - 1].b == segments[i].a &&
         segments[i - 1].in_out == segments[i].in_out;
}

bool is_one_ring(const Obstacle& obstacle) {
  const auto& segments = obstacle.segments;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    if (!continues(segments, i)) return false;
  }
  return segments.size() > 2 && segments.back().b == segments.front().a;
}

void add_runs(Canvas& canvas, const View& view, const Obstacle& obstacle, InOut in_out) {
  const auto& segments = obstacle.segments;
  std::vector<Point> run;
  for (std::size_t i = 0; i <= segments.size(); ++i) {
    if (i == segments.size() || !continues(segments, i)) {
      canvas.add_path(run, false);
      run.clear();
    }
    if (i == segments.size() || segments[i].in_out != in_out) continue;
    if (run.empty()) run.push_back(view.to_page(segments[i].a));
    run.push_back(view.to_page(segments[i].b));
  }
}

void stroke_segments(Canvas& canvas, const View& view, const Shape& shape) {
  Stroke stroke = line_of(shape, view);
  const Obstacle& obstacle = *shape.obstacle;
  if (is_one_ring(obstacle) && obstacle.segments.front().in_out == InOut::kOutdoor) {
    canvas.add_path(shape.rings.front(), true);
    canvas.stroke(stroke);
    return;
  }
  add_runs(canvas, view, obstacle, InOut::kOutdoor);
  canvas.stroke(stroke);
  add_runs(canvas, view, obstacle, InOut::kIndoor);
  stroke.dash_pt = {3.0 * view.line_scale(), 1.5 * view.line_scale()};
  canvas.stroke(stroke);
}

std::optional<Point> uphill_of_ramp(const Obstacle& ramp) {
  const auto normal = ramp_normal(ramp);
  if (!normal || std::hypot(normal->x, normal->y) == 0.0) return std::nullopt;
  return Point{-normal->x, -normal->y};
}

Point middle(const Segment& segment) {
  return 0.5 * (segment.a + segment.b);
}

// From the lowest step towards the highest; both orders of the report's print are met.
std::optional<Point> uphill_of_stairs(const Obstacle& stairs) {
  const auto is_step = [](const Segment& s) { return s.height_m > 0.0; };
  const auto lower = [](const Segment& s, const Segment& t) { return s.height_m < t.height_m; };
  std::vector<Segment> steps;
  std::copy_if(stairs.segments.begin(), stairs.segments.end(), std::back_inserter(steps), is_step);
  if (steps.size() < 2) return std::nullopt;
  const auto [foot, top] = std::minmax_element(steps.begin(), steps.end(), lower);
  return middle(*top) - middle(*foot);
}

// How far one can go from `centre` along the unit vector and against it before meeting the ring.
double free_reach(const std::vector<Point>& ring, Point centre, Point direction) {
  double reach = HUGE_VAL;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - centre;
    const Point b = ring[(i + 1) % ring.size()] - centre;
    const double side_a = cross(direction, a);
    const double side_b = cross(direction, b);
    if ((side_a <= 0.0) == (side_b <= 0.0)) continue;
    const Point crossing = a + (side_a / (side_a - side_b)) * (b - a);
    reach = std::min(reach, std::abs(dot(crossing, direction)));
  }
  return reach;
}

// Along `uphill` through the middle of the shape, within it.
void draw_uphill_arrow(Canvas& canvas, const View& view, const Shape& shape, Point uphill) {
  const double size = length(uphill);
  if (size == 0.0 || !std::isfinite(size)) return;
  const Point direction = (1.0 / size) * Point{uphill.x, -uphill.y};  // the page's y runs down
  const Point across{-direction.y, direction.x};
  const auto& ring = shape.rings.front();
  Point centre;
  for (const Point p : ring) centre = centre + (1.0 / static_cast<double>(ring.size())) * p;
  const double reach = 0.72 * free_reach(ring, centre, direction);
  const double room = free_reach(ring, centre, across);
  if (!std::isfinite(reach) || 2.0 * reach < kLeastArrow_pt || room < kLeastArrow_pt / 3) return;
  draw_arrow(canvas, centre - reach * direction, centre + reach * direction,
             {kind_style(shape.kind).line, 0.8 * view.line_scale()});
}

void draw_slope(Canvas& canvas, const View& view, const Shape& shape) {
  if (shape.rings.front().empty()) return;
  std::optional<Point> uphill;
  if (shape.kind == ObstacleKind::kRamp) uphill = uphill_of_ramp(*shape.obstacle);
  if (shape.kind == ObstacleKind::kStairs) uphill = uphill_of_stairs(*shape.obstacle);
  if (uphill) draw_uphill_arrow(canvas, view, shape, *uphill);
}

void add_tick(Canvas& canvas, Point a, Point b, double at, double tick_pt) {
  const Point along = (1.0 / distance(a, b)) * (b - a);
  const Point foot = a + at * along;
  canvas.add_line(foot,
                  foot + tick_pt * Point{-along.y, along.x});  // right; the page's y runs down
}

// Even distances within a long segment; along a curve one wherever the chords have added up to
// that.
class Ticks {
 public:
  Ticks(Canvas& canvas, double tick_pt) : canvas_(canvas), tick_pt_(tick_pt) {}

  void begin_chain() { passed_pt_ = kTickDistance_pt / 2; }

  void add(Point a, Point b) {
    const double size = distance(a, b);
    if (size < kLeastTickedLength_pt) {
      add_on_chord(a, b, size);
      return;
    }
    const int count = std::max(1, static_cast<int>(size / kTickDistance_pt));
    for (int i = 0; i < count; ++i) add_tick(canvas_, a, b, (i + 0.5) * size / count, tick_pt_);
    passed_pt_ = 0.0;
  }

 private:
  void add_on_chord(Point a, Point b, double size) {
    passed_pt_ += size;
    if (passed_pt_ < kTickDistance_pt || size == 0.0) return;
    add_tick(canvas_, a, b, size / 2, tick_pt_);
    passed_pt_ = 0.0;
  }

  Canvas& canvas_;
  double tick_pt_;
  double passed_pt_ = 0.0;
};

}  // namespace

void draw_arrow(Canvas& canvas, Point from, Point to, const Stroke& stroke) {
  const double size = distance(from, to);
  const Point along = (1.0 / size) * (to - from);
  const Point across{-along.y, along.x};
  const double head = std::min(5.0, 0.5 * size);
  canvas.add_line(from, to);
  const std::vector<Point> barbs{to - head * along + 0.5 * head * across, to,
                                 to - head * along - 0.5 * head * across};
  canvas.add_path(barbs, false);
  canvas.stroke(stroke);
}

void draw_shapes(Canvas& canvas, const View& view, const std::vector<Shape>& shapes,
                 RampFill ramps) {
  for (const auto& shape : shapes) {
    const bool open = shape.kind == ObstacleKind::kRamp && ramps == RampFill::kNone;
    if (!open) fill_shape(canvas, shape);
    stroke_segments(canvas, view, shape);
    draw_slope(canvas, view, shape);
  }
}

void draw_orientation_ticks(Canvas& canvas, const View& view, const std::vector<Shape>& shapes) {
  Ticks ticks(canvas, kTickLength_pt * view.line_scale());
  for (const auto& shape : shapes) {
    if (shape.kind == ObstacleKind::kRamp) continue;
    ticks.begin_chain();
    for (const auto& segment : shape.obstacle->segments) {
      ticks.add(view.to_page(segment.a), view.to_page(segment.b));
    }
    canvas.stroke({kind_style(shape.kind).line, 0.6 * view.line_scale()});
  }
}

}  // namespace mapwright::converter
