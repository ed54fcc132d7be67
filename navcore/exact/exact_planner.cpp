#include "navcore/exact/exact_planner.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "mapcore/tolerances.hpp"
#include "navcore/exact/barrier_rounds.hpp"
#include "navcore/exact/free_faces.hpp"
#include "navcore/exact/ground.hpp"
#include "navcore/exact/offset.hpp"
#include "navcore/exact/path_search.hpp"
#include "navcore/exact/searchable_space.hpp"
#include "navcore/exact/tight_route.hpp"
#include "navcore/exact/widths.hpp"

namespace mapwright::navcore {

using exact::GridPoint;
using exact::Ground;
using exact::SearchableSpace;

namespace {

// Where the offset of the options' fineness finds no way, this one decides: it lacks 0.03 % of the
// radius at corners.
constexpr int kDecisiveTangents = 32;
constexpr int kMostTangents = 64;

std::optional<Failure> why_not(double radius_m) {
  if (std::isfinite(radius_m) && radius_m >= 0.0) return std::nullopt;
  return Failure{FailureKind::kUsage, "the robot's radius must be a number, 0 or greater"};
}

void add_to_path(const std::vector<Point>& points, ExactAnswer& answer) {
  for (const Point p : points) {
    if (!answer.path.empty() && answer.path.back() == p) continue;
    if (!answer.path.empty()) answer.length_m += distance(answer.path.back(), p);
    answer.path.push_back(p);
  }
}

std::optional<Failure> why_not(const ExactOptions& options) {
  if (auto failure = why_not(options.radius_m)) return failure;
  if (options.tangents_a_quadrant >= 1 && options.tangents_a_quadrant <= kMostTangents) {
    return std::nullopt;
  }
  return Failure{FailureKind::kUsage, "a quarter circle needs 1 to 64 tangents"};
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
  std::shared_ptr<const Ground> ground;
  std::unique_ptr<const SearchableSpace> space;  // for the robot
  mutable std::once_flag decisive_built;
  mutable std::unique_ptr<const SearchableSpace> decisive;  // closer to the truth; made on demand

  mutable std::mutex spare_mutex;
  mutable std::vector<ExactWorkspace> spare_workspaces;

  Impl(const ExactOptions& robot, std::shared_ptr<const Ground> on);

  bool is_point() const { return options.radius_m == 0.0; }
  double radius_mm() const { return options.radius_m * 1e3; }
  const exact::GridFrame& frame() const { return ground->frame; }

  std::unique_ptr<const SearchableSpace> offset(int tangents) const;
  const SearchableSpace& decisive_space() const;
  PlaceState state(Point p) const;
  bool find_path(const SearchableSpace& in, Point start, Point goal, exact::SearchSpace& search,
                 ExactAnswer& answer) const;
  bool is_clear(Point a, Point b) const;
  bool add_stretch(const SearchableSpace& in, const exact::Stretch& stretch,
                   exact::SearchSpace& search, ExactAnswer& answer) const;
  bool squeeze(const SearchableSpace& in, Point start, Point goal, exact::SearchSpace& search,
               ExactAnswer& answer) const;
  void prove_unreachable(const SearchableSpace& in, Point start, Point goal,
                         ExactAnswer& answer) const;
  std::optional<std::uint32_t> obstacle_of(std::uint32_t source) const;
  std::optional<std::uint32_t> segment_of(std::uint32_t source) const;
  std::uint32_t source_of_edge(std::uint32_t edge) const;
  Point from_mm(Point p) const;
  Bottleneck to_bottleneck(const exact::NarrowPlace& narrow) const;
  ExactWorkspace take_workspace() const;
  void give_back(ExactWorkspace workspace) const;
  BarrierSide to_side(const exact::Barrier& barrier, const exact::BarrierLeg& leg) const;
};

ExactPlanner::Impl::Impl(const ExactOptions& robot, std::shared_ptr<const Ground> on)
    : options(robot), ground(std::move(on)) {
  space = is_point() ? std::make_unique<SearchableSpace>(ground->space)
                     : offset(options.tangents_a_quadrant);
}

std::unique_ptr<const SearchableSpace> ExactPlanner::Impl::offset(int tangents) const {
  return std::make_unique<SearchableSpace>(std::make_shared<const exact::Tessellation>(
      exact::offset_free_space(*ground->space, {radius_mm(), tangents, ground->snapping_mm})));
}

const SearchableSpace& ExactPlanner::Impl::decisive_space() const {
  if (is_point() || options.tangents_a_quadrant >= kDecisiveTangents) return *space;
  std::call_once(decisive_built, [&] { decisive = offset(kDecisiveTangents); });
  return *decisive;
}

PlaceState ExactPlanner::Impl::state(Point p) const {
  if (!is_finite(p)) return PlaceState::kNotFinite;
  if (!ground->border.contains(p)) return PlaceState::kOutsideBorder;
  if (!space->cells_at(frame().to_grid(p)).empty()) return PlaceState::kFree;
  if (is_point() || decisive_space().cells_at(frame().to_grid(p)).empty())
    return PlaceState::kBlocked;
  return PlaceState::kFree;
}

// A path on the grid, with the places asked for at its ends; goes on where the answer's path ends.
bool ExactPlanner::Impl::find_path(const SearchableSpace& in, Point start, Point goal,
                                   exact::SearchSpace& search, ExactAnswer& answer) const {
  const GridPoint from = frame().to_grid(start), to = frame().to_grid(goal);
  const auto path =
      exact::find_shortest_path(in.mesh(), from, to, in.cells_at(from), in.cells_at(to), search);
  if (!path) return false;
  answer.verdict = Verdict::kReachable;
  std::vector<Point> points{start};
  for (const GridPoint p : path->points) points.push_back(frame().to_map(p));
  points.push_back(goal);
  add_to_path(points, answer);
  if (answer.path.size() == 1) answer.path.push_back(goal);
  return true;
}

// True if the disc moves straight from a to b among the map's own segments.
bool ExactPlanner::Impl::is_clear(Point a, Point b) const {
  const double radius_m = options.radius_m - tolerance::kArithmetic_m;
  const Box room = ground->border.box().inflated(-radius_m);
  return room.contains(a) && room.contains(b) && !ground->index().comes_near(a, b, radius_m);
}

// A path through gaps that the disc fits and its offset does not: along the medial axis from part
// to part of the offset free space, and the shortest way within each.
bool ExactPlanner::Impl::squeeze(const SearchableSpace& in, Point start, Point goal,
                                 exact::SearchSpace& search, ExactAnswer& answer) const {
  const GridPoint from = frame().to_grid(start), to = frame().to_grid(goal);
  const auto narrow = ground->widths().widest_way(from, to);
  if (!narrow || !exact::Widths::is_wide_enough(narrow->width_mm, 2.0 * radius_mm())) return false;
  std::vector<Point> route = ground->widths().widest_route(from, to);
  if (route.empty()) return false;
  for (Point& p : route) p = from_mm(p);
  route.front() = start, route.back() = goal;
  constexpr double kLeastStep_m = 0.005;
  const auto stretches = exact::cut_route(route, std::max(kLeastStep_m, 0.125 * options.radius_m),
                                          [&](Point p) { return in.part_at(frame().to_grid(p)); });
  if (!stretches) return false;
  ExactAnswer found = answer;
  for (const exact::Stretch& stretch : *stretches) {
    if (!add_stretch(in, stretch, search, found)) return false;
  }
  answer = std::move(found);
  answer.verdict = Verdict::kReachable;
  return true;
}

bool ExactPlanner::Impl::add_stretch(const SearchableSpace& in, const exact::Stretch& stretch,
                                     exact::SearchSpace& search, ExactAnswer& answer) const {
  if (stretch.is_within_part) {
    return find_path(in, stretch.points.front(), stretch.points.back(), search, answer);
  }
  const auto taut =
      exact::pull_taut(stretch.points, [&](Point a, Point b) { return is_clear(a, b); });
  if (!taut) return false;
  add_to_path(*taut, answer);
  return true;
}

std::optional<std::uint32_t> ExactPlanner::Impl::obstacle_of(std::uint32_t source) const {
  if (source == exact::kBorderSource) return std::nullopt;
  return ground->segments[source].obstacle;
}

std::optional<std::uint32_t> ExactPlanner::Impl::segment_of(std::uint32_t source) const {
  if (source == exact::kBorderSource) return std::nullopt;
  return ground->segments[source].segment;
}

std::uint32_t ExactPlanner::Impl::source_of_edge(std::uint32_t edge) const {
  const exact::LineWork& work = ground->space->work;
  return work.pieces[work.edges[edge].first_piece].source;
}

Point ExactPlanner::Impl::from_mm(Point p) const {
  return 1e-3 * p + frame().to_map({0, 0});
}

Bottleneck ExactPlanner::Impl::to_bottleneck(const exact::NarrowPlace& narrow) const {
  const std::uint32_t from = source_of_edge(narrow.edge_from), to = source_of_edge(narrow.edge_to);
  Bottleneck bottleneck;
  bottleneck.width_m = narrow.width_mm / 1e3;
  bottleneck.at = from_mm(narrow.at);
  bottleneck.from = from_mm(narrow.from);
  bottleneck.to = from_mm(narrow.to);
  bottleneck.obstacle_from = obstacle_of(from);
  bottleneck.obstacle_to = obstacle_of(to);
  bottleneck.segment_from = segment_of(from);
  bottleneck.segment_to = segment_of(to);
  bottleneck.is_end = narrow.is_end;
  return bottleneck;
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
  return {frame().to_map(leg.from), frame().to_map(leg.to), leg.is_gap(), obstacle(leg.line_from),
          obstacle(leg.line_to)};
}

void ExactPlanner::Impl::prove_unreachable(const SearchableSpace& in, Point start, Point goal,
                                           ExactAnswer& answer) const {
  const auto radius_nm = static_cast<std::int64_t>(options.radius_m * 1e9);
  const exact::BarrierEnd from = in.barrier_end(frame().to_grid(start)),
                          to = in.barrier_end(frame().to_grid(goal));
  auto barrier = exact::find_barrier(*ground->space, in.tessellation(), from, to, radius_nm);
  if (!barrier && !is_point()) {
    // The parts of the offset free space may hang together through gaps it does not see.
    const auto rounds = ground->widths().rounds_around(*ground->space, from.at, 2.0 * radius_mm());
    barrier = exact::find_barrier(*ground->space, rounds, from, to, radius_nm);
  }
  answer.verdict = barrier || is_point() ? Verdict::kUnreachable : Verdict::kUndecided;
  if (!barrier) return;
  for (const auto& leg : barrier->legs) answer.barrier.push_back(to_side(*barrier, leg));
}

ExactPlanner::ExactPlanner(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ExactPlanner::ExactPlanner(ExactPlanner&&) noexcept = default;
ExactPlanner& ExactPlanner::operator=(ExactPlanner&&) noexcept = default;
ExactPlanner::~ExactPlanner() = default;

Result<ExactPlanner> ExactPlanner::build(const Map& map, const ExactOptions& options) {
  if (auto failure = why_not(options)) return tl::unexpected(std::move(*failure));
  auto ground = exact::Ground::build(map, options.ramps);
  if (!ground) return tl::unexpected(ground.error());
  return ExactPlanner(std::make_unique<Impl>(options, *std::move(ground)));
}

Result<ExactPlanner> ExactPlanner::with_radius(double radius_m) const {
  if (auto failure = why_not(radius_m)) return tl::unexpected(std::move(*failure));
  ExactOptions options = impl_->options;
  options.radius_m = radius_m;
  return ExactPlanner(std::make_unique<Impl>(options, impl_->ground));
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
  if (impl_->is_point() || !impl_->squeeze(decisive, start, goal, search, answer)) {
    impl_->prove_unreachable(decisive, start, goal, answer);
  }
  return answer;
}

std::optional<Bottleneck> ExactPlanner::bottleneck(Point a, Point b) const {
  const Ground& ground = *impl_->ground;
  if (!ground.can_ask(a) || !ground.can_ask(b)) return std::nullopt;
  const auto narrow = ground.widths().widest_way(ground.frame.to_grid(a), ground.frame.to_grid(b));
  if (!narrow) return std::nullopt;
  return impl_->to_bottleneck(*narrow);
}

std::optional<std::size_t> ExactPlanner::region_at(Point p, double radius_m) const {
  const Ground& ground = *impl_->ground;
  if (!ground.can_ask(p)) return std::nullopt;
  return ground.widths().region_of(ground.frame.to_grid(p), 2e3 * radius_m);
}

std::vector<FreeComponent> ExactPlanner::components() const {
  const exact::CellMesh& mesh = impl_->space->mesh();
  std::vector<FreeComponent> components;
  for (const double area_m2 : mesh.component_areas_m2()) components.push_back({area_m2, {}});
  std::vector<double> largest_m2(components.size(), -1.0);
  for (std::uint32_t cell = 0; cell < mesh.cell_count(); ++cell) {
    const std::uint32_t number = mesh.components()[cell];
    Point sum;
    for (std::uint32_t i = mesh.first_corner(cell); i < mesh.end_corner(cell); ++i) {
      const Point corner = impl_->frame().to_map(mesh.corners()[i].point);
      components[number].box.add(corner);
      sum = sum + corner;
    }
    const double area_m2 = mesh.area_m2(cell);
    if (area_m2 <= largest_m2[number]) continue;
    largest_m2[number] = area_m2;
    const double count = mesh.end_corner(cell) - mesh.first_corner(cell);
    components[number].somewhere = (1.0 / count) * sum;
  }
  return components;
}

std::optional<std::size_t> ExactPlanner::component_at(Point p) const {
  if (!impl_->ground->can_ask(p)) return std::nullopt;
  return impl_->space->part_at(impl_->frame().to_grid(p));
}

double ExactPlanner::snapping_error_m() const {
  return impl_->ground->snapping_mm / 1e3;
}

std::optional<Point> ExactPlanner::snapped_at() const {
  if (!(impl_->ground->snapping_mm > 0.0)) return std::nullopt;
  return impl_->ground->snapped_at;
}

ExactPlanner::OffsetError ExactPlanner::offset_error() const {
  if (impl_->is_point()) return {};
  const double elsewhere_m = 1.5e-3 + snapping_error_m();
  const double excess = exact::offset_excess(impl_->options.tangents_a_quadrant);
  return {impl_->options.radius_m * (excess - 1.0) + elsewhere_m * excess, elsewhere_m};
}

}  // namespace mapwright::navcore
