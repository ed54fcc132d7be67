#include "navcore/localization/place_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "navcore/localization/bearable_weights.hpp"

namespace mapwright::navcore {
namespace {

// Proposals have some width even where all the weight is on one particle.
constexpr double kProposal_m = 0.002;
constexpr double kProposal_deg = 0.02;

// Of the weights that proposals are made of; above 0: what is impossible stays so.
constexpr double kLeastExponent = 0.01;

// A place whose last particles leave a smaller effective share is drawn from again: so many times
// at most.
constexpr double kWellMet = 0.3;
constexpr int kMostRounds = 6;

/// A place's particles as they were drawn last, and by what they are weighed.
struct Draws {
  std::vector<Pose> poses;
  std::vector<double> log_weights;
};

Draws draw(const Place& place, Random& random) {
  Draws draws;
  const double normaliser = place.proposal.log_normaliser();
  for (std::size_t i = 0; i < place.count; ++i) {
    const PoseBelief::Deviate deviate = PoseBelief::deviate(random);
    const Pose pose = place.proposal.at(deviate);
    draws.poses.push_back(pose);
    draws.log_weights.push_back(log_density(place.prior, pose) - deviate.log_density - normaliser);
  }
  return draws;
}

/// The places as they are sampled, round by round.
class Sampling {
 public:
  Sampling(std::vector<Place> places, const ScanEvidence& evidence, std::uint64_t seed,
           std::uint64_t first_stream)
      : places_(std::move(places)), evidence_(evidence), draws_(places_.size()) {
    for (std::size_t k = 0; k < places_.size(); ++k) streams_.emplace_back(seed, first_stream + k);
  }

  std::vector<std::size_t> beginning_by(std::size_t stage) const {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (places_[k].from_stage <= stage) chosen.push_back(k);
    }
    return chosen;
  }

  std::vector<std::size_t> badly_met() const {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const double share = effective_size(flattened_weights(draws_[k].log_weights, 1.0)) /
                           static_cast<double>(places_[k].count);
      if (share < kWellMet) chosen.push_back(k);
    }
    return chosen;
  }

  // Draws anew in these places and weighs all that was drawn in one call.
  void look(const std::vector<std::size_t>& chosen, const PlaceStage& stage) {
    std::vector<Pose> poses;
    for (const std::size_t k : chosen) {
      if (!draws_[k].poses.empty()) propose_anew(k);
      draws_[k] = draw(places_[k], streams_[k]);
      poses.insert(poses.end(), draws_[k].poses.begin(), draws_[k].poses.end());
    }
    const std::vector<double> factors = factors_of(poses, stage.sigma_m);
    std::size_t next = 0;
    for (const std::size_t k : chosen) {
      for (double& weight : draws_[k].log_weights) weight += stage.temper * factors[next++];
    }
  }

  // A place's particles stand for the place together, however many they are. Ways are looked at
  // last: that is costly, and says little of where to draw.
  PlaceSample result() const {
    std::vector<Pose> poses;
    std::vector<double> log_weights;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Draws& draws = draws_[k];
      const double log_count = std::log(static_cast<double>(draws.poses.size()));
      poses.insert(poses.end(), draws.poses.begin(), draws.poses.end());
      for (std::size_t i = 0; i < draws.poses.size(); ++i) {
        const double way = log_way(places_[k].prior, draws.poses[i]);
        log_weights.push_back(draws.log_weights[i] + way - log_count);
      }
    }
    PlaceSample sample{with_equal_weights(std::move(poses)), false};
    sample.contradicted = !multiply_weights(sample.particles.weights, log_weights);
    return sample;
  }

 private:
  void propose_anew(std::size_t k) {
    const ParticleSet found{draws_[k].poses,
                            bearable_weights(draws_[k].log_weights, kLeastExponent)};
    places_[k].proposal = PoseBelief(found, kProposal_m, kProposal_deg);
  }

  std::vector<double> factors_of(std::span<const Pose> poses, double sigma_m) const {
    LikelihoodModel likelihood = evidence_.likelihood;
    likelihood.sigma_m = sigma_m;
    std::vector<double> factors(poses.size());
    evidence_.weigher->weigh(evidence_.scan, evidence_.laser, likelihood, poses, factors,
                             evidence_.threads);
    return factors;
  }

  std::vector<Place> places_;
  const ScanEvidence& evidence_;
  std::vector<Random> streams_;
  std::vector<Draws> draws_;
};

struct Cell {
  std::size_t begin = 0, end = 0;  ///< in the order of place
  double weight = 0.0;
};

// In order of place.
std::vector<Cell> cells_worth_keeping(const ParticleSet& particles, const CellOrder& order,
                                      const CellSampling& how) {
  std::vector<Cell> cells;
  for (std::size_t k = 0; k + 1 < order.begins.size(); ++k) {
    Cell cell{order.begins[k], order.begins[k + 1], 0.0};
    for (std::size_t i = cell.begin; i < cell.end; ++i) {
      cell.weight += particles.weights[order.order[i]];
    }
    if (cell.weight > how.negligible) cells.push_back(cell);
  }
  if (cells.size() <= how.most_cells) return cells;
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Cell& a, const Cell& b) { return a.weight > b.weight; });
  cells.resize(how.most_cells);
  std::sort(cells.begin(), cells.end(),
            [](const Cell& a, const Cell& b) { return a.begin < b.begin; });
  return cells;
}

void draw_from(const Cell& cell, const ParticleSet& particles, const CellOrder& order,
               std::size_t count, Random& random, CellSample& sample) {
  std::vector<double> weights;
  for (std::size_t i = cell.begin; i < cell.end; ++i) {
    weights.push_back(particles.weights[order.order[i]] / cell.weight);
  }
  const auto begin = static_cast<std::uint32_t>(sample.particles.size());
  for (const auto i : low_variance_sample(weights, count, random)) {
    sample.particles.poses.push_back(particles.poses[order.order[cell.begin + i]]);
    sample.particles.weights.push_back(cell.weight / static_cast<double>(count));
  }
  sample.cells.push_back({begin, static_cast<std::uint32_t>(sample.particles.size())});
}

}  // namespace

PlaceSample sample_places(std::vector<Place> places, std::span<const PlaceStage> stages,
                          const ScanEvidence& evidence, std::uint64_t seed,
                          std::uint64_t first_stream) {
  Sampling sampling(std::move(places), evidence, seed, first_stream);
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    sampling.look(sampling.beginning_by(stage), stages[stage]);
  }
  for (int round = 0; round < kMostRounds; ++round) {
    const auto again = sampling.badly_met();
    if (again.empty()) break;
    sampling.look(again, stages.back());
  }
  return sampling.result();
}

CellSample sample_cells(const ParticleSet& particles, const CellSampling& how, Random& random) {
  const CellOrder order = sorted_into_cells(particles.poses);
  const std::vector<Cell> cells = cells_worth_keeping(particles, order, how);
  double sum = 0.0;
  for (const Cell& cell : cells) sum += std::pow(cell.weight, how.power);
  CellSample sample;
  for (const Cell& cell : cells) {
    const double share = std::pow(cell.weight, how.power) / sum;
    const auto wanted = static_cast<std::size_t>(share * static_cast<double>(how.count));
    draw_from(cell, particles, order, std::max(how.least, wanted), random, sample);
  }
  const auto& weights = sample.particles.weights;
  const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : sample.particles.weights) weight /= whole;
  return sample;
}

}  // namespace mapwright::navcore
