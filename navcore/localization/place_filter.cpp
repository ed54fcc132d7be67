#include "navcore/localization/place_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

// Streams of the seed beside those of the searcher.
constexpr std::uint64_t kStreams = std::uint64_t{1} << 62U;
constexpr std::size_t kGrain = 512;

// Beliefs have some width, whatever few particles say.
constexpr double kBelief_m = 0.002;
constexpr double kBelief_deg = 0.05;

// Where the search for another place begins around an extra particle.
constexpr double kExtra_m = 0.5;
constexpr double kExtra_deg = 3.0;

constexpr int kAreaDraws = 20000;

double free_area_m2(const FreeSpace& space) {
  const Box box = space.border().box();
  Random random(1);
  int free = 0;
  for (int i = 0; i < kAreaDraws; ++i) {
    const double x = random.uniform(box.min_x, box.max_x);
    const double y = random.uniform(box.min_y, box.max_y);
    free += space.is_free({x, y}) ? 1 : 0;
  }
  return space.border().area_m2() * std::max(1, free) / kAreaDraws;
}

double weight_of(const ParticleSet& particles, IndexRange cell) {
  double sum = 0.0;
  for (std::size_t i = cell.begin; i < cell.end; ++i) sum += particles.weights[i];
  return sum;
}

// With weights that sum up to 1.
ParticleSet part_of(const ParticleSet& particles, IndexRange cell) {
  const double whole = weight_of(particles, cell);
  ParticleSet part;
  for (std::size_t i = cell.begin; i < cell.end; ++i) {
    part.poses.push_back(particles.poses[i]);
    part.weights.push_back(particles.weights[i] / whole);
  }
  return part;
}

PoseBelief belief_of(const ParticleSet& particles, IndexRange cell) {
  return {part_of(particles, cell), kBelief_m, kBelief_deg};
}

// As they are, in order of place.
CellSample in_cells(const ParticleSet& particles) {
  const CellOrder order = sorted_into_cells(particles.poses);
  CellSample sample;
  for (const auto i : order.order) {
    sample.particles.poses.push_back(particles.poses[i]);
    sample.particles.weights.push_back(particles.weights[i]);
  }
  for (std::size_t k = 0; k + 1 < order.begins.size(); ++k) {
    sample.cells.push_back({static_cast<std::uint32_t>(order.begins[k]),
                            static_cast<std::uint32_t>(order.begins[k + 1])});
  }
  return sample;
}

}  // namespace

PlaceFilter::PlaceFilter(const ScanWeigher& weigher, const LaserModel& laser,
                         const FilterSettings& settings, std::uint64_t seed)
    : weigher_(weigher),
      laser_(laser),
      settings_(settings),
      how_(settings.places.value_or(PlaceSettings{})),
      seed_(seed),
      searcher_(weigher, laser, settings, seed) {
  assert(!how_.first_stages.empty() && !how_.stages.empty());
}

Random PlaceFilter::stream(std::size_t number) const {
  return Random(seed_, kStreams + (epoch_ << 32U) + number);
}

const ParticleSet& PlaceFilter::particles() const {
  return lost_ ? searcher_.particles() : places_.particles;
}

bool PlaceFilter::start_anywhere(const FreeSpace& space,
                                 const std::optional<HeadingPrior>& heading) {
  space_ = &space;
  area_m2_ = free_area_m2(space);
  heading_ = heading;
  sure_for_ = 0;
  lost_ = true;
  return searcher_.start_anywhere(space, heading);
}

void PlaceFilter::start_at(const Pose& pose, double sigma_m, double sigma_deg,
                           const FreeSpace* space) {
  searcher_.start_at(pose, sigma_m, sigma_deg);
  take(searcher_.particles(), space);
}

void PlaceFilter::take(const ParticleSet& particles, const FreeSpace* space) {
  space_ = space;
  if (space != nullptr) area_m2_ = free_area_m2(*space);
  heading_.reset();
  sure_for_ = 0;
  lost_ = false;
  coarse_ = true;
  rest_at(in_cells(particles));
}

void PlaceFilter::rest_at(CellSample places) {
  places_ = std::move(places);
  before_ = places_.particles;
  step_.reset();
}

void PlaceFilter::move(const OdometryStep& step) {
  if (heading_) heading_ = turned(*heading_, step, settings_.odometry);
  if (lost_) return searcher_.move(step);
  if (step_) weigh_ways();
  ++epoch_;
  before_ = places_.particles;
  step_ = step;
  auto& poses = places_.particles.poses;
  parallel_for(poses.size(), kGrain, settings_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Random random = stream(i);
      poses[i] = moved(poses[i], perturbed(step, settings_.odometry, random));
    }
  });
}

// Of a movement that no scan follows; else the next scan's particles have ways of their own.
void PlaceFilter::weigh_ways() {
  if (space_ == nullptr) return;
  auto& weights = places_.particles.weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Point from = before_.poses[i].position();
    const Point to = places_.particles.poses[i].position();
    if (!is_way(*space_, from, to, how_.robot_radius_m)) weights[i] *= how_.through_barrier;
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
}

