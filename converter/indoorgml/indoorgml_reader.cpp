#include "converter/indoorgml/indoorgml_reader.hpp"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include "converter/gdal/stored_file.hpp"
#include "converter/indoorgml/footprint.hpp"
#include "converter/indoorgml/indoor_document.hpp"
#include "converter/indoorgml/storey_plan.hpp"
#include "converter/indoorgml/storeys.hpp"
#include "converter/source/document_reader.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {
namespace {

enum Field {
  kId,
  kType,
  kName,
  kDescription,
  kStorey,
  kClass,
  kFunction,
  kUsage,
  kRole,
  kHeight,
  kBaseHeight
};

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> names{"gml_id", "type",   "name",       "description",
                                              "storey", "class",  "function",   "usage",
                                              "role",   "height", "base_height"};
  return names;
}

constexpr double kStep_m = 0.05;  // a floor as much above the storey's is on it
constexpr const char* kOthersHaveTheWalls =
    "part of the building whose walls are those of other parts, or openings";

void append_path(const std::vector<Point>& points, PathRole role, SourceGeometry& geometry) {
  geometry.paths.push_back({static_cast<std::uint32_t>(geometry.xs.size()),
                            static_cast<std::uint32_t>(points.size()), role, false});
  for (const Point p : points) {
    geometry.xs.push_back(p.x);
    geometry.ys.push_back(p.y);
  }
}

std::vector<Point> closed(const VertexPath& ring) {
  std::vector<Point> points;
  for (const auto& v : ring) points.push_back({v.x, v.y});
  points.push_back(points.front());
  return points;
}

class IndoorGmlReader : public DocumentReader {
 public:
  explicit IndoorGmlReader(IndoorDocument document)
      : DocumentReader("IndoorGML"), document_(std::move(document)) {
    for (auto& warning : std::exchange(document_.warnings, {})) warn(std::move(warning));
    for (const auto& cell : document_.cells) footprints_.push_back(footprint_of(cell));
    auto storeys = storeys_of(document_, footprints_);
    const bool several = storeys.size() > 1;
    for (auto& storey : storeys) {
      LayerInfo info = layer(several ? "IndoorGML storey " + storey.name : "IndoorGML");
      info.declared_features =
          static_cast<std::int64_t>(storey.cells.size() + storey.boundaries.size());
      if (several) info.storey = storey.name;
      add_layer(std::move(info));
      plans_.push_back(std::make_unique<StoreyPlan>(document_, footprints_, std::move(storey),
                                                    document_.crs.metres_per_unit));
    }
    warn_of_idle_doors();
    if (document_.graph.empty()) return;
    LayerInfo graph = layer("IndoorGML graph");
    graph.declared_features = static_cast<std::int64_t>(document_.graph.size());
    add_layer(std::move(graph));
  }

 private:
  void warn_of_idle_doors() {
    std::vector<std::string> doors;
    for (const auto& plan : plans_) {
      doors.insert(doors.end(), plan->idle_doors().begin(), plan->idle_doors().end());
    }
    if (doors.empty()) return;
    const bool one = doors.size() == 1;
    warn(
        std::to_string(doors.size()) +
        (one ? " door lies at no wall and opens none (" : " doors lie at no wall and open none (") +
        doors.front() + (one ? "" : " …") + "): rooms behind may be shut; the ledger names each");
  }

  LayerInfo layer(std::string name) const {
    LayerInfo info;
    info.name = std::move(name);
    info.fields = field_names();
    info.crs = document_.crs;
    return info;
  }

  void each(std::size_t layer, const ReadOptions*, const FeatureVisitor& visit) override {
    SourceFeature feature;
    if (layer == plans_.size()) {
      for (std::size_t i = 0; i < document_.graph.size(); ++i) {
        make_graph(i, feature);
        visit(feature);
      }
      return;
    }
    const auto& plan = *plans_[layer];
    for (const std::size_t cell : plan.storey().cells) {
      make_cell(plan, cell, feature);
      visit(feature);
    }
    for (const std::size_t boundary : plan.storey().boundaries) {
      make_boundary(plan, boundary, feature);
      visit(feature);
    }
  }

