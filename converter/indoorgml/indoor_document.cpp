#include "converter/indoorgml/indoor_document.hpp"

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <set>

#include "converter/gdal/gml_geometry.hpp"
#include "converter/gdal/stored_file.hpp"
#include "converter/indoorgml/gml_shapes.hpp"

namespace mapwright::converter {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlank);
  if (first == text.npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

std::string lower(std::string text) {
  for (char& c : text) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

// What editors write into descriptions: storey="F1":type="stairs", level=4; …
std::string token_of(const std::string& text, std::initializer_list<const char*> keys) {
  const std::string low = lower(text);
  for (const char* key : keys) {
    const auto at = low.find(std::string(key) + "=");
    if (at == low.npos) continue;
    auto rest = std::string_view(text).substr(at + std::string_view(key).size() + 1);
    if (rest.starts_with('"')) return trimmed(rest.substr(1, rest.find('"', 1) - 1));
    return trimmed(rest.substr(0, rest.find_first_of(":;, \t\r\n")));
  }
  return {};
}

enum class Space { kNone, kCell, kBoundary, kGraph };

// By the member that holds it: kinds of cells and boundaries are extended freely.
Space space_of_member(const pugi::xml_node& node) {
  const std::string name = lower(std::string(local_name(node)));
  if (name == "cellspacemember") return Space::kCell;
  if (name == "cellspaceboundarymember") return Space::kBoundary;
  if (name == "statemember" || name == "transitionmember") return Space::kGraph;
  return Space::kNone;
}

void add_link(const pugi::xml_node& node, std::vector<std::string>& ids) {
  const auto link = attribute(node, "href");
  if (link.starts_with("#")) ids.emplace_back(link.substr(1));
}

class DocumentReader {
 public:
  DocumentReader(const pugi::xml_document& xml, double sagitta_m)
      : xml_(xml), sagitta_m_(sagitta_m) {
    find_crs();
  }

  Result<IndoorDocument> read() {
    GmlShapes shapes(xml_, sagitta_m_ / document_.crs.metres_per_unit, north_first_);
    shapes_ = &shapes;
    walk(xml_, 0);
    if (shapes.is_exhausted()) {
      return input_failure("its geometries refer to each other without end");
    }
    if (document_.cells.empty() && document_.boundaries.empty()) {
      return input_failure("the IndoorGML document holds no cell and no boundary");
    }
    return std::move(document_);
  }

 private:
  static constexpr int kDeepest = 32;

  void find_crs() {
    std::set<std::string> names;
    std::string first;
    struct Walker : pugi::xml_tree_walker {
      std::set<std::string>* names = nullptr;
      std::string* first = nullptr;
      bool for_each(pugi::xml_node& node) override {
        const auto name = trimmed(attribute(node, "srsName"));
        if (!name.empty() && names->insert(name).second && first->empty()) *first = name;
        return true;
      }
    } walker;
    walker.names = &names;
    walker.first = &first;
    pugi::xml_node root = xml_;
    root.traverse(walker);
    if (first.empty()) return;
    auto known = gml_crs(first);
    north_first_ = known.north_first;
    document_.crs = std::move(known.crs);
    if (!document_.crs.is_stated()) {
      document_.warnings.push_back("its srsName '" + first + "' is no CRS that is known here");
    } else if (names.size() > 1) {
      document_.warnings.push_back("it states several CRSs: all coordinates are taken to be in " +
                                   first);
    }
  }

  void walk(const pugi::xml_node& node, int depth) {
    if (depth > kDeepest) return;
    for (const auto& child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      const auto space = space_of_member(child);
      if (space == Space::kNone) {
        walk(child, depth + 1);
        continue;
      }
      for (const auto& object : child.children()) {
        if (object.type() == pugi::node_element) list_of(space).push_back(read_object(object));
      }
    }
  }

  std::vector<IndoorObject>& list_of(Space space) {
    if (space == Space::kCell) return document_.cells;
    return space == Space::kBoundary ? document_.boundaries : document_.graph;
  }

  IndoorObject read_object(const pugi::xml_node& node) {
    IndoorObject object;
    object.id = attribute(node, "id");
    object.type = local_name(node);
    for (const auto& child : node.children()) read_property(child, object);
    if (object.storey.empty()) {
      object.storey = token_of(object.description, {"storey", "story", "level", "floor"});
    }
    if (object.usage.empty())
      object.usage = token_of(object.description, {"usage", "type", "indoor", "room"});
    return object;
  }

  void read_property(const pugi::xml_node& node, IndoorObject& object) {
    const auto name = local_name(node);
    const auto text = [&] { return trimmed(node.text().get()); };
    if (name == "name" && object.name.empty()) object.name = text();
    if (name == "description") object.description = text();
    if (name == "level" || name == "storey" || name == "floor") object.storey = text();
    if (name == "class") object.use_class = text();
    if (name == "function") object.function = text();
    if (name == "usage") object.usage = text();
    if (name == "duality") add_link(node, object.duals);
    if (name == "connects") add_link(node, object.connects);
    if (name == "partialboundedBy") add_link(node, object.boundaries);
    const std::string low = lower(std::string(name));
    if (low == "cellspacegeometry" || low == "cellspaceboundarygeometry" || low == "geometry" ||
        low == "geometry2d" || low == "geometry3d") {
      append_geometry(node, object);
    }
  }

  // Where a cell has both, its solid says more than its polygon.
  void append_geometry(const pugi::xml_node& node, IndoorObject& object) {
    for (const auto& child : node.children()) {
      if (lower(std::string(local_name(child))) == "geometry3d")
        return shapes_->append(child, object);
    }
    if (object.faces.empty()) shapes_->append(node, object);
  }

  const pugi::xml_document& xml_;
  double sagitta_m_;
  bool north_first_ = false;
  GmlShapes* shapes_ = nullptr;
  IndoorDocument document_;
};

}  // namespace

Result<IndoorDocument> read_indoor_document(const std::string& path, double sagitta_m) {
  auto content = stored_content(path);
  if (!content) return input_failure("cannot be read");
  pugi::xml_document xml;
  const auto parsed = xml.load_buffer_inplace(content->data(), content->size());
  if (!parsed) {
    return input_failure("the XML is damaged at byte " + std::to_string(parsed.offset) + ": " +
                         parsed.description());
  }
  return DocumentReader(xml, sagitta_m).read();
}

}  // namespace mapwright::converter
