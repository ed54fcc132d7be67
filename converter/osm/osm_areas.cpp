#include "converter/osm/osm_areas.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <osmium/area/assembler.hpp>
#include <osmium/builder/osm_object_builder.hpp>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm.hpp>
#include <set>
#include <tuple>

namespace mapwright::converter {
namespace {

using NodePair = std::pair<std::int64_t, std::int64_t>;
using osmium::memory::Buffer;

// Keeps the first problem: the others mostly follow from it. Stretches that come twice are one only
// where no area comes out.
class FirstProblem : public osmium::area::ProblemReporter {
 public:
  std::string text(bool has_area) const { return text_.empty() && !has_area ? cancelled_ : text_; }

  /// Stretches of a way that lie in rings of another kind than its role says.
  std::size_t wrong_stretches(std::int64_t way) const {
    const auto wrong = wrong_stretches_.find(way);
    return wrong == wrong_stretches_.end() ? 0 : wrong->second;
  }

  void report_duplicate_node(osmium::object_id_type, osmium::object_id_type,
                             osmium::Location at) override {
    note("two nodes at the same place", at);
  }
  void report_intersection(osmium::object_id_type, osmium::Location, osmium::Location,
                           osmium::object_id_type, osmium::Location, osmium::Location,
                           osmium::Location at) override {
    note("its ways cross", at);
  }
  void report_duplicate_segment(const osmium::NodeRef& a, const osmium::NodeRef&) override {
    note("a piece of a way stands in it twice", a.location(), cancelled_);
  }
  void report_overlapping_segment(const osmium::NodeRef& a, const osmium::NodeRef&) override {
    note("its ways overlap", a.location());
  }
  void report_ring_not_closed(const osmium::NodeRef& node, const osmium::Way*) override {
    note("its ring does not close", node.location());
  }
  void report_role_should_be_outer(osmium::object_id_type way, osmium::Location,
                                   osmium::Location) override {
    ++wrong_stretches_[way];
  }
  void report_role_should_be_inner(osmium::object_id_type way, osmium::Location,
                                   osmium::Location) override {
    ++wrong_stretches_[way];
  }
  void report_duplicate_way(const osmium::Way&) override {
    note("a way is its member twice", osmium::Location());
  }
  void report_invalid_location(osmium::object_id_type, osmium::object_id_type) override {
    note("a node of its ways is missing", osmium::Location());
  }

 private:
  void note(const char* what, osmium::Location at) { note(what, at, text_); }
  static void note(const char* what, osmium::Location at, std::string& text) {
    if (!text.empty()) return;
    text = what;
    if (!at.valid()) return;
    char place[64];
    std::snprintf(place, sizeof place, " near longitude %.7f, latitude %.7f", at.lon(), at.lat());
    text += place;
  }

