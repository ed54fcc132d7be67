#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cli/localizability/field_layers.hpp"

namespace mapwright::cli {
namespace {

using converter::Colour;
using navcore::LocalizabilityField;

/// Values up to `most` have this colour.
struct Step {
  double most;
  const char* text;
  unsigned rgb;
};

// Cividis, from the light end to the dark one, then one colour for what is not known: its order can
// be read with any kind of colour vision, and in grey.
constexpr std::array<Step, 8> kMetres{{{0.01, "up to 1 cm", 0xFEE838},
                                       {0.02, "2 cm", 0xDCC748},
                                       {0.05, "5 cm", 0xB8A968},
                                       {0.1, "10 cm", 0x95907B},
                                       {0.3, "30 cm", 0x757575},
                                       {1.0, "1 m", 0x575D6D},
                                       {5.0, "5 m", 0x2F446B},
                                       {HUGE_VAL, "more or unknown", 0xB40F20}}};
constexpr std::array<Step, 8> kDegrees{{{0.02, "up to 0.02°", 0xFEE838},
                                        {0.05, "0.05°", 0xDCC748},
                                        {0.1, "0.1°", 0xB8A968},
                                        {0.2, "0.2°", 0x95907B},
                                        {0.5, "0.5°", 0x757575},
                                        {1.0, "1°", 0x575D6D},
                                        {5.0, "5°", 0x2F446B},
                                        {HUGE_VAL, "more or unknown", 0xB40F20}}};
constexpr std::array<Step, 6> kRisk{{{1e-6, "none found, or below 1e-6", 0xFEE838},
                                     {1e-3, "0.1 %", 0xC5B36A},
                                     {1e-2, "1 %", 0x95907B},
                                     {0.1, "10 %", 0x575D6D},
                                     {0.3, "30 %", 0x1D3A6B},
                                     {HUGE_VAL, "up to 50 %", 0xB40F20}}};

template <std::size_t N>
Colour colour_of(const std::array<Step, N>& steps, double value) {
  for (const Step& step : steps) {
    if (value <= step.most) return Colour::from_hex(step.rgb);
  }
  return Colour::from_hex(steps.back().rgb);
}

template <std::size_t N>
void add_steps(const std::array<Step, N>& steps, converter::Overlay& overlay) {
  for (const Step& step : steps) {
    const Colour colour = Colour::from_hex(step.rgb);
    overlay.legend.push_back(
        {converter::OverlayPath{{}, {{0.0, 0.0, 0.0, 0.0}, 0.0, {}}, true, colour}, step.text});
  }
}

template <std::size_t N, class Value>
void colour_field(const LocalizabilityField& field, const std::array<Step, N>& steps, Value&& value,
                  converter::Overlay& overlay) {
  converter::ColourField colours{field.grid.corner, field.grid.cell_m, field.grid.columns, {}};
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    colours.colours.push_back(field.stands[i] != 0 ? colour_of(steps, value(i))
                                                   : Colour{0.0, 0.0, 0.0, 0.0});
  }
  overlay.field = std::move(colours);
  add_steps(steps, overlay);
}

// One stroke in every so many cells of a side, along the direction known least.
void add_directions(const LocalizabilityField& field, AtHeading at, Shown shown, double limit_m,
                    converter::Overlay& overlay) {
  const auto every = static_cast<std::size_t>(std::max(1.0, std::round(2.5 / field.grid.cell_m)));
  converter::OverlaySegments strokes{{}, {Colour::from_hex(0xFFFFFF, 0.95), 1.0, {}}};
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    const bool chosen =
        i % field.grid.columns % every == every / 2 && i / field.grid.columns % every == every / 2;
    if (!chosen || field.stands[i] == 0) continue;
    const auto& place = field.accuracy[i];
    const bool worst = at == AtHeading::kWorst;
    const auto& bound = shown == Shown::kEdges
                            ? (worst ? place.edges_worst : place.edges_median).with_edges
                            : (worst ? place.worst : place.median).bound;
    if (!(bound.major_m > limit_m) || std::isinf(bound.minor_m)) continue;
    const Point half = 0.8 * unit_vector(bound.major_direction);
    const Point c = field.grid.center(i);
    strokes.segments.emplace_back(c - half, c + half);
  }
  if (strokes.segments.empty()) return;
  auto sample = strokes;
  sample.segments.clear();
  sample.stroke.colour = Colour::from_hex(0x888888);
  overlay.items.emplace_back(std::move(strokes));
  overlay.legend.push_back({sample, "direction known least"});
}

}  // namespace

converter::Overlay field_overlay(const LocalizabilityField& field, AtHeading at, Shown shown,
                                 double limit_m) {
  converter::Overlay overlay;
  const bool worst = at == AtHeading::kWorst;
  const auto& accuracy = field.accuracy;
  switch (shown) {
    case Shown::kAccuracy:
      colour_field(
          field, kMetres,
          [&](std::size_t i) {
            return (worst ? accuracy[i].worst : accuracy[i].median).bound.major_m;
          },
          overlay);
      break;
    case Shown::kEdges:
      colour_field(
          field, kMetres,
          [&](std::size_t i) {
            return (worst ? accuracy[i].edges_worst : accuracy[i].edges_median).with_edges.major_m;
          },
          overlay);
      break;
    case Shown::kHeading:
      colour_field(
          field, kDegrees,
          [&](std::size_t i) {
            return (worst ? accuracy[i].worst : accuracy[i].median).bound.heading_rad * 180.0 /
                   std::numbers::pi;
          },
          overlay);
      break;
    case Shown::kRisk:
      colour_field(
          field, kRisk,
          [&](std::size_t i) { return worst ? field.worst_risk(i) : field.median_risk(i); },
          overlay);
      return overlay;
  }
  add_directions(field, at, shown, limit_m, overlay);
  return overlay;
}

void add_seen(const navcore::Confirmation& confirmation, converter::Overlay& overlay) {
  const Colour rim = Colour::from_hex(0x000000);
  for (const auto& place : confirmation.tracked) {
    const Point at = place.pose.position();
    overlay.items.emplace_back(converter::OverlayDots{{at}, 4.6, rim});
    overlay.items.emplace_back(converter::OverlayDots{{at}, 3.8, Colour::from_hex(0xFFFFFF)});
    overlay.items.emplace_back(
        converter::OverlayDots{{at}, 3.2, colour_of(kMetres, place.seen_major_m)});
  }
  overlay.legend.push_back({converter::OverlayDots{{}, 3.2, rim}, "error seen, same colours"});
}

}  // namespace mapwright::cli
