#include "navcore/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "mapcore/geometry/orientation.hpp"
#include "navcore/space/sampling_cells.hpp"
#include "navcore/space/solid_rings.hpp"

namespace mapwright::navcore {
namespace {

constexpr int kMostDraws = 100000;

SegmentIndex make_index(const std::vector<BlockingSegment>& segments) {
  std::vector<IndexedSegment> indexed;
  indexed.reserve(segments.size());
  for (const auto& segment : segments) indexed.push_back({segment.a, segment.b, segment.obstacle});
  return SegmentIndex(std::move(indexed));
}

double distance_to_border_m(const Border& border, Point p) {
  return std::min({p.x - border.left, border.right - p.x, p.y - border.bottom, border.top - p.y});
}

bool is_on(Point p, const IndexedSegment& segment) {
  Box box = kEmptyBox;
  box.add(segment.a);
  box.add(segment.b);
  return box.contains(p) && turn(segment.a, segment.b, p) == Turn::kStraight;
}

Box box_around(Point a, Point b) {
  Box box = kEmptyBox;
  box.add(a);
  box.add(b);
  return box;
}

// True if the closed segment ab meets the blocking segment at its own ends a or b only.
bool touches_with_ends_only(Point a, Point b, const IndexedSegment& segment) {
  const Meeting meeting = meet(a, b, segment.a, segment.b).kind;
  if (meeting == Meeting::kNone) return true;
  if (meeting != Meeting::kTouch) return false;
  return is_on(a, segment) || is_on(b, segment);
}

}  // namespace

struct FreeSpace::Impl {
  Border border;
  std::vector<BlockingSegment> segments;
  SegmentIndex index;
  SolidRings solids;
  mutable std::once_flag cells_made;  // only those who draw points pay for the cells
  mutable std::optional<SamplingCells> cells;

  Impl(const Map& map, RampPolicy ramps)
      : border(map.border),
        segments(blocking_segments(map, ramps)),
        index(make_index(segments)),
        solids(map, ramps) {}

  CellState classify(const Box& cell) const {
    const Point center{0.5 * (cell.min_x + cell.max_x), 0.5 * (cell.min_y + cell.max_y)};
    const double half_diagonal_m = 0.5 * std::hypot(cell.width(), cell.height());
    if (index.clearance_m(center, half_diagonal_m) < half_diagonal_m) return CellState::kMixed;
    return solids.solid_at(center) ? CellState::kSolid : CellState::kFree;
  }

  const SamplingCells& sampling_cells() const {
    std::call_once(cells_made, [this] {
      cells.emplace(border.box(), [this](const Box& cell) { return classify(cell); });
    });
    return *cells;
  }

  bool way_touches_with_ends_only(Point a, Point b) const {
    const auto touches = [&](Point p) {
      return !index.query(box_around(p, p), [&](std::size_t i) { return !is_on(p, index[i]); });
    };
    if (!touches(a) && !touches(b)) return false;  // the usual case: something is in between
    return index.query(box_around(a, b),
                       [&](std::size_t i) { return touches_with_ends_only(a, b, index[i]); });
  }
};

FreeSpace::FreeSpace(const Map& map, RampPolicy ramps)
    : impl_(std::make_unique<Impl>(map, ramps)) {}
FreeSpace::FreeSpace(FreeSpace&&) noexcept = default;
FreeSpace& FreeSpace::operator=(FreeSpace&&) noexcept = default;
FreeSpace::~FreeSpace() = default;

const Border& FreeSpace::border() const {
  return impl_->border;
}
const std::vector<BlockingSegment>& FreeSpace::segments() const {
  return impl_->segments;
}
const SegmentIndex& FreeSpace::index() const {
  return impl_->index;
}

bool FreeSpace::is_free(Point p) const {
  return impl_->border.contains(p) && !impl_->solids.solid_at(p);
}

bool FreeSpace::is_free(Point p, double radius_m) const {
  return is_free(p) && distance_to_border_m(impl_->border, p) >= radius_m &&
         (radius_m <= 0.0 || impl_->index.clearance_m(p, radius_m) >= radius_m);
}

double FreeSpace::clearance_m(Point p) const {
  if (!is_free(p)) return 0.0;
  return impl_->index.clearance_m(p, distance_to_border_m(impl_->border, p));
}

bool FreeSpace::is_free_way(Point a, Point b, double radius_m) const {
  if (radius_m > 0.0) return !impl_->index.comes_near(a, b, radius_m);
  if (!impl_->index.meets(a, b)) return true;
  return impl_->way_touches_with_ends_only(a, b) && is_free(0.5 * (a + b));
}

std::optional<std::size_t> FreeSpace::solid_at(Point p) const {
  if (!impl_->border.contains(p)) return std::nullopt;
  const auto solid = impl_->solids.solid_at(p);
  if (solid != SolidRings::kOutside) return solid;
  const auto nearest = impl_->index.nearest(p);
  return nearest ? std::optional<std::size_t>(impl_->index[nearest->segment].tag) : std::nullopt;
}

std::optional<Point> FreeSpace::sample(Random& random, double radius_m) const {
  const SamplingCells& cells = impl_->sampling_cells();
  for (int i = 0; i < kMostDraws; ++i) {
    const auto p = cells.draw(random);
    if (!p) return std::nullopt;
    if (is_free(*p, radius_m)) return p;
  }
  return std::nullopt;
}

}  // namespace mapwright::navcore
