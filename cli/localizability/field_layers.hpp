// A localizability field as bands and areas for GIS programs, and as colours for pictures.
#pragma once

#include <vector>

#include "converter/exporters/field.hpp"
#include "converter/exporters/picture.hpp"
#include "navcore/localizability/filter_confirmation.hpp"
#include "navcore/localizability/localizability.hpp"

namespace mapwright::cli {

/// Which heading of the robot a value is for.
enum class AtHeading { kWorst, kMedian };

/// What a picture shows.
enum class Shown { kAccuracy, kEdges, kHeading, kRisk };

/// A standard deviation greater than this (metres or degrees) or unknown is written as this.
inline constexpr double kUnknownDeviation = 1000.0;

/// Bands: position_sd_major_m, position_sd_minor_m, direction_deg, heading_sd_deg,
/// with_edges_major_m, alias_risk, alias_distance_m, robot_heading_deg.
converter::Field field_bands(const navcore::LocalizabilityField& field, AtHeading at);

/// The layer weak_areas: polygons of joined cells with kind, area and what is wrong.
converter::GisLayer weak_area_layer(const navcore::LocalizabilityField& field,
                                    const std::vector<navcore::WeakArea>& areas,
                                    const converter::Field& bands);

/// Colours of one quantity, short strokes along the direction known least where the position is
/// known less well than `limit_m`, and a legend.
converter::Overlay field_overlay(const navcore::LocalizabilityField& field, AtHeading at,
                                 Shown shown, double limit_m);

/// Discs at the places where filters ran, coloured by the error seen as the field is by the error
/// predicted: where the two agree, a disc is hard to see but for its rim.
void add_seen(const navcore::Confirmation& confirmation, converter::Overlay& overlay);

}  // namespace mapwright::cli
