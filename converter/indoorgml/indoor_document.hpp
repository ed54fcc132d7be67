// IndoorGML documents as values.
#pragma once

#include <string>
#include <vector>

#include "converter/gdal/crs.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// A corner: x to the east, y to the north, z up, in the document's CRS.
struct Vertex {
  double x = 0.0, y = 0.0, z = 0.0;
};
using VertexPath = std::vector<Vertex>;

/// A polygon: its outer ring, then its holes. The last vertex of a ring is not the first again.
struct Face {
  std::vector<VertexPath> rings;
};

/// A cell, a boundary, or a node or an edge of the graph.
struct IndoorObject {
  std::string id, type, name, description;
  std::string storey;  ///< as stated; empty where nothing is
  std::string use_class, function, usage;
  std::vector<std::string> duals;       ///< ids of objects of the other space
  std::vector<std::string> connects;    ///< ids of the states that a transition joins
  std::vector<std::string> boundaries;  ///< ids of a cell's boundaries
  std::vector<Face> faces;
  std::vector<VertexPath> lines;  ///< points are lines of one vertex
  bool has_heights = false;       ///< its faces stand in space
  std::string problem;            ///< why its geometry cannot be read; empty for a sound one
};

struct IndoorDocument {
  std::vector<IndoorObject> cells, boundaries, graph;
  Crs crs;  ///< none for local coordinates
  std::vector<std::string> warnings;
};

/// Reads a document of IndoorGML 1.0 or 1.1, whatever prefixes its namespaces have, with links
/// within it followed. Arcs become chords nearer than `sagitta_m`. Fails (kInput) for what is no
/// such document, for damaged XML, and for links that go on and on; messages do not name the path.
Result<IndoorDocument> read_indoor_document(const std::string& path, double sagitta_m);

}  // namespace mapwright::converter
