#include "navcore/localizability/localizability.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

PlaceGrid grid_of(const Map& map, const LocalizabilitySettings& settings) {
  return PlaceGrid::over(settings.window ? *settings.window : map.border.box(), settings.cell_m);
}

std::vector<char> standing_places(const FreeSpace& space, const PlaceGrid& grid,
                                  const LocalizabilitySettings& settings) {
  // A laser on a wall sees both of its sides.
  constexpr double kTouching_m = 1e-3;
  const double radius_m = std::max(settings.robot_radius_m, kTouching_m);
  std::vector<char> stands(grid.size());
  parallel_for(grid.size(), 256, settings.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      stands[i] = space.is_free(grid.center(i), radius_m) ? 1 : 0;
    }
  });
  return stands;
}

AccuracySettings accuracy_settings(const LocalizabilitySettings& settings) {
  return {settings.laser, settings.noise, settings.headings, settings.heading_deg};
}

TwinSettings twin_settings(const LocalizabilitySettings& settings) {
  TwinSettings twins{settings.laser,
                     settings.noise,
                     settings.apart_m,
                     settings.compass_sigma_deg,
                     {},
                     settings.twin_index_poses,
                     settings.robot_radius_m};
  if (settings.heading_deg) {
    twins.headings_deg = {*settings.heading_deg};
    return twins;
  }
  for (std::size_t i = 0; i < settings.twin_headings; ++i) {
    twins.headings_deg.push_back(360.0 * static_cast<double>(i) /
                                 static_cast<double>(settings.twin_headings));
  }
  return twins;
}

/// Every so many columns and rows of a grid.
class Thinned {
 public:
  Thinned(const PlaceGrid& grid, double spacing_m)
      : grid_(grid),
        every_(static_cast<std::size_t>(std::max(1.0, std::round(spacing_m / grid.cell_m)))) {
    coarse_.cell_m = grid.cell_m * static_cast<double>(every_);
    coarse_.columns = (grid.columns + every_ - 1) / every_;
    coarse_.rows = (grid.rows + every_ - 1) / every_;
  }

  /// The first place in a block of the fine grid where the robot stands represents the block.
  std::vector<std::optional<std::size_t>> representatives(const std::vector<char>& stands) const {
    std::vector<std::optional<std::size_t>> chosen(coarse_.size());
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      auto& place = chosen[block_of(i)];
      if (stands[i] != 0 && !place) place = i;
    }
    return chosen;
  }

  const PlaceGrid& coarse() const { return coarse_; }
  std::size_t block_of(std::size_t i) const {
    return i / grid_.columns / every_ * coarse_.columns + i % grid_.columns / every_;
  }

 private:
  const PlaceGrid& grid_;
  std::size_t every_;
  PlaceGrid coarse_;
};

Twin moved(const Twin& twin, Point by) {
  const double turn = twin.pose.theta.radians() - twin.heading_deg * std::numbers::pi / 180.0;
  const double c = std::cos(turn), s = std::sin(turn);
  Twin result = twin;
  result.pose.x += c * by.x - s * by.y;
  result.pose.y += s * by.x + c * by.y;
  return result;
}

std::vector<PlaceTwins> twins_of(const Map& map, const FreeSpace& space,
                                 const GradientCaster& caster, const LocalizabilityField& field,
                                 const LocalizabilitySettings& settings, const Progress& progress) {
  const Thinned thinned(field.grid, settings.twin_spacing_m);
  const auto chosen = thinned.representatives(field.stands);
  AskedPlaces asked{thinned.coarse().columns, thinned.coarse().rows, {}};
  for (const auto& place : chosen) {
    asked.places.push_back(place ? std::optional<Point>(field.grid.center(*place)) : std::nullopt);
  }
  const auto found =
      find_twins(map, space, caster, asked, twin_settings(settings), settings.threads, progress);
  std::vector<PlaceTwins> twins(field.grid.size());
  for (std::size_t i = 0; i < twins.size(); ++i) {
    const std::size_t block = thinned.block_of(i);
    if (field.stands[i] == 0) continue;
    const Point by = field.grid.center(i) - *asked.places[block];
    if (found[block].worst) twins[i].worst = moved(*found[block].worst, by);
    if (found[block].median) twins[i].median = moved(*found[block].median, by);
  }
  return twins;
}

}  // namespace

double LocalizabilityField::worst_risk(std::size_t i) const {
  return twins[i].worst ? confusion_bounds(twins[i].worst->nats).least : 0.0;
}

double LocalizabilityField::median_risk(std::size_t i) const {
  return twins[i].median ? confusion_bounds(twins[i].median->nats).least : 0.0;
}

std::size_t place_count(const Map& map, const LocalizabilitySettings& settings) {
  return grid_of(map, settings).size();
}

LocalizabilityField localizability_field(const Map& map, const FreeSpace& space,
                                         const LocalizabilitySettings& settings,
                                         const Progress& progress) {
  LocalizabilityField field;
  field.grid = grid_of(map, settings);
  field.stands = standing_places(space, field.grid, settings);
  field.accuracy.resize(field.grid.size());
  field.twins.resize(field.grid.size());
  std::vector<std::size_t> cells;
  std::vector<Point> places;
  for (std::size_t i = 0; i < field.grid.size(); ++i) {
    if (field.stands[i] == 0) continue;
    cells.push_back(i);
    places.push_back(field.grid.center(i));
  }
  const GradientCaster caster(map);
  // Of 100 parts of the work, as the bar shows it, twins take most.
  const auto part = [&](std::size_t from, std::size_t to) -> Progress {
    if (!progress) return {};
    return [&progress, from, to](std::size_t done, std::size_t total) {
      progress(from + (to - from) * done / std::max<std::size_t>(1, total), 100);
    };
  };
  const std::size_t split = settings.look_for_twins ? 20 : 100;
  const auto accuracy =
      accuracy_at(caster, places, accuracy_settings(settings), settings.threads, part(0, split));
  for (std::size_t k = 0; k < cells.size(); ++k) field.accuracy[cells[k]] = accuracy[k];
  if (settings.look_for_twins) {
    field.twins = twins_of(map, space, caster, field, settings, part(split, 100));
  }
  return field;
}

}  // namespace mapwright::navcore
