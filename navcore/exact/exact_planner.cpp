#include "navcore/exact/exact_planner.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "navcore/exact/barrier.hpp"
#include "navcore/exact/cell_locator.hpp"
#include "navcore/exact/free_faces.hpp"
#include "navcore/exact/offset.hpp"
#include "navcore/exact/path_search.hpp"
#include "navcore/exact/widths.hpp"

namespace mapwright::navcore {

using exact::GridPoint;

namespace {

// Where the offset of the options' fineness finds no way, this one decides: it lacks 0.03 % of the
// radius at corners.
constexpr int kDecisiveTangents = 32;
constexpr int kMostTangents = 64;

// A free space ready to be searched.
struct SearchableSpace {
  exact::Tessellation tessellation;
  exact::CellMesh mesh;
  exact::CellLocator locator;

  explicit SearchableSpace(exact::Tessellation space)
      : tessellation(std::move(space)), mesh(tessellation), locator(mesh) {}
  SearchableSpace(const SearchableSpace&) = delete;
  SearchableSpace& operator=(const SearchableSpace&) = delete;
};

std::optional<Failure> why_not(const Map& map, const ExactOptions& options) {
  if (!std::isfinite(options.radius_m) || options.radius_m < 0.0) {
    return Failure{FailureKind::kUsage, "the robot's radius must be a number, 0 or greater"};
  }
  if (options.tangents_a_quadrant < 1 || options.tangents_a_quadrant > kMostTangents) {
    return Failure{FailureKind::kUsage, "a quarter circle needs 1 to 64 tangents"};
  }
  const Border& border = map.border;
  const bool finite =
      is_finite({border.left, border.top}) && is_finite({border.right, border.bottom});
  if (!finite || border.right - border.left < 1e-3 || border.top - border.bottom < 1e-3) {
    return Failure{FailureKind::kInput,
                   "the map's border has no area: its corners must be top-left and bottom-right"};
  }
  return std::nullopt;
}

Point centre(const Border& border) {
  return {0.5 * (border.left + border.right), 0.5 * (border.top + border.bottom)};
}

std::optional<Failure> why_not_on_grid(const Map& map, const std::vector<BlockingSegment>& segments,
                                       const exact::GridFrame& frame) {
  const auto too_far = [&](const BlockingSegment& segment) {
    return !frame.can_hold(segment.a) || !frame.can_hold(segment.b);
  };
  if (!frame.can_hold({map.border.left, map.border.top})) {
    return Failure{FailureKind::kInput, "the map is wider than 1000 km"};
  }
  const auto far = std::find_if(segments.begin(), segments.end(), too_far);
  if (far == segments.end()) return std::nullopt;
  return Failure{FailureKind::kInput, "obstacle " +
                                          std::to_string(map.obstacles[far->obstacle].id) +
                                          " lies more than 500 km from the centre of the map"};
}

double rounding_error_mm(const std::vector<BlockingSegment>& segments,
                         const exact::GridFrame& frame) {
  double worst_m = 0.0;
  for (const auto& segment : segments) {
    worst_m = std::max({worst_m, distance(segment.a, frame.to_map(frame.to_grid(segment.a))),
                        distance(segment.b, frame.to_map(frame.to_grid(segment.b)))});
  }
  return worst_m > 1e-7 ? worst_m * 1e3 : 0.0;  // what is left of decimals in doubles is no error
}

}  // namespace

std::string_view to_string(PlaceState state) {
  switch (state) {
    case PlaceState::kFree:
      return "free";
    case PlaceState::kNotFinite:
      return "not a place: a coordinate is no number";
    case PlaceState::kOutsideBorder:
      return "outside of the map's border";
    case PlaceState::kBlocked:
      return "inside of an obstacle or too near to one";
  }
  return "";
}

struct ExactWorkspace::Impl {
  exact::SearchSpace search;
};

ExactWorkspace::ExactWorkspace() : impl_(std::make_unique<Impl>()) {}
ExactWorkspace::ExactWorkspace(ExactWorkspace&&) noexcept = default;
ExactWorkspace& ExactWorkspace::operator=(ExactWorkspace&&) noexcept = default;
ExactWorkspace::~ExactWorkspace() = default;

struct ExactPlanner::Impl {
  ExactOptions options;
  Border border;
  exact::GridFrame frame;
  std::vector<std::uint32_t> obstacle_of_source;
  double snapping_mm = 0.0;
  exact::Tessellation base;                      // for a point; empty where `space` is that
  std::unique_ptr<const SearchableSpace> space;  // for the robot
  mutable std::once_flag decisive_built;
  mutable std::unique_ptr<const SearchableSpace> decisive;  // closer to the truth; made on demand

  mutable std::once_flag widths_built;
  mutable std::optional<exact::Widths> widths;
  mutable std::mutex spare_mutex;
  mutable std::vector<ExactWorkspace> spare_workspaces;

  bool is_point() const { return options.radius_m == 0.0; }
  double radius_mm() const { return options.radius_m * 1e3; }
  const exact::Tessellation& point_space() const { return is_point() ? space->tessellation : base; }

