#include "converter/osm/osm_areas.hpp"

#include <cstdio>
#include <map>
#include <osmium/area/assembler.hpp>
#include <osmium/builder/osm_object_builder.hpp>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm.hpp>

namespace mapwright::converter {
namespace {

using osmium::memory::Buffer;

// Keeps the first problem: the others mostly follow from it.
class FirstProblem : public osmium::area::ProblemReporter {
 public:
  const std::string& text() const { return text_; }

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
    note("a piece of a way stands in it twice", a.location());
  }
  void report_overlapping_segment(const osmium::NodeRef& a, const osmium::NodeRef&) override {
    note("its ways overlap", a.location());
  }
  void report_ring_not_closed(const osmium::NodeRef& node, const osmium::Way*) override {
    note("its ring does not close", node.location());
  }
  void report_role_should_be_outer(osmium::object_id_type, osmium::Location at,
                                   osmium::Location) override {
    note("an outer way has another role", at);
  }
  void report_role_should_be_inner(osmium::object_id_type, osmium::Location at,
                                   osmium::Location) override {
    note("an inner way has another role", at);
  }
  void report_way_in_multiple_rings(const osmium::Way&) override {
    note("a way is part of several rings", osmium::Location());
  }
  void report_duplicate_way(const osmium::Way&) override {
    note("a way is its member twice", osmium::Location());
  }
  void report_invalid_location(osmium::object_id_type, osmium::object_id_type) override {
    note("a node of its ways is missing", osmium::Location());
  }

 private:
  void note(const char* what, osmium::Location at) {
    if (!text_.empty()) return;
    text_ = what;
    if (!at.valid()) return;
    char place[64];
    std::snprintf(place, sizeof place, " near longitude %.7f, latitude %.7f", at.lon(), at.lat());
    text_ += place;
  }

  std::string text_;
};

osmium::Location location_of(std::int64_t node, const OsmData& data) {
  const auto place = data.places.find(node);
  if (place == data.places.end()) return osmium::Location();
  return {place->second.x, place->second.y};
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
      const auto place = data.places.find(node);
      if (place != data.places.end()) append_point(place->second, geometry);
    }
    geometry.paths.push_back(
        {first, static_cast<std::uint32_t>(geometry.xs.size()) - first, role, false});
    role = PathRole::kInnerRing;
  }
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
  osmium::area::AssemblerConfig config;
  config.problem_reporter = &problem;
  config.create_empty_areas = false;
  Buffer areas(1024, Buffer::auto_grow::yes);
  osmium::area::Assembler assemble(config);
  assemble(members.get<osmium::Relation>(relation_offset), pointers, areas);
  for (const auto& area : areas.select<osmium::Area>()) append_area(area, geometry);
  if (!geometry.paths.empty()) return problem.text();
  append_unsorted(ways, data, geometry);
  return problem.text().empty() ? "its ways form no ring" : problem.text();
}

}  // namespace mapwright::converter
