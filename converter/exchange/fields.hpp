// Fields of exported layers: what `export` writes and the rules `mapwright` read back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mapcore/map.hpp"

namespace mapwright::converter {

/// Names of at most ten characters, so that shapefiles keep them; `segment_semantic` is cut there
/// to what rules find it by (docs/round-trip.md says what each holds).
namespace exchange_field {
inline constexpr std::string_view kId = "id";
inline constexpr std::string_view kPos = "pos";
inline constexpr std::string_view kPart = "part";
inline constexpr std::string_view kShape = "shape";
inline constexpr std::string_view kKind = "kind";
inline constexpr std::string_view kHeight = "height";
inline constexpr std::string_view kInOut = "in_out";
inline constexpr std::string_view kSemantic = "semantic";
inline constexpr std::string_view kSegmentSemantic = "segment_semantic";
inline constexpr std::string_view kFreeSide = "free_side";
inline constexpr std::string_view kRuns = "runs";
inline constexpr std::string_view kHeights = "heights";
inline constexpr std::string_view kInOuts = "in_outs";
inline constexpr std::string_view kSegmentSemantics = "seg_sems";
inline constexpr std::string_view kHoles = "holes";

inline constexpr std::string_view kVersion = "mapwright";
inline constexpr std::string_view kFrame = "frame";
inline constexpr std::string_view kCrs = "crs";
inline constexpr std::string_view kOriginLatitude = "origin_lat";
inline constexpr std::string_view kOriginLongitude = "origin_lon";
inline constexpr std::string_view kOriginHeight = "origin_h";
inline constexpr std::string_view kHeading = "heading";
inline constexpr std::string_view kResolution = "resolution";

/// All of them; no token of a semantic string gets a field of the same name.
inline constexpr std::string_view kAll[] = {kId,
                                            kPos,
                                            kPart,
                                            kShape,
                                            kKind,
                                            kHeight,
                                            kInOut,
                                            kSemantic,
                                            kSegmentSemantic,
                                            kFreeSide,
                                            kRuns,
                                            kHeights,
                                            kInOuts,
                                            kSegmentSemantics,
                                            kHoles,
                                            kVersion,
                                            kFrame,
                                            kCrs,
                                            kOriginLatitude,
                                            kOriginLongitude,
                                            kOriginHeight,
                                            kHeading,
                                            kResolution};
}  // namespace exchange_field

/// Text after which formats without fields of their own (DXF) carry them: see `read_carried_items`.
inline constexpr std::string_view kCarrierMark = "MAPWRIGHT";

/// `crs` of a border whose coordinates are metres of the map frame; `frame` of a map that has no
/// place on Earth.
inline constexpr std::string_view kMapCoordinates = "map";
inline constexpr std::string_view kLocalFrame = "local";

/// What the name of a shapefile with an export's lines has more than that of its polygons.
inline constexpr std::string_view kLinesSuffix = "_lines";

/// `shape` of the border's feature.
inline constexpr std::string_view kBorderShape = "border";

/// "closed_polygon" … "ramp" for ST 1 … 6.
std::string_view shape_name(ShapeType type);
std::optional<ShapeType> shape_named(std::string_view name);

/// True if a token `key=value` of a semantic string gets a field of its own: its name is short
/// enough for a shapefile, and no name of ours or of a format.
bool can_be_token_field(std::string_view key);

/// Name of the field that a text goes on in where the format keeps short texts only; `number`
/// counts from 2: "semantic_2", "segment__2".
std::string continued_field(const std::string& name, int number);

}  // namespace mapwright::converter