  void build(const Map& map, const std::vector<BlockingSegment>& segments);
  std::unique_ptr<const SearchableSpace> offset(int tangents) const;
  const SearchableSpace& decisive_space() const;
  PlaceState state(Point p) const;
  std::vector<std::uint32_t> cells_at(const SearchableSpace& in, Point p) const;
  bool find_path(const SearchableSpace& in, Point start, Point goal, exact::SearchSpace& search,
                 ExactAnswer& answer) const;
  void prove_unreachable(const SearchableSpace& in, Point start, Point goal,
                         ExactAnswer& answer) const;
  std::optional<std::uint32_t> obstacle_of(std::uint32_t source) const;
  std::uint32_t source_of_edge(std::uint32_t edge) const;
  Point from_mm(Point p) const;
  ExactWorkspace take_workspace() const;
  void give_back(ExactWorkspace workspace) const;
  BarrierSide to_side(const exact::Barrier& barrier, const exact::BarrierLeg& leg) const;
};

void ExactPlanner::Impl::build(const Map& map, const std::vector<BlockingSegment>& segments) {
  auto tessellation =
      exact::tessellate(map, options.ramps, frame, exact::map_lines(map, segments, frame));
  snapping_mm = rounding_error_mm(segments, frame) + tessellation.work.displacement_mm;
  for (const auto& segment : segments) obstacle_of_source.push_back(segment.obstacle);
  if (is_point()) {
    space = std::make_unique<SearchableSpace>(std::move(tessellation));
    return;
  }
  base = std::move(tessellation);
  space = offset(options.tangents_a_quadrant);
}

std::unique_ptr<const SearchableSpace> ExactPlanner::Impl::offset(int tangents) const {
  return std::make_unique<SearchableSpace>(
      exact::offset_free_space(base, {radius_mm(), tangents, snapping_mm}));
}

const SearchableSpace& ExactPlanner::Impl::decisive_space() const {
  if (is_point() || options.tangents_a_quadrant >= kDecisiveTangents) return *space;
  std::call_once(decisive_built, [&] { decisive = offset(kDecisiveTangents); });
  return *decisive;
}

std::vector<std::uint32_t> ExactPlanner::Impl::cells_at(const SearchableSpace& in, Point p) const {
  return in.locator.cells_at(frame.to_grid(p));
}

PlaceState ExactPlanner::Impl::state(Point p) const {
  if (!is_finite(p)) return PlaceState::kNotFinite;
  if (!border.contains(p)) return PlaceState::kOutsideBorder;
  if (!cells_at(*space, p).empty()) return PlaceState::kFree;
  if (is_point() || cells_at(decisive_space(), p).empty()) return PlaceState::kBlocked;
  return PlaceState::kFree;
}

// A path on the grid, with the places asked for at its ends.
bool ExactPlanner::Impl::find_path(const SearchableSpace& in, Point start, Point goal,
                                   exact::SearchSpace& search, ExactAnswer& answer) const {
  const auto path = exact::find_shortest_path(in.mesh, frame.to_grid(start), frame.to_grid(goal),
                                              cells_at(in, start), cells_at(in, goal), search);
  if (!path) return false;
  answer.verdict = Verdict::kReachable;
  for (const GridPoint p : path->points) answer.path.push_back(frame.to_map(p));
  if (answer.path.front() != start) answer.path.insert(answer.path.begin(), start);
  if (answer.path.back() != goal || answer.path.size() == 1) answer.path.push_back(goal);
  for (std::size_t i = 1; i < answer.path.size(); ++i) {
    answer.length_m += distance(answer.path[i - 1], answer.path[i]);
  }
  return true;
}

std::optional<std::uint32_t> ExactPlanner::Impl::obstacle_of(std::uint32_t source) const {
  if (source == exact::kBorderSource) return std::nullopt;
  return obstacle_of_source[source];
}

std::uint32_t ExactPlanner::Impl::source_of_edge(std::uint32_t edge) const {
  const exact::LineWork& work = point_space().work;
  return work.pieces[work.edges[edge].first_piece].source;
}

Point ExactPlanner::Impl::from_mm(Point p) const {
  return 1e-3 * p + frame.to_map({0, 0});
}

ExactWorkspace ExactPlanner::Impl::take_workspace() const {
  const std::lock_guard lock(spare_mutex);
  if (spare_workspaces.empty()) return {};
  ExactWorkspace workspace = std::move(spare_workspaces.back());
  spare_workspaces.pop_back();
  return workspace;
}

void ExactPlanner::Impl::give_back(ExactWorkspace workspace) const {
  const std::lock_guard lock(spare_mutex);
  spare_workspaces.push_back(std::move(workspace));
}

BarrierSide ExactPlanner::Impl::to_side(const exact::Barrier& barrier,
                                        const exact::BarrierLeg& leg) const {
  const auto obstacle = [&](std::uint32_t line) { return obstacle_of(barrier.lines[line].source); };
  return {frame.to_map(leg.from), frame.to_map(leg.to), leg.is_gap(), obstacle(leg.line_from),
          obstacle(leg.line_to)};
}

void ExactPlanner::Impl::prove_unreachable(const SearchableSpace& in, Point start, Point goal,
                                           ExactAnswer& answer) const {
  const auto barrier =
      exact::find_barrier(point_space(), in.tessellation, frame.to_grid(start), frame.to_grid(goal),
                          static_cast<std::int64_t>(radius_mm()));
  answer.verdict = barrier || is_point() ? Verdict::kUnreachable : Verdict::kUndecided;
  if (!barrier) return;
  for (const auto& leg : barrier->legs) answer.barrier.push_back(to_side(*barrier, leg));
}

ExactPlanner::ExactPlanner(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ExactPlanner::ExactPlanner(ExactPlanner&&) noexcept = default;
ExactPlanner& ExactPlanner::operator=(ExactPlanner&&) noexcept = default;
ExactPlanner::~ExactPlanner() = default;

Result<ExactPlanner> ExactPlanner::build(const Map& map, const ExactOptions& options) {
  if (auto failure = why_not(map, options)) return tl::unexpected(std::move(*failure));
  auto impl = std::make_unique<Impl>();
  impl->options = options;
  impl->border = map.border;
  impl->frame = exact::GridFrame(centre(map.border));
  const auto segments = blocking_segments(map, options.ramps);
  if (auto failure = why_not_on_grid(map, segments, impl->frame)) {
    return tl::unexpected(std::move(*failure));
  }
  impl->build(map, segments);
  return ExactPlanner(std::move(impl));
}

PlaceState ExactPlanner::state(Point p) const {
  return impl_->state(p);
}

ExactAnswer ExactPlanner::plan(Point start, Point goal) const {
  ExactWorkspace workspace = impl_->take_workspace();
  ExactAnswer answer = plan(start, goal, workspace);
  impl_->give_back(std::move(workspace));
  return answer;
}

ExactAnswer ExactPlanner::plan(Point start, Point goal, ExactWorkspace& workspace) const {
  ExactAnswer answer;
  answer.start = state(start);
  answer.goal = state(goal);
  if (answer.start != PlaceState::kFree || answer.goal != PlaceState::kFree) return answer;
  auto& search = workspace.impl_->search;
  if (impl_->find_path(*impl_->space, start, goal, search, answer)) return answer;
  const SearchableSpace& decisive = impl_->decisive_space();
  if (&decisive != impl_->space.get() && impl_->find_path(decisive, start, goal, search, answer)) {
    return answer;
  }
  impl_->prove_unreachable(decisive, start, goal, answer);
  return answer;
}

std::optional<Bottleneck> ExactPlanner::bottleneck(Point a, Point b) const {
  const auto can_hold = [&](Point p) { return is_finite(p) && impl_->border.contains(p); };
  if (!can_hold(a) || !can_hold(b)) return std::nullopt;
  std::call_once(impl_->widths_built, [&] { impl_->widths.emplace(impl_->point_space()); });
  const auto narrow = impl_->widths->widest_way(impl_->frame.to_grid(a), impl_->frame.to_grid(b));
  if (!narrow) return std::nullopt;
  return Bottleneck{narrow->width_mm / 1e3,
                    impl_->from_mm(narrow->at),
                    impl_->from_mm(narrow->from),
                    impl_->from_mm(narrow->to),
                    impl_->obstacle_of(impl_->source_of_edge(narrow->edge_from)),
                    impl_->obstacle_of(impl_->source_of_edge(narrow->edge_to)),
                    narrow->is_end};
}

std::vector<FreeComponent> ExactPlanner::components() const {
  const exact::CellMesh& mesh = impl_->space->mesh;
  std::vector<FreeComponent> components;
  for (const double area_m2 : mesh.component_areas_m2()) components.push_back({area_m2, {}});
  for (std::uint32_t cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto first = mesh.corners()[mesh.first_corner(cell)].point;
    components[mesh.components()[cell]].somewhere = impl_->frame.to_map(first);
  }
  return components;
}

std::optional<std::size_t> ExactPlanner::component_at(Point p) const {
  if (!is_finite(p) || !impl_->border.contains(p)) return std::nullopt;
  const auto cells = impl_->cells_at(*impl_->space, p);
  if (cells.empty()) return std::nullopt;
  return impl_->space->mesh.components()[cells[0]];
}

double ExactPlanner::snapping_error_m() const {
  return impl_->snapping_mm / 1e3;
}

ExactPlanner::OffsetError ExactPlanner::offset_error() const {
  if (impl_->is_point()) return {};
  const double elsewhere_m = 1.5e-3 + snapping_error_m();
  const double excess = exact::offset_excess(impl_->options.tangents_a_quadrant);
  return {impl_->options.radius_m * (excess - 1.0) + elsewhere_m * excess, elsewhere_m};
}

}  // namespace mapwright::navcore
