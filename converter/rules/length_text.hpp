// Lengths as people write them into text fields.
#pragma once

#include <optional>
#include <string_view>

namespace mapwright::converter {

/// Metres of "7 m", "3.5", "3,5 m", "350 cm", "12 ft", "12'6\"", "~4m". A number without unit is
/// multiplied by `metres_per_unit`. Nothing for any other text.
std::optional<double> length_from_text(std::string_view text, double metres_per_unit);

/// A plain number, with '.' or ',' as decimal point and blanks around it. Nothing for other texts.
std::optional<double> number_from_text(std::string_view text);

/// Reads a steepness as degrees, the sign kept: "8%", "-12°", "7" (degrees). Nothing for other
/// texts, "up" and "down" included.
std::optional<double> slope_deg_from_text(std::string_view text);

}  // namespace mapwright::converter