  std::string text_, cancelled_;
  std::map<std::int64_t, std::size_t> wrong_stretches_;  // by way
};

osmium::Location location_of(std::int64_t node, const OsmData& data) {
  const auto place = data.places.find(node);
  return place ? osmium::Location(place->x, place->y) : osmium::Location();
}

void build(const OsmWay& way, const OsmData& data, Buffer& buffer) {
  {
    osmium::builder::WayBuilder builder(buffer);
    builder.set_id(way.id);
    osmium::builder::WayNodeListBuilder nodes(builder);
    for (const auto node : way.nodes) {
      nodes.add_node_ref(osmium::NodeRef{node, location_of(node, data)});
    }
  }
  buffer.commit();
}

void build(const OsmRelation& relation, const std::vector<const OsmWay*>& ways, Buffer& buffer) {
  {
    osmium::builder::RelationBuilder builder(buffer);
    builder.set_id(relation.id);
    {
      osmium::builder::TagListBuilder tags(builder);
      tags.add_tag("type", "multipolygon");
    }
    osmium::builder::RelationMemberListBuilder members(builder);
    std::map<std::int64_t, std::string> roles;
    for (const auto& member : relation.ways) roles.emplace(member.way, member.role);
    for (const auto* way : ways) {
      members.add_member(osmium::item_type::way, way->id, roles[way->id].c_str());
    }
  }
  buffer.commit();
}

void append_point(Point p, SourceGeometry& geometry) {
  geometry.xs.push_back(p.x);
  geometry.ys.push_back(p.y);
}

void append_ring(const osmium::NodeRefList& ring, PathRole role, SourceGeometry& geometry) {
  geometry.paths.push_back({static_cast<std::uint32_t>(geometry.xs.size()),
                            static_cast<std::uint32_t>(ring.size()), role, false});
  for (const auto& node : ring) append_point({node.lon(), node.lat()}, geometry);
}

void append_area(const osmium::Area& area, SourceGeometry& geometry) {
  for (const auto& outer : area.outer_rings()) {
    append_ring(outer, PathRole::kOuterRing, geometry);
    for (const auto& inner : area.inner_rings(outer)) {
      append_ring(inner, PathRole::kInnerRing, geometry);
    }
  }
}

using NodeChain = std::vector<std::int64_t>;

// Joins `piece` to the end of `chain`, whichever way round; false where they do not meet.
bool join(NodeChain& chain, const NodeChain& piece) {
  if (chain.back() == piece.front()) {
    chain.insert(chain.end(), piece.begin() + 1, piece.end());
    return true;
  }
  if (chain.back() == piece.back()) {
    chain.insert(chain.end(), piece.rbegin() + 1, piece.rend());
    return true;
  }
  return false;
}

// Ways end to end until they close; empty where one does not.
std::vector<NodeChain> closed_chains(const std::vector<const OsmWay*>& ways) {
  std::vector<NodeChain> left;
  for (const auto* way : ways) {
    if (way->nodes.size() > 1) left.push_back(way->nodes);
  }
  std::vector<NodeChain> rings;
  while (!left.empty()) {
    NodeChain chain = std::move(left.back());
    left.pop_back();
    for (std::size_t i = 0; i < left.size() && chain.front() != chain.back();) {
      if (!join(chain, left[i])) {
        ++i;
        continue;
      }
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    if (chain.size() < 4 || chain.front() != chain.back()) return {};
    rings.push_back(std::move(chain));
  }
  return rings;
}

void append_unsorted(const std::vector<const OsmWay*>& ways, const OsmData& data,
                     SourceGeometry& geometry) {
  auto role = PathRole::kOuterRing;
  for (const auto& ring : closed_chains(ways)) {
    const auto first = static_cast<std::uint32_t>(geometry.xs.size());
    for (const auto node : ring) {
      if (const auto place = data.places.find(node)) append_point(*place, geometry);
    }
    geometry.paths.push_back(
        {first, static_cast<std::uint32_t>(geometry.xs.size()) - first, role, false});
    role = PathRole::kInnerRing;
  }
}

struct NodeAt {
  Point place;
  std::int64_t node = 0;
};

// Whether different nodes lie at one place.
bool share_a_place(std::vector<NodeAt>& nodes) {
  std::sort(nodes.begin(), nodes.end(), [](const NodeAt& a, const NodeAt& b) {
    return std::tie(a.place.x, a.place.y, a.node) < std::tie(b.place.x, b.place.y, b.node);
  });
  return std::adjacent_find(nodes.begin(), nodes.end(), [](const NodeAt& a, const NodeAt& b) {
           return a.place == b.place && a.node != b.node;
         }) != nodes.end();
}

// Two nodes at one place look like one and join nothing. Nearly always there are none, which
// sorting tells sooner than a map does.
std::string problem_of_nodes(const std::vector<const OsmWay*>& ways, const OsmData& data) {
  std::vector<NodeAt> nodes;
  for (const auto* way : ways) {
    for (const auto node : way->nodes) {
      if (const auto place = data.places.find(node)) nodes.push_back({*place, node});
    }
  }
  if (!share_a_place(nodes)) return {};
  std::map<std::pair<double, double>, std::int64_t> node_at;
  for (const auto* way : ways) {
    for (const auto node : way->nodes) {
      const auto place = data.places.find(node);
      if (!place) continue;
      const auto [known, is_new] = node_at.try_emplace({place->x, place->y}, node);
      if (!is_new && known->second != node) {
        return "its nodes " + std::to_string(known->second) + " and " + std::to_string(node) +
               " lie at the same place";
      }
    }
  }
  return {};
}

// Which ways walk each stretch between two nodes.
std::map<NodePair, std::vector<const OsmWay*>> stretches_of(
    const std::vector<const OsmWay*>& ways) {
  std::map<NodePair, std::vector<const OsmWay*>> stretches;
  for (const auto* way : ways) {
    for (std::size_t i = 0; i + 1 < way->nodes.size(); ++i) {
      stretches[std::minmax({way->nodes[i], way->nodes[i + 1]})].push_back(way);
    }
  }
  return stretches;
}

// A way may be part of rings of both kinds: its role is wrong if no edge of it is as the role says.
std::string problem_of_roles(const OsmRelation& relation, const std::vector<const OsmWay*>& ways,
                             const FirstProblem& assembly) {
  std::map<std::int64_t, std::string> roles;
  for (const auto& member : relation.ways) roles.emplace(member.way, member.role);
  std::map<std::int64_t, std::size_t> cancelled;
  for (const auto& [nodes, users] : stretches_of(ways)) {
    if (users.size() < 2) continue;
    for (const auto* way : users) ++cancelled[way->id];
    const auto is = [&](const char* role) {
      return [&roles, role](const OsmWay* way) { return roles[way->id] == role; };
    };
    if (std::any_of(users.begin(), users.end(), is("outer")) &&
        std::any_of(users.begin(), users.end(), is("inner"))) {
      return "an outer way and an inner one share an edge at node " + std::to_string(nodes.first);
    }
  }
  for (const auto* way : ways) {
    const auto wrong = assembly.wrong_stretches(way->id);
    if (wrong > 0 && wrong + cancelled[way->id] + 1 >= way->nodes.size()) {
      return "way " + std::to_string(way->id) + " has the role of another kind of ring in it";
    }
  }
  return {};
}

std::string problem_of_members(const OsmRelation& relation) {
  std::set<std::int64_t> ids;
  for (const auto& member : relation.ways) {
    if (!ids.insert(member.way).second) {
      return "way " + std::to_string(member.way) + " is its member twice";
    }
  }
  return {};
}

// A stretch out and back again, with nothing at its end.
std::string problem_of_spikes(const std::vector<const OsmWay*>& ways) {
  std::map<std::int64_t, std::set<std::int64_t>> neighbours;
  std::map<std::int64_t, std::size_t> visits;
  for (const auto& [nodes, users] : stretches_of(ways)) {
    neighbours[nodes.first].insert(nodes.second);
    neighbours[nodes.second].insert(nodes.first);
    visits[nodes.first] += users.size();
    visits[nodes.second] += users.size();
  }
  for (const auto& [node, others] : neighbours) {
    if (others.size() == 1 && visits[node] > 1) {
      return "it goes to node " + std::to_string(node) + " and back the same way";
    }
  }
  return {};
}

osmium::area::AssemblerConfig config_for(FirstProblem& problem) {
  osmium::area::AssemblerConfig config;
  config.problem_reporter = &problem;
  config.create_empty_areas = false;
  config.check_roles = true;
  return config;
}

std::string first_of(std::string problem, std::string other) {
  return problem.empty() ? std::move(other) : std::move(problem);
}

bool visits_a_node_twice(const OsmWay& way) {
  auto nodes = way.nodes;
  std::sort(nodes.begin(), nodes.end());
  const auto different = std::unique(nodes.begin(), nodes.end()) - nodes.begin();
  return static_cast<std::size_t>(different) + 1 < nodes.size();
}

}  // namespace

std::string append_multipolygon(const std::vector<const OsmWay*>& ways, const OsmRelation& relation,
                                const OsmData& data, SourceGeometry& geometry) {
  Buffer members(1024, Buffer::auto_grow::yes);
  std::vector<std::size_t> offsets;
  for (const auto* way : ways) {
    offsets.push_back(members.committed());
    build(*way, data, members);
  }
  const auto relation_offset = members.committed();
  build(relation, ways, members);
  std::vector<const osmium::Way*> pointers;
  for (const auto offset : offsets) pointers.push_back(&members.get<osmium::Way>(offset));

  FirstProblem problem;
  const auto config = config_for(problem);
  Buffer areas(1024, Buffer::auto_grow::yes);
  osmium::area::Assembler assemble(config);
  assemble(members.get<osmium::Relation>(relation_offset), pointers, areas);
  for (const auto& area : areas.select<osmium::Area>()) append_area(area, geometry);
  const bool has_area = !geometry.paths.empty();
  auto text = first_of(problem.text(has_area), problem_of_members(relation));
  text = first_of(std::move(text), problem_of_roles(relation, ways, problem));
  text = first_of(std::move(text), problem_of_spikes(ways));
  text = first_of(std::move(text), problem_of_nodes(ways, data));
  if (has_area) return text;
  append_unsorted(ways, data, geometry);
  return text.empty() ? "its ways form no ring" : text;
}

std::string append_area_of_way(const OsmWay& way, const OsmData& data, SourceGeometry& geometry) {
  if (visits_a_node_twice(way)) {
    Buffer ways(1024, Buffer::auto_grow::yes);
    build(way, data, ways);
    FirstProblem problem;
    const auto config = config_for(problem);  // the assembler borrows it
    Buffer areas(1024, Buffer::auto_grow::yes);
    osmium::area::Assembler assemble(config);
    assemble(ways.get<osmium::Way>(0), areas);
    for (const auto& area : areas.select<osmium::Area>()) append_area(area, geometry);
    if (!geometry.paths.empty()) {
      return first_of(problem.text(true),
                      first_of(problem_of_spikes({&way}), problem_of_nodes({&way}, data)));
    }
  }
  geometry.paths.push_back(
      {0, static_cast<std::uint32_t>(way.nodes.size()), PathRole::kOuterRing, false});
  for (const auto node : way.nodes) append_point(*data.places.find(node), geometry);
  return problem_of_nodes({&way}, data);
}

}  // namespace mapwright::converter
