#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "mapcore/geometry/box_grid.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright {
namespace {

// A box and its position, as CGAL's algorithm wants to see it.
class NumberedBox {
 public:
  using NT = double;
  using ID = std::size_t;

  NumberedBox(const Box& box, std::size_t position) : box_(box), position_(position) {}

  static int dimension() { return 2; }
  ID id() const { return position_; }
  NT min_coord(int axis) const { return axis == 0 ? box_.min_x : box_.min_y; }
  NT max_coord(int axis) const { return axis == 0 ? box_.max_x : box_.max_y; }

 private:
  Box box_;
  std::size_t position_;
};

// By a plane sweep over a segment tree, for boxes of any sizes.
void sweep(std::span<const Box> boxes, double reach_m,
           const std::function<void(std::size_t, std::size_t)>& visit) {
  std::vector<NumberedBox> numbered;
  numbered.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].is_empty()) numbered.emplace_back(boxes[i].inflated(reach_m), i);
  }
  CGAL::box_self_intersection_d(numbered.begin(), numbered.end(),
                                [&](const NumberedBox& p, const NumberedBox& q) {
                                  visit(std::min(p.id(), q.id()), std::max(p.id(), q.id()));
                                });
}

}  // namespace

void for_each_meeting_pair(std::span<const Box> boxes,
                           const std::function<void(std::size_t, std::size_t)>& visit,
                           double reach_m) {
  const BoxGrid grid(boxes, reach_m);
  if (grid.pays()) return grid.for_each_meeting_pair(visit);
  sweep(boxes, reach_m, visit);
}

}  // namespace mapwright
