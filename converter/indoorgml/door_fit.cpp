#include "converter/indoorgml/door_fit.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::converter {
namespace {

constexpr double kParallel = 0.09;  // sine; 5 degrees

// An edge beside the door, seen from it.
struct Face {
  std::size_t edge = 0;
  double offset = 0.0;   // of its line from the door's middle, to the door's left
  double overlap = 0.0;  // length along the door
  bool floor_on_left = false;
};

class DoorFrame {
 public:
  DoorFrame(const OpenLine& door, const std::vector<WallEdge>& edges, const SegmentIndex& index,
            const DoorLimits& limits)
      : door_(door),
        edges_(edges),
        index_(index),
        limits_(limits),
        length_(distance(door.first, door.second)),
        along_((1.0 / length_) * (door.second - door.first)),
        left_{-along_.y, along_.x} {}

  DoorFit fit() const {
    const auto faces = beside();
    DoorFit fit;
    fit.opens = std::any_of(faces.begin(), faces.end(),
                            [&](const Face& f) { return std::abs(f.offset) <= limits_.tolerance; });
    auto left = nearest(faces, true), right = nearest(faces, false);
    if (left && right && !are_one_wall(*left, *right)) {
      (std::abs(left->offset) <= std::abs(right->offset) ? right : left).reset();
    }
    for (const auto& face : {left, right}) {
      if (face) open(*face, fit);
    }
    if (left && right && left->offset - right->offset > limits_.tolerance) {
      add_jambs(*left, *right, fit);
    }
    return fit;
  }

 private:
  std::vector<Face> beside() const {
    Box around = kEmptyBox;
    around.add(door_.first);
    around.add(door_.second);
    std::vector<Face> faces;
    index_.query(around.inflated(limits_.thickest), [&](std::size_t i) {
      if (const auto face = seen(i)) faces.push_back(*face);
      return true;
    });
    std::sort(faces.begin(), faces.end(),
              [](const Face& p, const Face& q) { return p.edge < q.edge; });
    return faces;
  }

  std::optional<Face> seen(std::size_t i) const {
    const auto& edge = edges_[i];
    const Point direction = edge.b - edge.a;
    if (std::abs(cross(along_, direction)) > kParallel * mapwright::length(direction)) return {};
    const double a = dot(edge.a - door_.first, along_), b = dot(edge.b - door_.first, along_);
    const double from = std::max(0.0, std::min(a, b)), to = std::min(length_, std::max(a, b));
    if (to - from <= limits_.tolerance) return {};
    const double share = (0.5 * (from + to) - a) / (b - a);
    const double offset = dot(edge.a + share * direction - door_.first, left_);
    if (std::abs(offset) > limits_.thickest) return {};
    return Face{i, offset, to - from, dot(direction, along_) < 0.0};
  }

  // Walls are drawn in pieces: those of one line count together.
  std::optional<Face> nearest(const std::vector<Face>& faces, bool on_left) const {
    std::optional<Face> best;
    for (const auto& face : faces) {
      if (!may_lead(face, on_left)) continue;
      double overlap = 0.0;
      for (const auto& other : faces) {
        const bool same_line = std::abs(other.offset - face.offset) <= limits_.tolerance;
        if (same_line && may_lead(other, on_left)) overlap += other.overlap;
      }
      if (overlap < 0.5 * length_) continue;
      if (!best || std::abs(face.offset) < std::abs(best->offset)) best = face;
    }
    return best;
  }

  bool may_lead(const Face& face, bool to_left) const {
    return edges_[face.edge].owner < limits_.cells && face.floor_on_left == to_left;
  }

  bool are_one_wall(const Face& left, const Face& right) const {
    const double thickness = left.offset - right.offset;
    return thickness >= -limits_.tolerance && thickness <= limits_.thickest;
  }

  void open(const Face& face, DoorFit& fit) const {
    fit.opens = true;
    if (std::abs(face.offset) <= limits_.tolerance) return;
    fit.faces.emplace_back(on(face, door_.first), on(face, door_.second));
    fit.farthest = std::max(fit.farthest, std::abs(face.offset));
  }

  // A point of the door, moved straight to the line of a face.
  Point on(const Face& face, Point p) const {
    const auto& edge = edges_[face.edge];
    const Point direction = edge.b - edge.a;
    return p + (cross(direction, edge.a - p) / cross(direction, left_)) * left_;
  }

  // The doorway is on the right of both.
  void add_jambs(const Face& left, const Face& right, DoorFit& fit) const {
    const std::size_t owner = edges_[right.edge].owner;
    fit.jambs.push_back({on(right, door_.first), on(left, door_.first), owner});
    fit.jambs.push_back({on(left, door_.second), on(right, door_.second), owner});
  }

  const OpenLine& door_;
  const std::vector<WallEdge>& edges_;
  const SegmentIndex& index_;
  const DoorLimits& limits_;
  double length_;
  Point along_, left_;
};

}  // namespace

DoorFit fit_door(const OpenLine& door, const std::vector<WallEdge>& edges,
                 const SegmentIndex& index, const DoorLimits& limits) {
  if (door.first == door.second) return {};
  return DoorFrame(door, edges, index, limits).fit();
}

}  // namespace mapwright::converter
