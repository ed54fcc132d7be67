#include "navcore/localizability/twin_search.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "navcore/localizability/accuracy_field.hpp"
#include "navcore/localizability/place_grid.hpp"
#include "navcore/localizability/twin_index.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

constexpr double kIndexSpacing_m = 1.0;
constexpr std::size_t kHeadings = 48;  // of the index, where no compass tells the heading
constexpr std::size_t kSimilar = 6;    // digests
constexpr std::size_t kFitted = 2;     // of them, those whose scans agree best
constexpr std::size_t kCastTogether = 4096;
constexpr int kSweeps = 2;
constexpr std::size_t kBatch = 16;

// A scan that tells the position to this part of the distance between places tells places apart.
constexpr double kSettled = 0.25;

// Before it is worth fitting, this share of the beams has to agree within about a metre.
constexpr double kLeastAlike = 0.65;

std::vector<Point> free_points(const Map& map, const FreeSpace& space, const TwinSettings& settings,
                               std::size_t headings) {
  const Box window = map.border.box();
  const double most = static_cast<double>(settings.index_poses) / static_cast<double>(headings);
  const double spacing =
      std::max(kIndexSpacing_m, std::sqrt(window.width() * window.height() / most));
  const PlaceGrid grid = PlaceGrid::over(window, spacing);
  std::vector<Point> points;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Point p = grid.center(i);
    if (space.is_free(p, settings.robot_radius_m)) points.push_back(p);
  }
  return points;
}

TwinIndex index_of(const ScanEngine& engine, std::span<const Point> points,
                   std::span<const double> headings_deg, const LaserModel& laser,
                   unsigned threads) {
  std::vector<TwinIndex::Entry> entries;
  for (const Point p : points) {
    for (const double heading : headings_deg) {
      entries.push_back({{}, {p.x, p.y, Angle::from_degrees(heading)}});
    }
  }
  std::vector<Pose> poses;
  std::vector<float> ranges;
  for (std::size_t first = 0; first < entries.size(); first += kCastTogether) {
    const std::size_t count = std::min(kCastTogether, entries.size() - first);
    poses.clear();
    for (std::size_t i = first; i < first + count; ++i) poses.push_back(entries[i].pose);
    ranges.resize(count * laser.rays);
    engine.cast_all(poses, laser, ranges, threads);
    for (std::size_t i = 0; i < count; ++i) {
      entries[first + i].digest = digest_of(std::span(ranges).subspan(i * laser.rays, laser.rays));
    }
  }
  return TwinIndex(std::move(entries));
}

// Share of the beams that agree, blunt to about a metre.
double alikeness(std::span<const RangeGradient> here, std::span<const float> there) {
  double sum = 0.0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const double delta = here[i].range_m - static_cast<double>(there[i]);
    sum += 1.0 / (1.0 + delta * delta);
  }
  return sum / static_cast<double>(here.size());
}

// Where a twin of `from` leads when the robot moves to `to`, its heading kept.
Pose moved_along(const Twin& twin, Point from, Point to) {
  const double turn = twin.pose.theta.radians() - twin.heading_deg * std::numbers::pi / 180.0;
  const Point d = to - from;
  const double c = std::cos(turn), s = std::sin(turn);
  return {twin.pose.x + c * d.x - s * d.y, twin.pose.y + s * d.x + c * d.y, twin.pose.theta};
}

/// Of one place, by heading.
using Twins = std::vector<std::optional<Twin>>;

class TwinSearch {
 public:
  TwinSearch(const Map& map, const FreeSpace& space, const GradientCaster& caster,
             const TwinSettings& settings, unsigned threads)
      : space_(space),
        caster_(caster),
        settings_(settings),
        noise_(settings.noise, settings.laser.max_range_m),
        engine_(map) {
    std::vector<double> headings_deg(kHeadings);
    for (std::size_t i = 0; i < kHeadings; ++i) {
      headings_deg[i] = 360.0 * static_cast<double>(i) / kHeadings;
    }
    if (settings.compass_sigma_deg) {
      const auto points = free_points(map, space, settings, settings.headings_deg.size());
      for (const double heading : settings.headings_deg) {
        indices_.push_back(index_of(engine_, points, {&heading, 1}, settings.laser, threads));
      }
    } else {
      const auto points = free_points(map, space, settings, kHeadings);
      indices_.push_back(index_of(engine_, points, headings_deg, settings.laser, threads));
    }
  }

  /// From the index, by heading.
  Twins search(Point place) const {
    Twins best(settings_.headings_deg.size());
    GradientCaster::Local local(caster_, settings_.laser);
    std::vector<RangeGradient> here(settings_.laser.rays);
    for (std::size_t h = 0; h < settings_.headings_deg.size(); ++h) {
      const Pose pose{place.x, place.y, Angle::from_degrees(settings_.headings_deg[h])};
      local.cast(pose, here);
      if (!is_settled(here, pose)) continue;
      const TwinIndex& index = indices_[settings_.compass_sigma_deg ? h : 0];
      for (const Pose& candidate : candidates(index, here, place)) {
        try_pose(here, pose, candidate, best[h]);
      }
    }
    return best;
  }

  /// A twin of a neighbouring place, moved along.
  void follow(Point place, const Twin& twin, Point from, std::optional<Twin>& best) const {
    const Pose pose{place.x, place.y, Angle::from_degrees(twin.heading_deg)};
    std::vector<RangeGradient> here(settings_.laser.rays);
    caster_.cast(pose, settings_.laser, here);
    if (is_settled(here, pose)) try_pose(here, pose, moved_along(twin, from, place), best);
  }

