#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "navcore/exact/barrier.hpp"

namespace mapwright::navcore::exact {
namespace {

// Holds the square of twice an area times the square of a distance, without overflow.
using Wide = boost::multiprecision::int256_t;

constexpr std::int64_t kNanometresPerMm = 1'000'000;

Wide square(std::int64_t value) {
  return Wide(value) * value;
}

bool is_nearer(GridPoint p, GridPoint q, std::int64_t limit_nm) {
  return Wide(squared_distance(p, q)) * square(kNanometresPerMm) < square(limit_nm);
}

// True if p is nearer to the line than the limit, or on it.
bool is_near(GridPoint p, const Line& line, std::int64_t limit_nm) {
  if (is_on_segment(p, line.a, line.b)) return true;
  if (dot_from(line.a, line.b, p) <= 0) return is_nearer(p, line.a, limit_nm);
  if (dot_from(line.b, line.a, p) <= 0) return is_nearer(p, line.b, limit_nm);
  return square(orient(line.a, line.b, p)) * square(kNanometresPerMm) <
         square(limit_nm) * squared_distance(line.a, line.b);
}

// True if q is within 1 mm, both along and across, of the point of the line nearest to p.
bool is_beside_foot(GridPoint q, GridPoint p, const Line& line) {
  if (dot_from(line.a, line.b, p) <= 0) return q == line.a;
  if (dot_from(line.b, line.a, p) <= 0) return q == line.b;
  const Wide along = Wide(dot_from(line.a, line.b, q)) - dot_from(line.a, line.b, p);
  return is_near(q, line, kNanometresPerMm + 1) &&
         along * along <= squared_distance(line.a, line.b);
}

// A point of one line, and beside its foot on the other one, nearer than the diameter.
bool is_narrow(GridPoint p, const Line& on, GridPoint q, const Line& other,
               std::int64_t radius_nm) {
  return is_on_segment(p, on.a, on.b) && is_near(p, other, 2 * radius_nm) &&
         is_beside_foot(q, p, other);
}

bool blocks(const Barrier& barrier, const BarrierLeg& leg, std::int64_t radius_nm) {
  if (leg.line_from >= barrier.lines.size() || leg.line_to >= barrier.lines.size()) return false;
  const Line &from = barrier.lines[leg.line_from], &to = barrier.lines[leg.line_to];
  if (!leg.is_gap()) return is_near(leg.from, from, radius_nm) && is_near(leg.to, from, radius_nm);
  return radius_nm > 2 * kNanometresPerMm &&  // more than rounding
         (is_narrow(leg.from, from, leg.to, to, radius_nm) ||
          is_narrow(leg.to, to, leg.from, from, radius_nm));
}

// A gap's leg may end up to 1.5 mm beside the true way across the gap; no place between the two.
bool is_clear_of_rounding(const BarrierLeg& leg, GridPoint p) {
  return !leg.is_gap() || !is_near(p, {leg.from, leg.to, 0}, 2 * kNanometresPerMm);
}

// Nothing where p lies on the polygon.
std::optional<int> winding_number(const std::vector<BarrierLeg>& polygon, GridPoint p) {
  int winding = 0;
  for (const BarrierLeg& leg : polygon) {
    if (is_on_segment(p, leg.from, leg.to)) return std::nullopt;
    const bool starts_below = leg.from.y <= p.y, ends_below = leg.to.y <= p.y;
    if (starts_below == ends_below) continue;
    const bool is_left = orient(leg.from, leg.to, p) > 0;
    if (starts_below && is_left) ++winding;
    if (!starts_below && !is_left) --winding;
  }
  return winding;
}

// A point of a grid so fine that its steps are smaller than the distance of any two things of the
// millimetre grid that do not touch.
struct FinePoint {
  Wide x, y;
};

FinePoint fine(GridPoint p) {
  const Wide steps = Wide(1) << 80;
  return {steps * p.x, steps * p.y};
}

Wide orient(const FinePoint& a, const FinePoint& b, const FinePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Around the point just off p along a direction. Nothing where that lies on the polygon.
std::optional<int> winding_number_off(const std::vector<BarrierLeg>& polygon, GridPoint p,
                                      Direction way) {
  FinePoint q = fine(p);
  q.x += way.x, q.y += way.y;
  int winding = 0;
  for (const BarrierLeg& leg : polygon) {
    const FinePoint from = fine(leg.from), to = fine(leg.to);
    const bool starts_below = from.y <= q.y, ends_below = to.y <= q.y;
    const bool is_level = from.y == q.y && to.y == q.y;
    if (is_level && (from.x <= q.x) != (to.x <= q.x)) return std::nullopt;
    if (starts_below == ends_below) continue;
    const Wide side = orient(from, to, q);
    if (side == 0) return std::nullopt;
    if (starts_below && side > 0) ++winding;
    if (!starts_below && side < 0) --winding;
  }
  return winding;
}

// Around an end, or around all points just off it.
std::vector<std::optional<int>> winding_numbers(const std::vector<BarrierLeg>& polygon,
                                                const BarrierEnd& end) {
  if (end.ways_off.empty()) return {winding_number(polygon, end.at)};
  std::vector<std::optional<int>> numbers;
  for (const Direction way : end.ways_off) {
    numbers.push_back(winding_number_off(polygon, end.at, way));
  }
  return numbers;
}

}  // namespace

bool separates(const Barrier& barrier, GridPoint start, GridPoint goal, std::int64_t radius_nm) {
  return separates_ways_off(barrier, {start, {}}, {goal, {}}, radius_nm);
}

bool separates_ways_off(const Barrier& barrier, const BarrierEnd& start, const BarrierEnd& goal,
                        std::int64_t radius_nm) {
  if (radius_nm > 0 && !(start.ways_off.empty() && goal.ways_off.empty())) return false;
  const auto& legs = barrier.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].to != legs[(i + 1) % legs.size()].from) return false;
    if (!blocks(barrier, legs[i], radius_nm)) return false;
    if (!is_clear_of_rounding(legs[i], start.at)) return false;
    if (!is_clear_of_rounding(legs[i], goal.at)) return false;
  }
  const auto around_goal = winding_numbers(legs, goal);
  for (const auto& p : winding_numbers(legs, start)) {
    for (const auto& q : around_goal) {
      if (!p || !q || *p == *q) return false;
    }
  }
  return true;
}

}  // namespace mapwright::navcore::exact