  void begin(const IndoorObject& object, std::size_t number, const char* role,
             SourceFeature& feature) const {
    feature = SourceFeature();
    feature.fid = static_cast<std::int64_t>(number) + 1;
    feature.values.resize(field_names().size());
    const auto set = [&](Field field, const std::string& text) {
      if (!text.empty()) feature.values[field] = text;
    };
    set(kId, object.id);
    set(kType, object.type);
    set(kName, object.name);
    set(kDescription, object.description);
    set(kStorey, object.storey);
    set(kClass, object.use_class);
    set(kFunction, object.function);
    set(kUsage, object.usage);
    set(kRole, role);
    feature.broken = object.problem;
  }

  void make_cell(const StoreyPlan& plan, std::size_t cell, SourceFeature& feature) const {
    const auto& object = document_.cells[cell];
    const auto& print = footprints_[cell];
    const bool is_room = role_of_cell(object) == IndoorRole::kRoom;
    begin(object, cell, is_room ? "room" : "object", feature);
    if (!feature.broken.empty()) return;
    if (!print) {
      (object.faces.empty() ? feature.geometry.type : feature.broken) =
          object.faces.empty() ? "" : "its solid has no floor: no face of it looks down";
      return;
    }
    if (plan.storey().floor && feature.values[kStorey].index() == 0) {
      feature.values[kStorey] = plan.storey().name;
    }
    if (print->top) feature.values[kHeight] = *print->top - *print->floor;
    if (plan.sill_of_cell(cell) > kStep_m) feature.values[kBaseHeight] = plan.sill_of_cell(cell);
    is_room ? set_walls(plan.walls_of_cell(cell), feature) : set_polygons(*print, feature);
  }

  static void set_walls(const std::vector<std::vector<Point>>& walls, SourceFeature& feature) {
    feature.geometry.type = "MULTILINESTRING";
    for (const auto& wall : walls) append_path(wall, PathRole::kLine, feature.geometry);
    if (walls.empty()) feature.geometry.unsupported = kOthersHaveTheWalls;
  }

  static void set_polygons(const Footprint& print, SourceFeature& feature) {
    feature.geometry.type = "MULTIPOLYGON";
    for (const auto& face : print.faces) {
      for (const auto& ring : face.rings) {
        const auto role = &ring == &face.rings[0] ? PathRole::kOuterRing : PathRole::kInnerRing;
        append_path(closed(ring), role, feature.geometry);
      }
    }
  }

  void make_boundary(const StoreyPlan& plan, std::size_t boundary, SourceFeature& feature) const {
    const auto& object = document_.boundaries[boundary];
    const bool is_opening = plan.is_opening(boundary);
    begin(object, document_.cells.size() + boundary, is_opening ? "opening" : "wall", feature);
    if (!feature.broken.empty()) return;
    if (object.faces.empty() && object.lines.empty()) return;
    if (auto remark = plan.remark_about_door(boundary); !remark.empty()) {
      feature.warnings.push_back(std::move(remark));
    }
    set_walls(is_opening ? ground_lines(object) : plan.walls_of_boundary(boundary), feature);
  }

  void make_graph(std::size_t i, SourceFeature& feature) const {
    const auto& object = document_.graph[i];
    begin(object, document_.cells.size() + document_.boundaries.size() + i, "graph", feature);
    for (const auto& line : object.lines) {
      std::vector<Point> points;
      for (const auto& v : line) points.push_back({v.x, v.y});
      append_path(points, points.size() == 1 ? PathRole::kPoint : PathRole::kLine,
                  feature.geometry);
    }
    feature.geometry.type = object.lines.empty() ? "" : "LINESTRING";
  }

  IndoorDocument document_;
  std::vector<std::optional<Footprint>> footprints_;
  std::vector<std::unique_ptr<StoreyPlan>> plans_;
};

}  // namespace

bool is_indoorgml(const std::string& path) {
  std::array<char, 4096> start{};
  const auto size = StoredFile(path).read(0, start.data(), start.size());
  const std::string_view text(start.data(), size);
  const auto root = text.find("IndoorFeatures");
  return root != text.npos && text.find("indoorgml") != text.npos && text.find('<') < root;
}

OpenedReader open_indoorgml(const std::string& path) {
  auto document = read_indoor_document(path, 0.9 * tolerance::kChordSagitta_m);
  if (!document) return input_failure(path + ": " + document.error().message);
  return std::make_unique<IndoorGmlReader>(*std::move(document));
}

}  // namespace mapwright::converter
