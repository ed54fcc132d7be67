// One drawer a schema; overlays.cpp has the table of them.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "converter/exporters/picture.hpp"

namespace mapwright::cli {

using Json = nlohmann::ordered_json;

// All throw Json::exception where the answer is not as its schema says.

Point point_of(const Json& xy);  ///< [x, y]
Pose pose_of(const Json& pose);  ///< {"x", "y", "theta_deg"}

/// Adds a line to the legend unless one of that text is there.
void add_legend(converter::Overlay& overlay, converter::OverlayItem sample, std::string text);

void draw_scans(const Json& answer, converter::Overlay& overlay);
void draw_localization(const Json& answer, converter::Overlay& overlay,
                       std::optional<std::size_t> iteration);
void draw_plan(const Json& answer, converter::Overlay& overlay);
void draw_findings(const Json& answer, converter::Overlay& overlay);

/// Rays of one scan and where they end. `angles_deg` count from the heading.
void add_scan(converter::Overlay& overlay, const Pose& pose, std::span<const double> angles_deg,
              std::span<const double> ranges_m, double max_range_m);

/// A robot, and what it stands for in the legend.
void add_robot(converter::Overlay& overlay, const Pose& pose, double radius_pt,
               converter::Colour colour, std::string meaning);

inline constexpr auto kRobotColour = converter::Colour::from_hex(0x0B3C5D);

}  // namespace mapwright::cli
