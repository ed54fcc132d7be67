#include "converter/detective/crs_guesses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numbers>

#include "converter/detective/known_grids.hpp"

namespace mapwright::converter {
namespace {

constexpr double kMetresPerDegree = 111320.0;
constexpr double kWebMercatorReach = 20037508.35;

std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char* format, ...) {
  char buffer[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

bool within(const std::optional<double>& value, double least, double most) {
  return value && *value >= least && *value <= most;
}

// How well sizes fit what people build, if one unit is so many metres: steps are 26 to 36 cm deep
// (22 to 45 at most), doors 60 cm to 2.5 m wide, walls between corners 20 cm to 60 m long. From 0
// to 1; 0.5 where nothing can be measured.
double size_plausibility(const DrawingEvidence& evidence, double metres) {
  const auto scaled = [&](const std::optional<double>& value) {
    return value ? std::optional(*value * metres) : std::nullopt;
  };
  if (const auto tread = scaled(evidence.tread)) {
    return within(tread, 0.26, 0.36) ? 1.0 : within(tread, 0.22, 0.45) ? 0.6 : 0.1;
  }
  if (evidence.door) return within(scaled(evidence.door), 0.6, 2.5) ? 0.9 : 0.15;
  if (evidence.edge) return within(scaled(evidence.edge), 0.2, 60.0) ? 0.7 : 0.05;
  return 0.5;
}

std::string sizes(const DrawingEvidence& evidence, double metres) {
  if (evidence.tread) return text("steps would be %.2f m deep", *evidence.tread * metres);
  if (evidence.door) return text("doors would be %.2f m wide", *evidence.door * metres);
  if (evidence.edge) return text("walls would be %.3g m long", *evidence.edge * metres);
  return "nothing can be measured";
}

Point middle_of(const Box& box) {
  return {0.5 * (box.min_x + box.max_x), 0.5 * (box.min_y + box.max_y)};
}

std::string place(double latitude, double longitude) {
  return text("%.2f %c, %.2f %c", std::abs(latitude), latitude < 0 ? 'S' : 'N', std::abs(longitude),
              longitude < 0 ? 'W' : 'E');
}

class Guesser {
 public:
  Guesser(const DrawingEvidence& evidence, const std::vector<Neighbour>& neighbours)
      : evidence_(evidence),
        neighbours_(neighbours),
        center_(middle_of(evidence.extent)),
        reach_(std::max({std::abs(evidence.extent.min_x), std::abs(evidence.extent.max_x),
                         std::abs(evidence.extent.min_y), std::abs(evidence.extent.max_y)})) {}

  std::vector<CrsGuess> guesses() {
    guess_neighbours();
    guess_degrees();
    guess_metres();
    guess_other_units();
    guess_utm();
    guess_web_mercator();
    guess_grids();
    std::stable_sort(found_.begin(), found_.end(),
                     [](const CrsGuess& p, const CrsGuess& q) { return p.weight > q.weight; });
    return std::move(found_);
  }

 private:
  void add(std::string what, std::string because, std::string remedy, double weight) {
    if (weight >= 0.02) {
      found_.push_back({std::move(what), std::move(because), std::move(remedy), weight});
    }
  }

  // What lies in the same numbers lies in the same CRS.
  void guess_neighbours() {
    for (const auto& neighbour : neighbours_) {
      const Box& box = neighbour.extent;
      const double reach = std::max(box.width(), box.height());
      if (!box.inflated(reach).contains(center_) && !evidence_.extent.contains(middle_of(box)))
        continue;
      const bool known = std::any_of(found_.begin(), found_.end(), [&](const CrsGuess& guess) {
        return guess.remedy == remedy_of(neighbour.crs);
      });
      if (known) continue;
      add(neighbour.crs.title(), neighbour.name + " states it, and lies in the same place",
          remedy_of(neighbour.crs), 2.0);
    }
  }

  static std::string remedy_of(const Crs& crs) { return "--source-crs " + crs.title(); }

  void guess_degrees() {
    const Box& box = evidence_.extent;
    const bool as_written =
        reach_ <= 360.0 && std::abs(box.min_y) <= 90.0 && std::abs(box.max_y) <= 90.0;
    const bool exchanged =
        reach_ <= 360.0 && std::abs(box.min_x) <= 90.0 && std::abs(box.max_x) <= 90.0;
    const double size = size_plausibility(evidence_, kMetresPerDegree);
    const auto share = [&](std::size_t right) {
      return evidence_.corners == 0
                 ? 0.0
                 : static_cast<double>(right) / static_cast<double>(evidence_.corners);
    };
    const double right = share(evidence_.right_as_degrees),
                 turned = share(evidence_.right_if_exchanged);
    if (as_written) {
      add("longitude and latitude in degrees",
          "it would lie at " + place(center_.y, center_.x) + ", " +
              sizes(evidence_, kMetresPerDegree) +
              text(", %.0f %% of the corners would be right angles", 100.0 * right),
          "--source-crs EPSG:4326", size * (turned > 1.5 * right ? 0.4 : 1.0));
    }
    if (exchanged) {
      add("latitude and longitude in degrees, axes exchanged",
          "it would lie at " + place(center_.x, center_.y) +
              text(", %.0f %% of the corners would be right angles", 100.0 * turned),
          "--source-crs EPSG:4326 --swap-axes", size * (turned > 1.5 * right ? 1.0 : 0.35));
    }
  }

  void guess_metres() {
    const double size = size_plausibility(evidence_, 1.0);
    const double extent = std::max(evidence_.extent.width(), evidence_.extent.height());
    if (extent < 0.5) return;
    const bool near = reach_ <= 20000.0;
    const double far = reach_ <= 100000.0 ? 0.5 : 0.3;
    add(near ? "plain metres of a drawing of its own" : "metres with a false origin of its own",
        text("it would be %.4g by %.4g m%s, ", evidence_.extent.width(), evidence_.extent.height(),
             near ? "" : text(", %.0f km away from its origin", reach_ / 1000.0).c_str()) +
            sizes(evidence_, 1.0),
        near ? "--local" : "--local, after moving it near to (0, 0)", size * (near ? 0.95 : far));
  }

  // A plan in another unit: near its origin, and of a size that makes no sense in metres.
  void guess_other_units() {
    struct Unit {
      const char* name;
      double metres;
      double weight;
    };
    constexpr Unit kUnits[] = {{"feet", 0.3048, 0.8},
                               {"millimetres", 0.001, 0.9},
                               {"centimetres", 0.01, 0.85},
                               {"inches", 0.0254, 0.7}};
    const double as_metres = size_plausibility(evidence_, 1.0);
    for (const Unit& unit : kUnits) {
      if (reach_ * unit.metres > 20000.0) continue;
      const double size = size_plausibility(evidence_, unit.metres);
      if (size <= as_metres) continue;
      add(std::string(unit.name) + " of a drawing of its own",
          sizes(evidence_, unit.metres) + ", but " + text("%.3g m", measured()) + " in metres",
          text("--local --local-unit %.4g", unit.metres), size * unit.weight);
    }
  }

  double measured() const {
    return evidence_.tread  ? *evidence_.tread
           : evidence_.door ? *evidence_.door
                            : evidence_.edge.value_or(0.0);
  }

  void guess_utm() {
    if (center_.x < 100000.0 || center_.x > 900000.0 || center_.y < 0.0 || center_.y > 1.0e7)
      return;
    const double latitude = utm_latitude_deg(center_);
    if (!std::isfinite(latitude)) return;
    add("UTM, of a zone that the numbers do not tell",
        text("easting %.0f and northing %.0f are latitude %.2f N, or %.0f m from the equator in "
             "the south; ",
             center_.x, center_.y, latitude, 1.0e7 - center_.y) +
            sizes(evidence_, 1.0),
        "--source-crs EPSG:326ZZ (WGS 84) or EPSG:258ZZ (Europe), ZZ the zone; EPSG:327ZZ in the "
        "south",
        0.6 * size_plausibility(evidence_, 1.0));
  }

  // Its metres are longer than those on the ground by 1/cos(latitude).
  void guess_web_mercator() {
    if (reach_ > kWebMercatorReach || reach_ < 100000.0) return;
    const double latitude =
        std::atan(std::sinh(center_.y / 6378137.0)) * (180.0 / std::numbers::pi);
    const double longitude = center_.x / kWebMercatorReach * 180.0;
    const double scale = std::cos(latitude * (std::numbers::pi / 180.0));
    add("Web Mercator",
        "it would lie at " + place(latitude, longitude) +
            text(", its metres %.2f m on the ground, ", scale) + sizes(evidence_, scale),
        "--source-crs EPSG:3857", 0.45 * size_plausibility(evidence_, scale));
  }

  void guess_grids() {
    constexpr std::size_t kMostGrids = 3;
    if (reach_ < 1000.0) return;
    auto grids = grids_holding(center_);
    if (grids.size() > kMostGrids) grids.resize(kMostGrids);
    for (const auto& grid : grids) {
      const double metres = grid.metres_per_unit;
      add(grid.code + ", " + grid.name,
          "it would lie at " + place(grid.latitude_deg, grid.longitude_deg) + ", " +
              sizes(evidence_, metres),
          "--source-crs " + grid.code,
          size_plausibility(evidence_, metres) * (0.35 + 0.3 * grid.centrality));
    }
  }

  const DrawingEvidence& evidence_;
  const std::vector<Neighbour>& neighbours_;
  Point center_;
  double reach_;
  std::vector<CrsGuess> found_;
};

}  // namespace

std::vector<CrsGuess> guess_crs(const DrawingEvidence& evidence,
                                const std::vector<Neighbour>& neighbours, std::size_t most) {
  if (evidence.extent.is_empty()) return {};
  auto guesses = Guesser(evidence, neighbours).guesses();
  if (guesses.size() > most) guesses.resize(most);
  return guesses;
}

std::string guesses_text(const DrawingEvidence& evidence, const std::vector<CrsGuess>& guesses) {
  if (guesses.empty()) return {};
  const Box& box = evidence.extent;
  std::string lines = text(
      "\n  its coordinates run from x %.10g to %.10g, y %.10g to %.10g; they may be, the likeliest "
      "first:",
      box.min_x, box.max_x, box.min_y, box.max_y);
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    const auto& guess = guesses[i];
    lines += "\n  " + std::to_string(i + 1) + ". " + guess.what + ": " + guess.because +
             ". Then: " + guess.remedy;
  }
  return lines;
}

}  // namespace mapwright::converter
