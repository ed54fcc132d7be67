#include "converter/indoorgml/gml_shapes.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "converter/gdal/gml_geometry.hpp"

namespace mapwright::converter {
namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kUsesOfAShape = 16;  // a face belongs to two cells and their boundaries
constexpr std::array<std::string_view, 7> kLeaves{
    "Polygon", "PolygonPatch", "Triangle", "Rectangle", "LineString", "Curve", "Point"};

bool is_leaf(const pugi::xml_node& node) {
  return std::find(kLeaves.begin(), kLeaves.end(), local_name(node)) != kLeaves.end();
}

VertexPath path_of(const SourceGeometry& geometry, const SourcePath& path, bool north_first) {
  VertexPath vertices;
  for (std::uint32_t i = path.first; i < path.first + path.count; ++i) {
    const double z = geometry.zs.empty() ? 0.0 : geometry.zs[i];
    vertices.push_back({geometry.xs[i], geometry.ys[i], z});
    if (north_first) std::swap(vertices.back().x, vertices.back().y);
  }
  return vertices;
}

bool is_same(const Vertex& p, const Vertex& q) {
  return p.x == q.x && p.y == q.y && p.z == q.z;
}

void open_ring(VertexPath& ring) {
  while (ring.size() > 1 && is_same(ring.front(), ring.back())) ring.pop_back();
}

void append_paths(const SourceGeometry& geometry, bool north_first, IndoorObject& object) {
  for (const auto& path : geometry.paths) {
    auto vertices = path_of(geometry, path, north_first);
    if (path.role == PathRole::kLine || path.role == PathRole::kPoint) {
      object.lines.push_back(std::move(vertices));
      continue;
    }
    open_ring(vertices);
    if (path.role == PathRole::kOuterRing) object.faces.emplace_back();
    object.faces.back().rings.push_back(std::move(vertices));
  }
}

}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const auto colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

std::string_view attribute(const pugi::xml_node& node, std::string_view name) {
  for (const auto& own : node.attributes()) {
    const std::string_view full = own.name();
    const auto colon = full.find(':');
    if ((colon == full.npos ? full : full.substr(colon + 1)) == name) return own.value();
  }
  return {};
}

GmlShapes::GmlShapes(const pugi::xml_document& document, double sagitta, bool north_first)
    : sagitta_(sagitta), north_first_(north_first) {
  index(document);
}

// Without recursion: the document may be nested as deep as its author liked.
void GmlShapes::index(const pugi::xml_node& root) {
  std::size_t uses = 0;  // shapes, and links to them
  for (auto node = root.first_child(); node && node != root;) {
    if (const auto id = attribute(node, "id"); !id.empty()) by_id_.try_emplace(id, node);
    if (is_leaf(node) || !attribute(node, "href").empty()) ++uses;
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != root && !node.next_sibling()) node = node.parent();
    if (node && node != root) node = node.next_sibling();
  }
  left_ = kUsesOfAShape * (uses + 1);
}

void GmlShapes::append(const pugi::xml_node& node, IndoorObject& object) {
  walk(node, 0, object);
}

void GmlShapes::walk(const pugi::xml_node& node, int depth, IndoorObject& object) {
  if (left_ == 0 || !object.problem.empty()) return;
  if (depth > kDeepest) {
    object.problem = "its geometry is nested too deep, or refers to itself";
    return;
  }
  if (is_leaf(node)) return add_leaf(node, object);
  const auto link = attribute(node, "href");
  if (!node.first_child() && link.starts_with("#")) {
    --left_;
    const auto target = by_id_.find(link.substr(1));
    if (target != by_id_.end()) return walk(target->second, depth + 1, object);
    object.problem = "it refers to '" + std::string(link) + "', which the document does not hold";
    return;
  }
  const bool solid = local_name(node) == "Solid";
  for (const auto& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    if (solid && local_name(child) == "interior") continue;
    walk(child, depth + 1, object);
  }
}

void GmlShapes::add_leaf(const pugi::xml_node& node, IndoorObject& object) {
  --left_;
  std::ostringstream element;
  node.print(element, "", pugi::format_raw);
  SourceGeometry geometry;
  if (const auto problem = append_gml(element.str(), sagitta_, geometry); !problem.empty()) {
    object.problem = "its " + std::string(local_name(node)) + " cannot be read: " + problem;
    return;
  }
  object.has_heights = object.has_heights || !geometry.zs.empty();
  append_paths(geometry, north_first_, object);
}

}  // namespace mapwright::converter