 private:
  // Where a scan does not tell the position anyway, that it looks the same farther along the wall
  // is no confusion of places.
  bool is_settled(std::span<const RangeGradient> here, const Pose& pose) const {
    const double major_m = heading_accuracy(here, pose, settings_.laser, noise_).with_edges.major_m;
    return major_m <= kSettled * settings_.apart_m;
  }

  // Of the poses with the most similar digests those whose scans agree best.
  std::vector<Pose> candidates(const TwinIndex& index, std::span<const RangeGradient> here,
                               Point place) const {
    std::vector<float> ranges(here.size());
    std::transform(here.begin(), here.end(), ranges.begin(),
                   [](const auto& beam) { return static_cast<float>(beam.range_m); });
    const auto similar = index.most_similar(digest_of(ranges), place, settings_.apart_m, kSimilar);
    std::vector<float> there(similar.size() * here.size());
    engine_.cast_all(similar, settings_.laser, there, 1);
    std::vector<std::pair<double, Pose>> alike;
    for (std::size_t i = 0; i < similar.size(); ++i) {
      const double share = alikeness(here, std::span(there).subspan(i * here.size(), here.size()));
      if (share >= kLeastAlike) alike.emplace_back(share, similar[i]);
    }
    std::stable_sort(alike.begin(), alike.end(),
                     [](const auto& p, const auto& q) { return p.first > q.first; });
    std::vector<Pose> best;
    for (const auto& [share, pose] : alike) {
      if (best.size() < kFitted) best.push_back(pose);
    }
    return best;
  }

  void try_pose(std::span<const RangeGradient> here, const Pose& pose, const Pose& start,
                std::optional<Twin>& best) const {
    GradientCaster::Local local(caster_, settings_.laser);
    const auto fit = fitted(local, here, pose, start, settings_, noise_);
    if (!fit || distance(fit->position(), pose.position()) <= settings_.apart_m) return;
    if (!space_.is_free(fit->position(), settings_.robot_radius_m)) return;
    std::vector<RangeGradient> there(here.size());
    local.cast(*fit, there);
    const double nats = distinction_nats(here, there, pose, *fit, settings_, noise_);
    if (nats >= kMostTwinNats || (best && best->nats <= nats)) return;
    best = Twin{*fit, pose.theta.degrees(), nats};
  }

  const FreeSpace& space_;
  const GradientCaster& caster_;
  const TwinSettings& settings_;
  BeamNoise noise_;
  ScanEngine engine_;
  std::vector<TwinIndex> indices_;  ///< one a heading; without compass one for all
};

// What the neighbours of a place found, tried at the place too.
void follow_neighbours(const TwinSearch& search, const AskedPlaces& asked,
                       const std::vector<Twins>& known, std::size_t i, Twins& best) {
  const std::size_t column = i % asked.columns;
  const std::size_t row = i / asked.columns;
  const auto follow = [&](std::size_t j) {
    for (std::size_t h = 0; h < known[j].size(); ++h) {
      const auto& twin = known[j][h];
      if (!twin || (best[h] && best[h]->nats <= twin->nats)) continue;
      search.follow(*asked.places[i], *twin, *asked.places[j], best[h]);
    }
  };
  if (column > 0) follow(i - 1);
  if (column + 1 < asked.columns) follow(i + 1);
  if (row > 0) follow(i - asked.columns);
  if (row + 1 < asked.rows) follow(i + asked.columns);
}

PlaceTwins over_headings(Twins twins) {
  if (twins.empty()) return {};
  const auto nats = [](const std::optional<Twin>& twin) { return twin ? twin->nats : HUGE_VAL; };
  std::stable_sort(twins.begin(), twins.end(),
                   [&](const auto& p, const auto& q) { return nats(p) > nats(q); });
  return {twins.back(), twins[(twins.size() - 1) / 2]};
}

}  // namespace

double distinction_nats(std::span<const RangeGradient> here, std::span<const RangeGradient> there,
                        const Pose& pose, const Pose& other, const TwinSettings& settings,
                        const BeamNoise& noise) {
  double sum = 0.0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (here[i].echo != there[i].echo) {
      sum += noise.echo_distinction();
    } else if (here[i].echo) {
      sum += noise.distinction(here[i].range_m - there[i].range_m);
    }
  }
  if (settings.compass_sigma_deg) {
    const double turn =
        (pose.theta - other.theta).wrapped().degrees() / *settings.compass_sigma_deg;
    sum += turn * turn / 8.0;
  }
  return sum;
}

std::vector<PlaceTwins> find_twins(const Map& map, const FreeSpace& space,
                                   const GradientCaster& caster, const AskedPlaces& asked,
                                   const TwinSettings& settings, unsigned threads,
                                   const Progress& progress) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < asked.places.size(); ++i) {
    if (asked.places[i]) places.push_back(i);
  }
  std::vector<PlaceTwins> result(asked.places.size());
  if (places.empty()) return result;
  std::vector<Twins> twins(asked.places.size());
  const TwinSearch search(map, space, caster, settings, threads);
  std::mutex mutex;
  std::size_t done = 0;
  const auto for_places = [&](const std::function<void(std::size_t)>& work) {
    parallel_for(places.size(), kBatch, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) work(places[k]);
      const std::lock_guard lock(mutex);
      done += end - begin;
      if (progress) progress(done, (1 + kSweeps) * places.size());
    });
  };
  for_places([&](std::size_t i) { twins[i] = search.search(*asked.places[i]); });
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const std::vector<Twins> known = twins;
    for_places([&](std::size_t i) { follow_neighbours(search, asked, known, i, twins[i]); });
  }
  for (const std::size_t i : places) result[i] = over_headings(std::move(twins[i]));
  return result;
}

}  // namespace mapwright::navcore
