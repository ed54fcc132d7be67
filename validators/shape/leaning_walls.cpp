#include "validators/shape/leaning_walls.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

struct Contact {
  std::uint32_t wall, ring;
};

// Open walls and the rings that their boxes meet, by wall.
std::vector<Contact> contacts_of(const CheckContext& context) {
  const auto& obstacles = context.map().obstacles;
  const auto is_wall = [&](std::size_t i) { return is_open_chain(obstacles[i].shape_type); };
  const auto is_ring = [&](std::size_t i) {
    return context.outlines()[i].is_ring && obstacles[i].shape_type != ShapeType::kRamp;
  };
  std::vector<Contact> contacts;
  for (const auto [first, second] : context.meeting_pairs()) {
    if (is_wall(first) && is_ring(second)) contacts.push_back({first, second});
    if (is_wall(second) && is_ring(first)) contacts.push_back({second, first});
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact& p, const Contact& q) {
    return std::tie(p.wall, p.ring) < std::tie(q.wall, q.ring);
  });
  return contacts;
}

// What a wall segment lies on: with edges that run its way, or against it.
struct Support {
  bool along = false;
  bool against = false;
  std::string name;  // of what runs against it

  void add(const Segment& segment, Point a, Point b, const std::string& edge_name) {
    if (meet(segment.a, segment.b, a, b).kind != Meeting::kOverlap) return;
    if (dot(segment.b - segment.a, b - a) > 0.0) {
      along = true;
    } else if (!against) {
      against = true;
      name = edge_name;
    }
  }
};

Box box_of(const Segment& segment) {
  Box box = kEmptyBox;
  box.add(segment.a);
  box.add(segment.b);
  return box;
}

void add_outline(Support& support, const Segment& segment, const EdgeFinder& edges) {
  edges.visit(box_of(segment), [&](std::uint32_t e) {
    const Segment& edge = edges.obstacle().segments[e];
    support.add(segment, edge.a, edge.b, name_of(edges.obstacle()));
  });
}

// The border as a room seen from inside: clockwise.
void add_border(Support& support, const Segment& segment, const Border& border) {
  const std::array<Point, 4> corners{{{border.left, border.top},
                                      {border.right, border.top},
                                      {border.right, border.bottom},
                                      {border.left, border.bottom}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    support.add(segment, corners[i], corners[(i + 1) % corners.size()], "the border");
  }
}

bool touches_border(const Box& box, const Border& border) {
  return !box.is_empty() && (box.min_x <= border.left || box.max_x >= border.right ||
                             box.min_y <= border.bottom || box.max_y >= border.top);
}

using Rings = std::vector<std::uint32_t>;

void check_wall(const CheckContext& context, std::size_t wall, const Rings& rings, bool on_border,
                FindingSink& sink) {
  const Obstacle& obstacle = context.map().obstacles[wall];
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const Segment& segment = obstacle.segments[k];
    if (segment.a == segment.b) continue;
    Support support;
    for (const auto ring : rings) add_outline(support, segment, context.edges(ring));
    if (on_border) add_border(support, segment, context.map().border);
    if (!support.against || support.along) continue;
    sink.segment(FindingCode::G107, wall, k,
                 name_of(obstacle, k) + " leans on " + support.name +
                     " but has its free side towards it; swap its ends");
  }
}

}  // namespace

void check_leaning_walls(const CheckContext& context, FindingSink& sink) {
  const auto contacts = contacts_of(context);
  const auto& obstacles = context.map().obstacles;
  auto contact = contacts.begin();
  for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
    Rings rings;
    for (; contact != contacts.end() && contact->wall == i; ++contact)
      rings.push_back(contact->ring);
    if (!is_open_chain(obstacles[i].shape_type)) continue;
    const bool on_border = context.has_usable_border() &&
                           touches_border(context.outlines()[i].box, context.map().border);
    if (on_border || !rings.empty()) check_wall(context, i, rings, on_border, sink);
  }
}

}  // namespace mapwright::validators
