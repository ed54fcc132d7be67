// DXF (AutoCAD 2000): a layer a kind, polylines as thick as they are high, fields as extended data.
#include <cstdio>
#include <fstream>

#include "converter/exchange/carried_fields.hpp"
#include "converter/exchange/decimal_text.hpp"
#include "converter/exchange/fields.hpp"
#include "converter/exporters/gis/placed_layers.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kMostExtendedText = 250;  // DXF: 255 bytes

struct LayerColour {
  std::string_view name;
  int colour;  // AutoCAD colour index
};
constexpr LayerColour kLayers[] = {{"0", 7},     {"border", 1}, {"solids", 8},
                                   {"walls", 5}, {"steps", 30}, {"ramps", 3}};

// Group codes and values, line by line; every object gets a handle of its own.
class DxfWriter {
 public:
  explicit DxfWriter(std::ostream& out) : out_(out) {}

  void write(const std::vector<GisLayer>& layers) {
    write_header();
    write_tables();
    write_blocks();
    section("ENTITIES");
    for (const auto& layer : layers) {
      std::vector<std::string> names;
      for (const auto& column : layer.columns) names.push_back(column.name);
      for (const auto& feature : layer.features) {
        if (feature.geometry != GisGeometry::kNone) write_polyline(layer.name, names, feature);
      }
    }
    end_section();
    write_objects();
    pair(0, "EOF");
  }

 private:
  void pair(int code, std::string_view value) { out_ << code << '\n' << value << '\n'; }
  void pair(int code, const char* value) { pair(code, std::string_view(value)); }
  void pair(int code, int value) { pair(code, std::to_string(value)); }
  void pair(int code, double value) { pair(code, shortest_decimal(value)); }
  void section(std::string_view name) {
    pair(0, "SECTION");
    pair(2, name);
  }
  void end_section() { pair(0, "ENDSEC"); }

  static std::string hex(int handle) {
    char text[16];
    std::snprintf(text, sizeof text, "%X", static_cast<unsigned>(handle));
    return text;
  }
  std::string next_handle() { return hex(next_handle_++); }

  void write_header() {
    section("HEADER");
    pair(9, "$ACADVER");
    pair(1, "AC1015");
    pair(9, "$HANDSEED");
    pair(5, "7FFFFFFF");
    pair(9, "$INSUNITS");
    pair(70, 6);  // metres
    pair(9, "$MEASUREMENT");
    pair(70, 1);  // metric
    end_section();
  }

  void begin_table(std::string_view name, const std::string& handle, int count) {
    pair(0, "TABLE");
    pair(2, name);
    pair(5, handle);
    pair(330, "0");
    pair(100, "AcDbSymbolTable");
    pair(70, count);
  }
  void begin_record(std::string_view type, const std::string& owner, std::string_view subclass) {
    pair(0, type);
    pair(type == "DIMSTYLE" ? 105 : 5, next_handle());
    pair(330, owner);
    pair(100, "AcDbSymbolTableRecord");
    pair(100, subclass);
  }
  void end_table() { pair(0, "ENDTAB"); }

  void write_tables() {
    section("TABLES");
    begin_table("VPORT", "8", 0);
    end_table();
    write_line_types();
    write_layers();
    write_text_style();
    begin_table("VIEW", "6", 0);
    end_table();
    begin_table("UCS", "7", 0);
    end_table();
    write_applications();
    begin_table("DIMSTYLE", "A", 0);
    pair(100, "AcDbDimStyleTable");
    end_table();
    begin_table("BLOCK_RECORD", "1", 2);
    write_block_record(kModelSpace, "*Model_Space");
    write_block_record(kPaperSpace, "*Paper_Space");
    end_table();
    end_section();
  }

  void write_line_types() {
    begin_table("LTYPE", "5", 3);
    for (const char* name : {"ByBlock", "ByLayer", "Continuous"}) {
      begin_record("LTYPE", "5", "AcDbLinetypeTableRecord");
      pair(2, name);
      pair(70, 0);
      pair(3, "");
      pair(72, 65);
      pair(73, 0);
      pair(40, 0.0);
    }
    end_table();
  }

  void write_layers() {
    begin_table("LAYER", "2", static_cast<int>(std::size(kLayers)));
    for (const auto& layer : kLayers) {
      begin_record("LAYER", "2", "AcDbLayerTableRecord");
      pair(2, layer.name);
      pair(70, 0);
      pair(62, layer.colour);
      pair(6, "Continuous");
    }
    end_table();
  }