UpdateReport PlaceFilter::update(std::span<const double> scan) {
  if (lost_) return search(scan);
  std::vector<Place> places = tracked_places();
  for (Place& place : elsewhere_places(scan)) places.push_back(std::move(place));
  return weigh(std::move(places), how_.stages, scan);
}

UpdateReport PlaceFilter::search(std::span<const double> scan) {
  UpdateReport report = searcher_.update(scan);
  lost_ = false;
  report.contradicted |= weigh(searched_places(), how_.first_stages, scan).contradicted;
  return report;
}

// The search says where to look; how much that is worth it need not say.
std::vector<Place> PlaceFilter::searched_places() {
  const CellSample found = kept(searcher_.particles(), how_.first_particles);
  std::vector<Place> places;
  for (const IndexRange cell : found.cells) {
    const PlaceCell where = place_cell(found.particles.poses[cell.begin]);
    places.push_back({FlatPrior{where, space_, -std::log(area_m2_), heading_},
                      belief_of(found.particles, cell), cell.end - cell.begin, 0});
  }
  return places;
}

// `here`: the probability that the robot is not somewhere else.
TrackedPrior PlaceFilter::prior_of(IndexRange cell, double here) const {
  const double share = here * weight_of(before_, cell);
  return {MovedPoses(part_of(before_, cell), step_.value_or(OdometryStep()), settings_.odometry),
          std::log(share), step_ ? space_ : nullptr, how_.robot_radius_m,
          std::log(how_.through_barrier)};
}

std::vector<Place> PlaceFilter::tracked_places() const {
  const double here = looks_elsewhere() ? 1.0 - settings_.elsewhere : 1.0;
  std::vector<Place> places;
  for (const IndexRange cell : places_.cells) {
    places.push_back({prior_of(cell, here), belief_of(places_.particles, cell),
                      std::max<std::size_t>(how_.least_particles, cell.end - cell.begin),
                      coarse_ ? 0 : how_.tracked_from_stage});
  }
  return places;
}

// Those that agree best with the scan come first, with a blunt likelihood: none is near a peak.
std::vector<Pose> PlaceFilter::elsewhere_by_fit(std::span<const double> scan) {
  ++epoch_;
  Random random = stream(0);
  std::vector<Pose> poses;
  while (poses.size() < settings_.elsewhere_particles) {
    const auto place = space_->sample(random);
    if (!place) break;
    poses.push_back({place->x, place->y, draw_heading(heading_, random)});
  }
  LikelihoodModel likelihood = settings_.likelihood;
  likelihood.sigma_m = how_.stages.front().sigma_m;
  std::vector<double> factors(poses.size());
  weigher_.weigh(scan, laser_, likelihood, poses, factors, settings_.threads);
  std::vector<std::size_t> order(poses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return factors[a] > factors[b]; });
  std::vector<Pose> sorted;
  for (const std::size_t i : order) sorted.push_back(poses[i]);
  return sorted;
}

std::vector<Place> PlaceFilter::elsewhere_places(std::span<const double> scan) {
  std::vector<Place> places;
  if (!looks_elsewhere()) return places;
  const double density = std::log(settings_.elsewhere / area_m2_);
  std::vector<PlaceCell> seen;
  for (const Pose& pose : elsewhere_by_fit(scan)) {
    if (places.size() == how_.elsewhere_places) break;
    const PlaceCell cell = place_cell(pose);
    if (std::find(seen.begin(), seen.end(), cell) != seen.end()) continue;
    seen.push_back(cell);
    places.push_back({FlatPrior{cell, space_, density, heading_},
                      PoseBelief(with_equal_weights({pose}), kExtra_m, kExtra_deg),
                      how_.elsewhere_particles, 0});
  }
  return places;
}

CellSample PlaceFilter::kept(const ParticleSet& particles, std::size_t count) {
  ++epoch_;
  Random random = stream(0);
  return sample_cells(
      particles,
      {count, settings_.place_power, how_.least_particles, how_.negligible, how_.most_places},
      random);
}

UpdateReport PlaceFilter::weigh(std::vector<Place> places, std::span<const PlaceStage> stages,
                                std::span<const double> scan) {
  ++epoch_;
  const ScanEvidence evidence{scan, laser_, settings_.likelihood, &weigher_, settings_.threads};
  const PlaceSample sample =
      sample_places(std::move(places), stages, evidence, seed_, kStreams + (epoch_ << 32U));
  const UpdateReport report{sample.particles.size(), effective_size(sample.particles.weights),
                            sample.contradicted, true};
  const bool sure = estimate_pose(sample.particles).mode_share >= how_.settled_share;
  sure_for_ = sure ? sure_for_ + 1 : 0;
  const bool settled = sure_for_ >= how_.settled_after;
  coarse_ = false;
  rest_at(kept(sample.particles, settled ? std::min(how_.settled_particles, settings_.particles)
                                         : settings_.particles));
  return report;
}

std::unique_ptr<PoseFilter> make_filter(const ScanWeigher& weigher, const LaserModel& laser,
                                        const FilterSettings& settings, std::uint64_t seed) {
  if (settings.places) return std::make_unique<PlaceFilter>(weigher, laser, settings, seed);
  return std::make_unique<ParticleFilter>(weigher, laser, settings, seed);
}

}  // namespace mapwright::navcore
