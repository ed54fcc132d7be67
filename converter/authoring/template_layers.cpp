#include "converter/authoring/template_layers.hpp"

namespace mapwright::converter {
namespace {

constexpr FieldType kText = FieldType::kText;
constexpr FieldType kReal = FieldType::kReal;
constexpr FieldType kInteger = FieldType::kInteger;

constexpr ListedValue kInOutValues[] = {{"0", "indoor"}, {"1", "outdoor"}};
constexpr ListedValue kBuildingKinds[] = {
    {"building", "building"}, {"column", "column"}, {"shed", "shed"}, {"tank", "tank"}};
constexpr ListedValue kFurnitureKinds[] = {{"furniture", "furniture"},
                                           {"bench", "bench"},
                                           {"column", "column"},
                                           {"flowerpot", "flowerpot"},
                                           {"tree", "tree"},
                                           {"bollard", "bollard"},
                                           {"bin", "bin"},
                                           {"lamp post", "lamp post"}};
constexpr ListedValue kWallKinds[] = {{"wall", "wall"},
                                      {"fence", "fence"},
                                      {"railing", "railing"},
                                      {"hedge", "hedge"},
                                      {"kerb", "kerb"}};

constexpr FieldDomain kInOut{"in_out", "inside of a building or outside", kInteger, kInOutValues};
constexpr FieldDomain kBuildingKind{"building_kind", "what stands there", kText, kBuildingKinds};
constexpr FieldDomain kFurnitureKind{"furniture_kind", "what stands there", kText, kFurnitureKinds};
constexpr FieldDomain kWallKind{"wall_kind", "what bars the way", kText, kWallKinds};
constexpr FieldDomain kHeight{"height_m", "metres above the ground beside it", kReal, {}, 0.02,
                              500.0};
constexpr FieldDomain kBase{
    "base_height_m", "metres from the ground to its underside", kReal, {}, 0.0, 500.0};
constexpr FieldDomain kRise{"rise_m", "height of one step, metres", kReal, {}, 0.02, 0.5};
constexpr FieldDomain kCount{"step_count", "number of steps", kInteger, {}, 1, 1000};
constexpr FieldDomain kAzimuth{"azimuth_deg", "degrees clockwise from grid north", kReal, {}, 0.0,
                               360.0};
constexpr FieldDomain kSlope{"slope_deg", "degrees from the horizontal", kReal, {}, 0.0, 45.0};

constexpr const FieldDomain* kDomains[] = {&kInOut,   &kBuildingKind, &kFurnitureKind, &kWallKind,
                                           &kHeight,  &kBase,         &kRise,          &kCount,
                                           &kAzimuth, &kSlope};

constexpr TemplateField kName{"name", "name (of a place, unique)", kText};
constexpr TemplateField kSemantic{"semantic", "further labels, with commas", kText};
constexpr TemplateField kSegmentSemantic{"segment_semantic", "labels of its segments", kText};
constexpr TemplateField kSide{"in_out", "indoor or outdoor", kInteger, &kInOut, "1"};
constexpr TemplateField kUnderside{"base_height", "height of its underside (m), 0 on the ground",
                                   kReal, &kBase};

// The frame of the map stands in the border's fields, so that what is drawn converts without
// options.
constexpr TemplateField kBorderFields[] = {
    {"mapwright", "version of this template", kInteger},
    {"frame", "projection of the map: tmerc or enu", kText},
    {"origin_lat", "latitude of the map's origin (deg)", kReal},
    {"origin_lon", "longitude of the map's origin (deg)", kReal},
    {"origin_h", "height of the map's origin (m)", kReal},
    {"heading", "of the map's +y axis, clockwise from true north (deg)", kReal},
    {"resolution", "coordinates of the map are rounded to (m)", kReal},
};
constexpr TemplateField kBuildingFields[] = {kName,
                                             {"kind", "kind", kText, &kBuildingKind, "building"},
                                             {"height", "height (m)", kReal, &kHeight, "3.0"},
                                             kUnderside,
                                             kSide,
                                             kSemantic,
                                             kSegmentSemantic};
constexpr TemplateField kFurnitureFields[] = {kName,
                                              {"kind", "kind", kText, &kFurnitureKind, "furniture"},
                                              {"height", "height (m)", kReal, &kHeight, "0.8"},
                                              kUnderside,
                                              kSide,
                                              kSemantic,
                                              kSegmentSemantic};
constexpr TemplateField kWallFields[] = {kName,
                                         {"kind", "kind", kText, &kWallKind, "wall"},
                                         {"height", "height (m)", kReal, &kHeight, "2.0"},
                                         kUnderside,
                                         kSide,
                                         kSemantic,
                                         kSegmentSemantic};
constexpr TemplateField kStairsFields[] = {
    kName,
    {"stair_id", "flight (ties step lines to it)", kText},
    {"steps", "number of steps", kInteger, &kCount},
    {"direction_deg", "upwards, clockwise from grid north (deg)", kReal, &kAzimuth},
    {"rise", "rise of one step (m)", kReal, &kRise, "0.17"},
    kSide,
    kSemantic};
constexpr TemplateField kStepFields[] = {
    kName,
    {"stair_id", "flight that the step belongs to", kText},
    {"step_no", "number from the bottom", kInteger, &kCount},
    {"rise", "rise of this step (m)", kReal, &kRise, "0.17"},
    {"height", "its upper edge above the foot of the flight (m)", kReal, &kHeight},
    kSide,
    kSemantic};
constexpr TemplateField kRampFields[] = {
    kName,
    {"slope_deg", "slope (deg)", kReal, &kSlope},
    {"aspect_deg", "downwards, clockwise from grid north (deg)", kReal, &kAzimuth},
    {"nx", "surface normal, east", kReal},
    {"ny", "surface normal, north", kReal},
    {"nz", "surface normal, up", kReal},
    kSide,
    kSemantic};

constexpr TemplateLayer kLayers[] = {
    {"border", "limits of the map: one box; its fields say where the map lies",
     TemplateGeometry::kPolygon, kBorderFields},
    {"ramps", "footprints of ramps, with slope and the direction downwards",
     TemplateGeometry::kPolygon, kRampFields},
    {"stairs", "outlines of straight flights, with the number of steps and the direction upwards",
     TemplateGeometry::kPolygon, kStairsFields},
    {"buildings", "outlines of what is solid, courtyards as holes", TemplateGeometry::kPolygon,
     kBuildingFields},
    {"furniture", "outlines of benches, columns, flowerpots and their like",
     TemplateGeometry::kPolygon, kFurnitureFields},
    {"steps", "edges of single steps, lower ground on the right of the drawing direction",
     TemplateGeometry::kLine, kStepFields},
    {"walls", "walls and fences, free space on the right of the drawing direction",
     TemplateGeometry::kLine, kWallFields},
};

}  // namespace

std::span<const TemplateLayer> template_layers() {
  return kLayers;
}

std::span<const FieldDomain* const> template_domains() {
  return kDomains;
}

}  // namespace mapwright::converter
