// What a root sees through a side of a cell, and where that leads.
#include <algorithm>

#include "navcore/exact/path_search_run.hpp"

namespace mapwright::navcore::exact {
namespace {

Point to_point(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

double straight(Point p, Point q) {
  const Point d = q - p;
  return std::sqrt(d.x * d.x + d.y * d.y);
}

Point reflected(Point p, Point a, Point b) {
  const Point along = b - a;
  const Point normal{-along.y, along.x};
  return p - (2.0 * dot(normal, p - a) / squared_length(normal)) * normal;
}

}  // namespace

void PathSearch::find_successors(const Node& node) {
  const std::uint32_t cell = mesh_.cell_of(node.corner);
  if (space_.goal_search_[cell] == space_.search_ && mesh_.contains(cell, goal_)) {
    reach_goal(node);
    return;
  }
  const Chain chain = chain_behind(node.corner);
  const GridPoint root = space_.roots_[node.root].point;
  if (root == at(node.corner).point || root == at(chain.corner(0)).point) {
    see_all(node, chain);
  } else {
    see_cone(node, chain);
  }
}

// The root is a corner of the cell.
void PathSearch::see_all(const Node& node, const Chain& chain) {
  for (std::uint32_t s = 0; s < chain.sides; ++s) look_through(node.root, chain.corner(s));
}

void PathSearch::see_cone(const Node& node, const Chain& chain) {
  const Sight right = right_sight(node, chain), left = left_sight(node, chain);
  if (node.right_is_end && right.hides_any) turn_right(node, chain, right);
  for (std::uint32_t s = right.bound; s < left.bound; ++s) {
    see_side(node, chain.corner(s), s > right.bound || right.at_end,
             s + 1 < left.bound || left.at_end);
  }
  if (node.left_is_end && left.hides_any) turn_left(node, chain, left);
}

// The right ray leaves the cell through the first side that is not to the right of it.
PathSearch::Sight PathSearch::right_sight(const Node& node, const Chain& chain) const {
  std::uint32_t k = 1;
  std::int64_t side = node.right.side_of(at(chain.corner(1)).point);
  while (side < 0) side = node.right.side_of(at(chain.corner(++k)).point);
  if (side == 0) return {k, true, true};
  const bool follows_corner = k == 1 && node.right_is_end;
  return {k - 1, follows_corner, !follows_corner};
}

PathSearch::Sight PathSearch::left_sight(const Node& node, const Chain& chain) const {
  std::uint32_t m = chain.sides - 1;
  std::int64_t side = node.left.side_of(at(chain.corner(m)).point);
  while (side > 0) side = node.left.side_of(at(chain.corner(--m)).point);
  if (side == 0) return {m, true, true};
  const bool follows_corner = m == chain.sides - 1 && node.left_is_end;
  return {m + 1, follows_corner, !follows_corner};
}

// The root sees the side from its right end, or from where the right ray meets it, to its left end,
// or to where the left ray does.
void PathSearch::see_side(const Node& node, std::uint32_t corner, bool right_is_end,
                          bool left_is_end) {
  if (!may_enter(corner)) return;
  const GridPoint root = space_.roots_[node.root].point;
  const GridPoint p = at(corner).point, q = after(corner).point;
  if (orient(root, p, q) == 0) return look_along(node.root, corner);
  Node next = node;
  next.corner = at(corner).twin;
  next.right_is_end = right_is_end;
  next.left_is_end = left_is_end;
  if (right_is_end) next.right = {root, p};
  if (left_is_end) next.left = {root, q};
  next.right_end = right_is_end ? to_point(p) : meet(node.right, p, q);
  next.left_end = left_is_end ? to_point(q) : meet(node.left, p, q);
  add(next);
}

// Sides that the root does not see are seen from the right end of the entered side: those before
// the right ray, and the part of a side that the ray cuts.
void PathSearch::turn_right(const Node& node, const Chain& chain, const Sight& sight) {
  const GridPoint apex = at(chain.corner(0)).point;
  const auto pivot = turn_at(node.root, chain.corner(0));
  if (!pivot) return;
  for (std::uint32_t s = 0; s < sight.bound; ++s) look_through(*pivot, chain.corner(s));
  const std::uint32_t cut = chain.corner(sight.bound);
  if (sight.at_end || !may_enter(cut)) return;
  const GridPoint p = at(cut).point, q = after(cut).point;
  add({*pivot,
       at(cut).twin,
       node.right,
       {apex, p},
       false,
       true,
       meet(node.right, p, q),
       to_point(p),
       0.0});
}

// The mirror image, from the left end of the entered side.
void PathSearch::turn_left(const Node& node, const Chain& chain, const Sight& sight) {
  const GridPoint apex = at(static_cast<std::uint32_t>(node.corner)).point;
  const auto pivot = turn_at(node.root, static_cast<std::uint32_t>(node.corner));
  if (!pivot) return;
  for (std::uint32_t s = sight.bound; s < chain.sides; ++s) look_through(*pivot, chain.corner(s));
  if (sight.at_end) return;
  const std::uint32_t cut = chain.corner(sight.bound - 1);
  if (!may_enter(cut)) return;
  const GridPoint p = at(cut).point, q = after(cut).point;
  add({*pivot,
       at(cut).twin,
       {apex, q},
       node.left,
       true,
       false,
       to_point(q),
       meet(node.left, p, q),
       0.0});
}

// The root sees the whole side.
void PathSearch::look_through(std::uint32_t root, std::uint32_t corner) {
  if (!may_enter(corner)) return;
  const GridPoint apex = space_.roots_[root].point;
  const GridPoint p = at(corner).point, q = after(corner).point;
  if (apex != p && apex != q && orient(apex, p, q) == 0) {
    look_along(root, corner);
    return;
  }
  add({root, at(corner).twin, {apex, q}, {apex, p}, true, true, to_point(q), to_point(p), 0.0});
}

// The side lies on a line with the root: the path passes its nearer end and can turn there.
void PathSearch::look_along(std::uint32_t root, std::uint32_t corner) {
  const GridPoint apex = space_.roots_[root].point;
  const auto next = static_cast<std::uint32_t>(&after(corner) - corners_.data());
  const bool start_is_nearer =
      squared_distance(apex, at(corner).point) < squared_distance(apex, at(next).point);
  const auto pivot = turn_at(root, start_is_nearer ? corner : next);
  if (pivot) look_through(*pivot, corner);
}

void PathSearch::reach_goal(const Node& node) {
  const GridPoint root = space_.roots_[node.root].point;
  const auto left = static_cast<std::uint32_t>(node.corner);
  const auto right = static_cast<std::uint32_t>(&after(left) - corners_.data());
  if (root == at(left).point || root == at(right).point) return finish(node.root);
  if (node.left.side_of(goal_) > 0) {
    const auto pivot = node.left_is_end ? turn_at(node.root, left) : std::nullopt;
    if (pivot) finish(*pivot);
    return;
  }
  if (node.right.side_of(goal_) < 0) {
    const auto pivot = node.right_is_end ? turn_at(node.root, right) : std::nullopt;
    if (pivot) finish(*pivot);
    return;
  }
  finish(node.root);
}

void PathSearch::add(Node node) {
  node.f_mm = space_.roots_[node.root].g_mm + estimate(node);
  space_.successors_.push_back(node);
}

bool PathSearch::may_enter(std::uint32_t corner) const {
  const std::int32_t twin = at(corner).twin;
  if (twin < 0) return false;
  const std::uint32_t next = mesh_.cell_of(twin);
  return mesh_.way_out(next) != mesh_.cell_of(static_cast<std::int32_t>(corner)) ||
         space_.goal_search_[next] == space_.search_;
}

// Length of the shortest way from the root through the view to the goal, if nothing stood between:
// never more than what the walls leave.
double PathSearch::estimate(const Node& node) const {
  const auto left_corner = static_cast<std::uint32_t>(node.corner);
  const GridPoint a = at(left_corner).point, b = after(left_corner).point;
  const Point root = to_point(space_.roots_[node.root].point);
  Point goal = to_point(goal_);
  if (orient(a, b, goal_) < 0) goal = reflected(goal, to_point(a), to_point(b));
  if (cross(node.left_end - root, goal - root) > 0.0) {
    return straight(root, node.left_end) + straight(node.left_end, goal);
  }
  if (cross(node.right_end - root, goal - root) < 0.0) {
    return straight(root, node.right_end) + straight(node.right_end, goal);
  }
  return straight(root, goal);
}

Point PathSearch::meet(const Ray& ray, GridPoint p, GridPoint q) const {
  const auto side_p = static_cast<double>(ray.side_of(p));
  const auto side_q = static_cast<double>(ray.side_of(q));
  const double t = std::clamp(side_p / (side_p - side_q), 0.0, 1.0);
  return to_point(p) + t * (to_point(q) - to_point(p));
}

PathSearch::Chain PathSearch::chain_behind(std::int32_t corner) const {
  const std::uint32_t cell = mesh_.cell_of(corner);
  const std::uint32_t first = mesh_.first_corner(cell), end = mesh_.end_corner(cell);
  std::uint32_t offset = static_cast<std::uint32_t>(corner) - first + 1;
  if (offset == end - first) offset = 0;
  return {first, end, offset, end - first - 1};
}

const Corner& PathSearch::after(std::uint32_t corner) const {
  const std::uint32_t cell = mesh_.cell_of(static_cast<std::int32_t>(corner));
  return corners_[corner + 1 < mesh_.end_corner(cell) ? corner + 1 : mesh_.first_corner(cell)];
}

}  // namespace mapwright::navcore::exact
