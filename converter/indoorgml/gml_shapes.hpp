// Private to this folder: the geometries in elements of a GML document.
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "converter/indoorgml/indoor_document.hpp"

namespace mapwright::converter {

/// An element's name without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node);

/// Value of an attribute by its local name; empty where there is none.
std::string_view attribute(const pugi::xml_node& node, std::string_view name);

/// Collects faces and lines. GDAL reads each polygon and line; what holds them together (solids,
/// shells, composites, orientable surfaces) is walked through, and links within the document are
/// followed. Inner shells of solids, which are holes in the air, are passed over.
class GmlShapes {
 public:
  GmlShapes(const pugi::xml_document& document, double sagitta, bool north_first);

  /// Appends what is in `node` to the object; sets its `problem` where something cannot be read.
  void append(const pugi::xml_node& node, IndoorObject& object);

  /// True where links led to more geometries than an honest document has.
  bool is_exhausted() const { return left_ == 0; }

 private:
  void walk(const pugi::xml_node& node, int depth, IndoorObject& object);
  void add_leaf(const pugi::xml_node& node, IndoorObject& object);
  void index(const pugi::xml_node& root);

  std::unordered_map<std::string_view, pugi::xml_node> by_id_;
  std::size_t left_ = 0;  // shapes and links that may still be read
  double sagitta_;
  bool north_first_;
};

}  // namespace mapwright::converter
