#include "validators/shape/leaning_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
    return context.outline(i).is_ring && obstacles[i].shape_type != ShapeType::kRamp;
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

// How much of a wall segment lies on edges that run its way, and on edges that run against it.
class Support {
 public:
  explicit Support(const Segment& segment)
      : segment_(segment), length_m_(distance(segment.a, segment.b)) {}

  void add(Point a, Point b, const std::string& edge_name) {
    if (meet(segment_.a, segment_.b, a, b).kind != Meeting::kOverlap) return;
    const double from = position(a), to = position(b);
    const double overlap_m =
        std::abs(std::clamp(to, 0.0, length_m_) - std::clamp(from, 0.0, length_m_));
    if (to > from) {
      along_m_ += overlap_m;
    } else {
      against_m_ += overlap_m;
      if (name_.empty()) name_ = edge_name;
    }
  }

  // A wall that is longer than the edges is no wall that leans on an outline: the other one leans
  // on it, as a bin on a house wall.
  bool faces_away() const {
    constexpr double kNearlyAll = 1.0 - 1e-9;
    return along_m_ == 0.0 && against_m_ >= kNearlyAll * length_m_;
  }

  const std::string& name() const { return name_; }

 private:
  double position(Point p) const {
    return dot(p - segment_.a, segment_.b - segment_.a) / length_m_;
  }

  const Segment& segment_;
  double length_m_;
  double along_m_ = 0.0, against_m_ = 0.0;
  std::string name_;  // of what runs against it
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
    support.add(edge.a, edge.b, name_of(edges.obstacle()));
  });
}

// The border as a room seen from inside: clockwise.
void add_border(Support& support, const Border& border) {
  const std::array<Point, 4> corners{{{border.left, border.top},
                                      {border.right, border.top},
                                      {border.right, border.bottom},
                                      {border.left, border.bottom}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    support.add(corners[i], corners[(i + 1) % corners.size()], "the border");
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
    Support support(segment);
    for (const auto ring : rings) add_outline(support, segment, context.edges(ring));
    if (on_border) add_border(support, context.map().border);
    if (!support.faces_away()) continue;
    sink.segment(FindingCode::G107, wall, k,
                 name_of(obstacle, k) + " leans on " + support.name() +
                     " but has its free side towards it; swap its ends");
    sink.soften(Severity::kWarning);
  }
}

}  // namespace

void check_leaning_walls(const CheckContext& context, FindingSink& sink) {
  const auto contacts = contacts_of(context);
  auto contact = contacts.begin();
  for (const auto i : context.survey().open_chains()) {
    Rings rings;
    for (; contact != contacts.end() && contact->wall == i; ++contact)
      rings.push_back(contact->ring);
    const bool on_border =
        context.has_usable_border() && touches_border(context.box(i), context.map().border);
    if (on_border || !rings.empty()) check_wall(context, i, rings, on_border, sink);
  }
}

}  // namespace mapwright::validators
