#include "converter/source/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mapwright::converter {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

struct Circle {
  Point center;
  double radius = 0.0;
};

// Circumscribed circle; a radius of 0 where the points lie on a line.
Circle circle_through(Point a, Point b, Point c) {
  if (a == c) return {0.5 * (a + b), 0.5 * distance(a, b)};
  const Point ab = b - a;
  const Point ac = c - a;
  const double twice_area = cross(ab, ac);
  if (std::abs(twice_area) <= 1e-12 * length(ab) * length(ac)) return {};
  const double ab2 = squared_length(ab);
  const double ac2 = squared_length(ac);
  const Point offset{(ac.y * ab2 - ab.y * ac2) / (2.0 * twice_area),
                     (ab.x * ac2 - ac.x * ab2) / (2.0 * twice_area)};
  return {a + offset, length(offset)};
}

double angle_of(Point p, Point center) {
  return std::atan2(p.y - center.y, p.x - center.x);
}

// Angle swept from `from` to `to`, in (0, 2π) for counter-clockwise and (−2π, 0) for clockwise.
double sweep(double from, double to, bool counter_clockwise) {
  double swept = std::fmod(to - from, kFullTurn);
  if (counter_clockwise && swept <= 0.0) swept += kFullTurn;
  if (!counter_clockwise && swept >= 0.0) swept -= kFullTurn;
  return swept;
}

// A chord over the angle t has the sagitta r (1 − cos(t / 2)).
double widest_step(double radius, double sagitta) {
  const double cosine = 1.0 - sagitta / radius;
  return cosine <= 0.0 ? std::numbers::pi / 2.0 : 2.0 * std::acos(cosine);
}

void append_half(const Circle& circle, double from, double swept, Point end, double sagitta,
                 std::vector<Point>& points) {
  const double step = std::min(widest_step(circle.radius, sagitta), std::numbers::pi / 4.0);
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(swept) / step - 1e-9)));
  for (int i = 1; i < pieces; ++i) {
    const double angle = from + swept * i / pieces;
    points.push_back(circle.center + circle.radius * Point{std::cos(angle), std::sin(angle)});
  }
  points.push_back(end);
}

}  // namespace

void append_arc(Point a, Point b, Point c, double sagitta, std::vector<Point>& points) {
  const Circle circle = circle_through(a, b, c);
  if (!(circle.radius > 0.0) || !std::isfinite(circle.radius)) {
    points.push_back(b);
    if (c != b) points.push_back(c);
    return;
  }
  const bool counter_clockwise = a == c || cross(b - a, c - a) > 0.0;
  const double at_a = angle_of(a, circle.center);
  const double at_b = angle_of(b, circle.center);
  append_half(circle, at_a, sweep(at_a, at_b, counter_clockwise), b, sagitta, points);
  append_half(circle, at_b, sweep(at_b, angle_of(c, circle.center), counter_clockwise), c, sagitta,
              points);
}

}  // namespace mapwright::converter
