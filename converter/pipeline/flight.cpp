#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "converter/pipeline/stairs.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

constexpr double kLeastTread_m = 0.10;  // nearer risers share a tread (fans, split risers)
constexpr double kMostTread_m = 0.60;   // farther ones have a landing between them

Point middle(const Step& step) {
  return 0.5 * (step.line.front() + step.line.back());
}

Point along(const Step& step) {
  return step.line.back() - step.line.front();
}

// By number where all have one, else by height; equal ones keep the order they were drawn in.
void bring_into_order(std::vector<Step>& steps) {
  const bool numbered = std::all_of(steps.begin(), steps.end(),
                                    [](const Step& step) { return step.step_no.has_value(); });
  // Steps of one height lie side by side: their place decides, because formats with a spatial index
  // hand them over in an order of its own.
  std::stable_sort(steps.begin(), steps.end(), [&](const Step& p, const Step& q) {
    if (numbered && *p.step_no != *q.step_no) return *p.step_no < *q.step_no;
    if (p.height_m != q.height_m || p.height_m <= 0.0) return p.height_m < q.height_m;
    const Point a = p.line.front(), b = q.line.front();
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  });
}

// Heights that are not given follow from the riser below.
void fill_in_heights(std::vector<Step>& steps, double default_rise_m) {
  double below = 0.0;
  for (auto& step : steps) {
    if (step.height_m <= 0.0)
      step.height_m = below + (step.rise_m > 0.0 ? step.rise_m : default_rise_m);
    below = step.height_m;
  }
}

// Positive if the higher risers lie on the left of this one, weighed by how far.
double uphill_on_left(const Step& step, const std::vector<Step>& steps) {
  double sum = 0.0;
  for (const auto& other : steps) {
    const double side = cross(along(step), middle(other) - step.line.front());
    if (other.height_m > step.height_m) sum += side;
    if (other.height_m < step.height_m) sum -= side;
  }
  return sum;
}

void orient(std::vector<Step>& steps, Workspace& workspace) {
  const auto drawn = steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (uphill_on_left(drawn[i], drawn) >= 0.0) continue;
    std::reverse(steps[i].line.begin(), steps[i].line.end());
    workspace.ledger.change(steps[i].account, FindingCode::C222,
                            "the step was drawn with lower ground on its left and was turned");
  }
}

// Left normal of the risers, longer ones counting more: up the stairs.
Point uphill(const std::vector<Step>& steps) {
  Point sum;
  for (const auto& step : steps) sum = sum + along(step);
  const double norm = length(sum);
  return norm > 0.0 ? (1.0 / norm) * Point{-sum.y, sum.x} : Point{0.0, 1.0};
}

// The middle one of the distances between risers that follow each other, landings left out.
double usual_tread_m(const std::vector<Step>& steps, Point up, double fallback_m) {
  std::vector<double> treads;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const double tread = dot(middle(steps[i + 1]) - middle(steps[i]), up);
    if (tread >= kLeastTread_m && tread <= kMostTread_m) treads.push_back(tread);
  }
  if (treads.empty()) return fallback_m;
  std::sort(treads.begin(), treads.end());
  return treads[treads.size() / 2];
}

// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Point> hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point p, Point q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); });
  std::vector<Point> hull;
  const auto add_chain = [&](auto from, auto to) {
    const std::size_t floor = hull.size() + 1;
    for (auto it = from; it != to; ++it) {
      while (hull.size() > floor && turn(hull[hull.size() - 2], hull.back(), *it) != Turn::kLeft)
        hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

// Direction of the longest edge of the hull that faces up the stairs, seen with the hull on the
// right hand; of a plain flight that is the last riser.
Point top_edge_direction(const std::vector<Point>& hull, Point up) {
  constexpr double kFacing = 0.5;  // cosine: within 60 degrees of straight up
  Point longest{up.y, -up.x};
  double longest_m = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point edge = hull[i + 1 == hull.size() ? 0 : i + 1] - hull[i];
    const double edge_m = length(edge);
    if (edge_m <= longest_m || dot({edge.y, -edge.x}, up) < kFacing * edge_m) continue;
    longest_m = edge_m;
    longest = (-1.0 / edge_m) * edge;
  }
  return longest;
}

Segment closing_segment(const std::vector<Step>& steps, Workspace& workspace) {
  std::vector<Point> points;
  for (const auto& step : steps) points.insert(points.end(), step.line.begin(), step.line.end());
  const Point overall_up = uphill(steps);
  const Point right = top_edge_direction(hull_of(points), overall_up);
  const Point up{-right.y, right.x};
  double foremost = -std::numeric_limits<double>::infinity();
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();
  for (const Point p : points) {
    foremost = std::max(foremost, dot(p, up));
    from = std::min(from, dot(p, right));
    to = std::max(to, dot(p, right));
  }
  const double level = foremost + usual_tread_m(steps, overall_up, workspace.settings.tread_m);
  const auto& style = steps.back().style;
  return {workspace.snapped(to * right + level * up), workspace.snapped(from * right + level * up),
          0.0, style.in_out, style.semantic};
}

}  // namespace

std::vector<Segment> flight_segments(std::vector<Step> steps, Workspace& workspace) {
  bring_into_order(steps);
  fill_in_heights(steps, workspace.settings.rise_m);
  orient(steps, workspace);
  std::vector<Segment> segments;
  for (auto& step : steps) {
    step.style.height_m = step.height_m;
    for (auto& segment : chain_of(step.line, false, step.style))
      segments.push_back(std::move(segment));
  }
  segments.push_back(closing_segment(steps, workspace));
  return segments;
}

}  // namespace mapwright::converter
