#include "navcore/exact/widths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "navcore/exact/gap.hpp"

namespace mapwright::navcore::exact {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Voronoi vertices are rounded; a gap this much beyond an edge's end still belongs to the edge.
constexpr double kVertexError_mm = 1e-4;

// Relative error of a width and of a diameter in metres turned to millimetres.
constexpr double kRounding = 1e-14;

Point to_point(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

// Direction in which an edge between two sites runs where it is narrowest: across the gap turned by
// 90°.
Point along(const Gap& gap) {
  const Point across = gap.to - gap.from;
  const double scale = 1.0 / length(across);
  return {-scale * across.y, scale * across.x};
}

// True if the gap lies between two points of the edge.
bool lies_between(const Gap& gap, Point p, Point q) {
  const Point direction = along(gap);
  const double s = dot(p - gap.middle(), direction), t = dot(q - gap.middle(), direction);
  return std::min(s, t) <= kVertexError_mm && std::max(s, t) >= -kVertexError_mm;
}

// How far a disc can grow that stays in touch with `from` while its centre moves along
// `direction`, until it touches the site (for a segment: the line through it).
double growth_until_touching(const VoronoiSite& site, Point from, Point direction) {
  if (site.is_point()) {
    const Point way = to_point(site.a) - from;
    const double ahead = dot(direction, way);
    return ahead > 0.0 ? 0.5 * squared_length(way) / ahead : HUGE_VAL;
  }
  const Point d = to_point(site.b) - to_point(site.a);
  const double scale = 1.0 / length(d);
  const Point normal{-scale * d.y, scale * d.x};
  const double off_mm = dot(normal, from - to_point(site.a));
  const double leaving = off_mm < 0.0 ? -dot(normal, direction) : dot(normal, direction);
  return leaving < 1.0 ? std::abs(off_mm) / (1.0 - leaving) : HUGE_VAL;
}

}  // namespace

Widths::Widths(const Tessellation& space) : graph_(build_voronoi_graph(space)) {
  passages_.reserve(graph_.edges.size());
  for (const VoronoiEdge& edge : graph_.edges) {
    passages_.push_back(measure(edge, graph_.vertices[edge.from], graph_.vertices[edge.to]));
  }
  grow_forest();
  index_sites(space.work);
}

// The narrowest place of the edge between two of its points.
Widths::Passage Widths::measure(const VoronoiEdge& edge, Point p, Point q) const {
  const VoronoiSite &first = graph_.sites[edge.first_site],
                    &second = graph_.sites[edge.second_site];
  const auto gap = gap_between(first, second);
  const bool is_even = gap && !first.is_point() && !second.is_point();  // between parallel walls
  if (is_even) return {gap->width_mm, 0.5 * (p + q)};
  if (gap && lies_between(*gap, p, q)) return {gap->width_mm, gap->middle()};
  const double at_p = clearance_at(edge, p), at_q = clearance_at(edge, q);
  return at_p < at_q ? Passage{2.0 * at_p, p} : Passage{2.0 * at_q, q};
}

// 0 where the two walls that the edge runs between meet.
double Widths::clearance_at(const VoronoiEdge& edge, Point p) const {
  const double clearance_mm = distance_to(graph_.sites[edge.first_site], p);
  return clearance_mm < kVertexError_mm ? 0.0 : clearance_mm;
}

void Widths::index_sites(const LineWork& work) {
  std::vector<std::uint32_t> site_of_vertex(work.vertices.size(), kNone);
  for (std::uint32_t site = 0; site < graph_.sites.size(); ++site) {
    const VoronoiSite& s = graph_.sites[site];
    if (!s.is_point()) continue;
    const Edge& edge = work.edges[s.edge];
    site_of_vertex[work.vertices[edge.a] == s.a ? edge.a : edge.b] = site;
  }
  std::vector<IndexedSegment> segments;
  for (std::uint32_t site = 0; site < graph_.sites.size(); ++site) {
    const VoronoiSite& s = graph_.sites[site];
    if (s.is_point()) continue;
    const Edge& edge = work.edges[s.edge];
    segments.push_back({to_point(s.a), to_point(s.b), 0});
    indexed_sites_.push_back({site, site_of_vertex[edge.a], site_of_vertex[edge.b]});
  }
  index_.emplace(std::move(segments));
}

// Edges that a disc passes, widest first.
void Widths::order_edges() {
  struct Key {
    double width_mm;
    std::uint32_t edge;
  };
  std::vector<Key> keys;
  keys.reserve(passages_.size());
  for (std::uint32_t edge = 0; edge < passages_.size(); ++edge) {
    // Where walls meet, no disc passes from one side to the other.
    if (passages_[edge].width_mm > 0.0) keys.push_back({passages_[edge].width_mm, edge});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& p, const Key& q) {
    return p.width_mm != q.width_mm ? p.width_mm > q.width_mm : p.edge < q.edge;
  });
  order_.reserve(keys.size());
  for (const Key& key : keys) order_.push_back(key.edge);
}