  void write_text_style() {
    begin_table("STYLE", "3", 1);
    begin_record("STYLE", "3", "AcDbTextStyleTableRecord");
    pair(2, "Standard");
    pair(70, 0);
    pair(40, 0.0);
    pair(41, 1.0);
    pair(50, 0.0);
    pair(71, 0);
    pair(42, 2.5);
    pair(3, "txt");
    pair(4, "");
    end_table();
  }

  void write_applications() {
    begin_table("APPID", "9", 2);
    for (const std::string_view name : {std::string_view("ACAD"), kCarrierMark}) {
      begin_record("APPID", "9", "AcDbRegAppTableRecord");
      pair(2, name);
      pair(70, 0);
    }
    end_table();
  }

  void write_block_record(int handle, std::string_view name) {
    pair(0, "BLOCK_RECORD");
    pair(5, hex(handle));
    pair(330, "1");
    pair(100, "AcDbSymbolTableRecord");
    pair(100, "AcDbBlockTableRecord");
    pair(2, name);
  }

  void write_blocks() {
    section("BLOCKS");
    write_block(kModelSpace, "*Model_Space");
    write_block(kPaperSpace, "*Paper_Space");
    end_section();
  }

  void write_block(int owner, std::string_view name) {
    begin_entity("BLOCK", hex(owner), "0");
    pair(100, "AcDbBlockBegin");
    pair(2, name);
    pair(70, 0);
    pair(10, 0.0);
    pair(20, 0.0);
    pair(30, 0.0);
    pair(3, name);
    pair(1, "");
    begin_entity("ENDBLK", hex(owner), "0");
    pair(100, "AcDbBlockEnd");
  }

  void begin_entity(std::string_view type, const std::string& owner, std::string_view layer) {
    pair(0, type);
    pair(5, next_handle());
    pair(330, owner);
    pair(100, "AcDbEntity");
    pair(8, layer);
  }

  void write_polyline(const std::string& layer, const std::vector<std::string>& names,
                      const GisFeature& feature) {
    const auto& path = feature.paths.front();
    const bool closed = feature.geometry == GisGeometry::kPolygon;
    begin_entity("LWPOLYLINE", hex(kModelSpace), layer);
    pair(100, "AcDbPolyline");
    pair(90, static_cast<int>(path.size()));
    pair(70, closed ? 1 : 0);
    if (feature.height_m != 0.0) pair(39, feature.height_m);
    for (const Point p : path) {
      pair(10, p.x);
      pair(20, p.y);
    }
    pair(1001, kCarrierMark);
    for (std::string item : carried_items(names, feature.values)) {
      for (; item.size() > kMostExtendedText; item = "+" + item.substr(kMostExtendedText)) {
        pair(1000, std::string_view(item).substr(0, kMostExtendedText));
      }
      pair(1000, std::string_view(item));
    }
  }

  void write_objects() {
    section("OBJECTS");
    pair(0, "DICTIONARY");
    pair(5, "C");
    pair(330, "0");
    pair(100, "AcDbDictionary");
    pair(281, 1);
    pair(3, "ACAD_GROUP");
    pair(350, "D");
    pair(0, "DICTIONARY");
    pair(5, "D");
    pair(330, "C");
    pair(100, "AcDbDictionary");
    pair(281, 1);
    end_section();
  }

  static constexpr int kModelSpace = 0x20;
  static constexpr int kPaperSpace = 0x21;
  std::ostream& out_;
  int next_handle_ = 0x100;
};

}  // namespace

Result<Exported> export_dxf(const ExportJob& job) {
  auto placed = placed_layers(job, std::string(kMapCoordinates), false);
  if (!placed) return tl::unexpected(placed.error());
  const std::string name = job.stem + ".dxf";
  std::ofstream out(job.folder + "/" + name, std::ios::binary);
  DxfWriter(out).write(placed->layers);
  out.close();
  if (!out) return output_failure(name + ": cannot be written to its end");
  for (auto& warning : warning_of_empty(placed->layers, "DXF")) {
    placed->warnings.push_back(std::move(warning));
  }
  return Exported{{name}, std::move(placed->warnings)};
}

}  // namespace mapwright::converter
