#include "navcore/exact/medial_rounds.hpp"

#include "navcore/exact/voronoi_diagram.hpp"

namespace mapwright::navcore::exact {
namespace {

class Rounds {
 public:
  Rounds(const Tessellation& space, const std::function<bool(std::uint32_t)>& is_open)
      : diagram_(space) {
    const auto& edges = diagram_.diagram().edges();
    open_.resize(edges.size());
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < edges.size(); i += 2) {  // twins follow each other
      if (!diagram_.is_inner(edges[i])) continue;
      open_[i] = open_[i + 1] = is_open(number++) ? 1 : 0;
    }
  }

  std::vector<SiteRound> around(std::uint32_t vertex) {
    std::vector<SiteRound> rounds;
    std::vector<char> walked(open_.size());
    bool is_alone = true;
    for (const HalfEdge* edge : edges_of_part(vertex)) {
      is_alone = false;
      if (walked[diagram_.number_of(edge)] == 0) rounds.push_back(walk(edge, walked));
    }
    if (is_alone) rounds.push_back(sites_at(diagram_.diagram().vertices()[vertex]));
    return rounds;
  }

 private:
  using HalfEdge = VoronoiDiagram::HalfEdge;

  bool is_open(const HalfEdge* edge) const { return open_[diagram_.number_of(edge)] != 0; }

  template <class Visit>
  static void for_each_from(const VoronoiDiagram::Vertex& vertex, Visit visit) {
    const HalfEdge* edge = vertex.incident_edge();
    do {
      visit(edge);
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
  }

  // Open half-edges that begin at a vertex of the part.
  std::vector<const HalfEdge*> edges_of_part(std::uint32_t vertex) const {
    const auto& vertices = diagram_.diagram().vertices();
    std::vector<char> seen(vertices.size());
    std::vector<std::uint32_t> waiting{vertex};
    seen[vertex] = 1;
    std::vector<const HalfEdge*> edges;
    while (!waiting.empty()) {
      const std::uint32_t v = waiting.back();
      waiting.pop_back();
      for_each_from(vertices[v], [&](const HalfEdge* edge) {
        if (!is_open(edge)) return;
        edges.push_back(edge);
        const std::uint32_t end = diagram_.number_of(edge->vertex1());
        if (seen[end] == 0) seen[end] = 1, waiting.push_back(end);
      });
    }
    return edges;
  }

  // Along open edges with the part on the right and the sites on the left; over all that is not
  // open.
  SiteRound walk(const HalfEdge* first, std::vector<char>& walked) const {
    SiteRound round;
    const HalfEdge* edge = first;
    do {
      walked[diagram_.number_of(edge)] = 1;
      add(edge, round);
      edge = edge->next();
      while (!is_open(edge)) {
        edge = edge->twin();
        add(edge, round);
        edge = edge->next();
      }
    } while (edge != first);
    return round;
  }

  SiteRound sites_at(const VoronoiDiagram::Vertex& vertex) const {
    SiteRound round;
    for_each_from(vertex, [&](const HalfEdge* edge) { add(edge, round); });
    return round;
  }

  // The site on the left of the edge.
  void add(const HalfEdge* edge, SiteRound& round) const {
    const VoronoiSite site = diagram_.site_of(*edge->cell());
    const bool is_same = !round.empty() && round.back().a == site.a && round.back().b == site.b;
    if (!is_same) round.push_back(site);
  }

  VoronoiDiagram diagram_;
  std::vector<char> open_;  // by half-edge
};

}  // namespace

std::vector<SiteRound> rounds_around(const Tessellation& space, std::uint32_t vertex,
                                     const std::function<bool(std::uint32_t)>& is_open) {
  return Rounds(space, is_open).around(vertex);
}

}  // namespace mapwright::navcore::exact