void Widths::grow_forest() {
  order_edges();
  links_.resize(graph_.vertices.size());
  for (std::uint32_t i = 0; i < links_.size(); ++i) links_[i] = {i, kNone};
  std::vector<std::uint32_t> size(links_.size(), 1), above(links_.size());
  std::iota(above.begin(), above.end(), 0U);
  const auto top = [&](std::uint32_t v) {  // with shorter ways on each call
    while (above[v] != v) v = above[v] = above[above[v]];
    return v;
  };
  for (std::uint32_t rank = 0; rank < order_.size(); ++rank) {
    const VoronoiEdge& edge = graph_.edges[order_[rank]];
    std::uint32_t a = top(edge.from), b = top(edge.to);
    if (a == b) continue;
    if (size[a] > size[b]) std::swap(a, b);
    links_[a] = {b, rank};
    above[a] = b;
    size[b] += size[a];
  }
}

// Position in order_ of the narrowest edge between two vertices; nothing where none joins them,
// `kNone` where they are the same.
std::optional<std::uint32_t> Widths::narrowest_between(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t narrowest = kNone;
  while (a != b) {
    // Of the two, the one that was joined earlier moves up.
    if (links_[a].rank > links_[b].rank) std::swap(a, b);
    if (links_[a].parent == a) return std::nullopt;
    narrowest = links_[a].rank;
    a = links_[a].parent;
  }
  return narrowest;
}

std::optional<Widths::Foot> Widths::foot_of(GridPoint p) const {
  const Point place = to_point(p);
  const auto nearest = index_->nearest(place);
  if (!nearest || !(nearest->distance_m > 0.0)) return std::nullopt;
  const IndexedSites& sites = indexed_sites_[nearest->segment];
  const VoronoiSite& segment = graph_.sites[sites.inside];
  std::uint32_t site = sites.inside;
  if (dot_from(segment.a, segment.b, p) <= 0) site = sites.a;
  if (dot_from(segment.b, segment.a, p) <= 0) site = sites.b;
  const Point direction = (1.0 / nearest->distance_m) * (place - nearest->at);
  return follow_ray(site, nearest->at, direction, nearest->distance_m);
}

// How far a point that has the edge's two sites as nearest ones lies off the edge itself.
double Widths::distance_off(const VoronoiEdge& edge, Point p) const {
  const Point from = graph_.vertices[edge.from], to = graph_.vertices[edge.to];
  const VoronoiSite &first = graph_.sites[edge.first_site],
                    &second = graph_.sites[edge.second_site];
  if (first.is_point() == second.is_point()) {
    return distance(p, closest_point_on_segment(p, from, to));
  }
  const VoronoiSite& line = first.is_point() ? second : first;
  const Point d = to_point(line.b) - to_point(line.a);
  const double scale = 1.0 / length(d);
  const double s = scale * dot(from - p, d), t = scale * dot(to - p, d);
  return std::max({0.0, std::min(s, t), -std::max(s, t)});
}

// A disc that grows while it stays in touch with `from`: the first other site it touches, and the
// edge of the medial axis it reaches thereby.
std::optional<Widths::Foot> Widths::follow_ray(std::uint32_t site, Point from, Point direction,
                                               double clearance_mm) const {
  double best_mm = HUGE_VAL, least_off_mm = HUGE_VAL;
  Foot foot{kNone, {}, clearance_mm, site};
  for (const std::uint32_t number : graph_.edges_around(site)) {
    const VoronoiEdge& edge = graph_.edges[number];
    const std::uint32_t other = edge.first_site == site ? edge.second_site : edge.first_site;
    const VoronoiSite& s = graph_.sites[other];
    const double reach_mm = growth_until_touching(s, from, direction);
    if (reach_mm == HUGE_VAL) continue;
    const Point at = from + reach_mm * direction;
    const double slack_mm = kVertexError_mm + 1e-9 * reach_mm;
    if (reach_mm > best_mm + slack_mm || reach_mm < clearance_mm - slack_mm) continue;
    if (std::abs(distance_to(s, at) - reach_mm) > slack_mm) continue;  // beyond the segment's ends
    // Two sites can share several edges, on both sides of a wall for instance.
    const double off_mm = distance_off(edge, at);
    if (reach_mm >= best_mm - slack_mm && off_mm >= least_off_mm) continue;
    best_mm = reach_mm;
    least_off_mm = off_mm;
    foot.edge = number;
    foot.at = at;
  }
  if (foot.edge == kNone) return std::nullopt;
  return foot;
}

Widths::Way Widths::between(const Foot& a, const Foot& b) const {
  const VoronoiEdge &edge_a = graph_.edges[a.edge], &edge_b = graph_.edges[b.edge];
  Way best;
  if (a.edge == b.edge) {
    best.narrowest = measure(edge_a, a.at, b.at);
    best.edge = a.edge;
    best.ends_mm = best.narrowest.width_mm;
  }
  for (const std::uint32_t from : {edge_a.from, edge_a.to}) {
    for (const std::uint32_t to : {edge_b.from, edge_b.to}) {
      const auto rank = narrowest_between(from, to);
      if (!rank) continue;
      Way way{a.edge, measure(edge_a, a.at, graph_.vertices[from])};
      way.first_vertex = from, way.last_vertex = to;
      const Passage last = measure(edge_b, b.at, graph_.vertices[to]);
      way.ends_mm = std::min(way.narrowest.width_mm, last.width_mm);
      const auto narrow_to = [&](std::uint32_t edge, const Passage& passage) {
        if (passage.width_mm < way.narrowest.width_mm) way.edge = edge, way.narrowest = passage;
      };
      narrow_to(b.edge, last);
      if (*rank != kNone) narrow_to(order_[*rank], passages_[order_[*rank]]);
      // Of equally wide ways the one that does not begin or end with a detour through a gap.
      const bool is_even = way.narrowest.width_mm == best.narrowest.width_mm;
      if (is_even ? way.ends_mm > best.ends_mm : way.narrowest.width_mm > best.narrowest.width_mm) {
        best = way;
      }
    }
  }
  return best;
}

bool Widths::is_wide_enough(double width_mm, double diameter_mm) {
  return width_mm >= diameter_mm * (1.0 - kRounding);
}

// Clearance along an edge falls to one narrowest place and rises from there, so a disc that stands
// on the edge gets at least to one of its ends.
std::optional<std::size_t> Widths::region_of(GridPoint p, double width_mm) const {
  const double needed_mm = width_mm * (1.0 - kRounding);
  const auto foot = foot_of(p);
  if (!foot) return std::nullopt;
  const VoronoiEdge& edge = graph_.edges[foot->edge];
  const bool to_from =
      measure(edge, foot->at, graph_.vertices[edge.from]).width_mm >= needed_mm - kVertexError_mm;
  std::uint32_t v = to_from ? edge.from : edge.to;
  while (links_[v].parent != v && passages_[order_[links_[v].rank]].width_mm >= needed_mm) {
    v = links_[v].parent;
  }
  return v;
}

NarrowPlace Widths::place_on(const Way& way) const {
  const VoronoiEdge& edge = graph_.edges[way.edge];
  const VoronoiSite &p = graph_.sites[edge.first_site], &q = graph_.sites[edge.second_site];
  const Point at = way.narrowest.at;
  return {way.narrowest.width_mm,
          at,
          closest_point_on_segment(at, to_point(p.a), to_point(p.b)),
          closest_point_on_segment(at, to_point(q.a), to_point(q.b)),
          p.edge,
          q.edge,
          false};
}

NarrowPlace Widths::place_at_end(GridPoint p, const Foot& foot) const {
  const VoronoiSite& site = graph_.sites[foot.nearest_site];
  const Point nearest = closest_point_on_segment(to_point(p), to_point(site.a), to_point(site.b));
  return {2.0 * foot.clearance_mm, to_point(p), nearest, nearest, site.edge, site.edge, true};
}

std::optional<NarrowPlace> Widths::widest_way(GridPoint a, GridPoint b) const {
  const auto foot_a = foot_of(a), foot_b = foot_of(b);
  if (!foot_a || !foot_b) return std::nullopt;
  const double end_width_mm = 2.0 * std::min(foot_a->clearance_mm, foot_b->clearance_mm);
  const Way way = between(*foot_a, *foot_b);
  if (!(way.narrowest.width_mm > 0.0) && a != b) return std::nullopt;
  if (a != b && way.narrowest.width_mm < end_width_mm) return place_on(way);
  return foot_a->clearance_mm <= foot_b->clearance_mm ? place_at_end(a, *foot_a)
                                                      : place_at_end(b, *foot_b);
}

}  // namespace mapwright::navcore::exact
