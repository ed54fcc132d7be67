#include "navcore/localizability/accuracy_field.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "navcore/localizability/edge_information.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

// Places that are cast together.
constexpr std::size_t kBatch = 64;

double beam_step_deg(const LaserModel& laser) {
  return laser.rays < 2 ? 360.0 : laser.fov_deg / static_cast<double>(laser.rays - 1);
}

double heading_spacing_deg(const AccuracySettings& settings) {
  return 360.0 / static_cast<double>(settings.headings);
}

// One look around serves all headings.
bool shares_beams(const AccuracySettings& settings) {
  return !settings.heading_deg &&
         4.0 * beam_step_deg(settings.laser) <= heading_spacing_deg(settings);
}

/// The beams of all headings: beam k of the heading number j is beam `first[j]` + k of a row of
/// beams that turns left by one step each. The row is longer than a turn and is cast in pieces of
/// less than one.
class LookAround {
 public:
  LookAround(const AccuracySettings& settings, const std::vector<double>& headings_deg)
      : rays_(settings.laser.rays), step_deg_(beam_step_deg(settings.laser)) {
    for (const double heading : headings_deg) {
      first_.push_back(static_cast<std::size_t>(std::lround(heading / step_deg_)));
    }
    total_ = first_.back() + rays_;
    const auto most = static_cast<std::size_t>(std::floor(360.0 / step_deg_ + 1e-9));
    for (std::size_t from = 0; from < total_; from += most) {
      LaserModel piece = settings.laser;
      piece.rays = std::min(most, total_ - from);
      piece.fov_deg = step_deg_ * static_cast<double>(piece.rays - 1);
      const double start_deg = step_deg_ * static_cast<double>(from) - 0.5 * settings.laser.fov_deg;
      pieces_.push_back({piece, start_deg + 0.5 * piece.fov_deg});
    }
    // A single last beam has no field of view; it looks where it shall all the same.
    for (auto& piece : pieces_) piece.laser.fov_deg = std::max(piece.laser.fov_deg, 1e-9);
  }

  std::size_t total() const { return total_; }

  /// Beams of all headings from each of the places, one row of `total()` after the other.
  void cast(const GradientCaster& caster, std::span<const Point> places,
            std::vector<RangeGradient>& rows) const {
    rows.resize(places.size() * total_);
    std::vector<Pose> poses;
    std::vector<RangeGradient> beams;
    std::size_t from = 0;
    for (const Piece& piece : pieces_) {
      poses.clear();
      for (const Point p : places) {
        poses.push_back({p.x, p.y, Angle::from_degrees(piece.heading_deg)});
      }
      const std::size_t count = piece.laser.rays;
      beams.resize(places.size() * count);
      caster.cast_all(poses, piece.laser, beams);
      for (std::size_t i = 0; i < places.size(); ++i) {
        std::copy_n(beams.data() + i * count, count, rows.data() + i * total_ + from);
      }
      from += count;
    }
  }

  std::span<const RangeGradient> scan(std::span<const RangeGradient> row, std::size_t j) const {
    return row.subspan(first_[j], rays_);
  }

 private:
  struct Piece {
    LaserModel laser;
    double heading_deg = 0.0;
  };
  std::size_t rays_;
  double step_deg_;
  std::vector<std::size_t> first_;
  std::size_t total_ = 0;
  std::vector<Piece> pieces_;
};

PlaceAccuracy over_headings(std::vector<HeadingAccuracy> all) {
  const auto sort_by = [&](AccuracyBound HeadingAccuracy::*which) {
    std::stable_sort(all.begin(), all.end(), [&](const auto& p, const auto& q) {
      return (p.*which).major_m < (q.*which).major_m;
    });
  };
  const std::size_t middle = (all.size() - 1) / 2;
  PlaceAccuracy place;
  sort_by(&HeadingAccuracy::bound);
  place.worst = all.back();
  place.median = all[middle];
  sort_by(&HeadingAccuracy::with_edges);
  place.edges_worst = all.back();
  place.edges_median = all[middle];
  return place;
}

/// All headings of some places beside each other. Memory of one thread.
class PlaceCaster {
 public:
  PlaceCaster(const GradientCaster& caster, const AccuracySettings& settings,
              const BeamNoise& noise)
      : caster_(caster),
        settings_(settings),
        noise_(noise),
        headings_deg_(headings_looked_at(settings)) {
    if (shares_beams(settings)) around_.emplace(settings, headings_deg_);
  }

  void cast(std::span<const Point> places, std::span<PlaceAccuracy> results) {
    if (around_) around_->cast(caster_, places, rows_);
    for (std::size_t i = 0; i < places.size(); ++i) results[i] = at(places, i);
  }

 private:
  PlaceAccuracy at(std::span<const Point> places, std::size_t i) {
    std::vector<HeadingAccuracy> all;
    for (std::size_t j = 0; j < headings_deg_.size(); ++j) {
      const Pose pose{places[i].x, places[i].y, Angle::from_degrees(headings_deg_[j])};
      std::span<const RangeGradient> scan;
      if (around_) {
        const std::size_t total = around_->total();
        scan = around_->scan(std::span(rows_).subspan(i * total, total), j);
      } else {
        rows_.resize(settings_.laser.rays);
        caster_.cast(pose, settings_.laser, rows_);
        scan = rows_;
      }
      all.push_back(heading_accuracy(scan, pose, settings_.laser, noise_));
    }
    return over_headings(std::move(all));
  }

  const GradientCaster& caster_;
  const AccuracySettings& settings_;
  const BeamNoise& noise_;
  std::vector<double> headings_deg_;
  std::optional<LookAround> around_;
  std::vector<RangeGradient> rows_;
};

}  // namespace

std::vector<double> headings_looked_at(const AccuracySettings& settings) {
  if (settings.heading_deg) return {*settings.heading_deg};
  std::vector<double> headings;
  const double step = beam_step_deg(settings.laser);
  for (std::size_t j = 0; j < settings.headings; ++j) {
    const double heading = heading_spacing_deg(settings) * static_cast<double>(j);
    headings.push_back(shares_beams(settings) ? step * std::round(heading / step) : heading);
  }
  return headings;
}

HeadingAccuracy heading_accuracy(std::span<const RangeGradient> scan, const Pose& pose,
                                 const LaserModel& laser, const BeamNoise& noise) {
  PoseInformation information = scan_information(scan, noise.information_per_m2());
  HeadingAccuracy result{pose.theta.degrees(), accuracy_bound(information), {}};
  information += edge_information(scan, pose, laser, noise);
  result.with_edges = accuracy_bound(information);
  return result;
}

std::vector<PlaceAccuracy> accuracy_at(const GradientCaster& caster, std::span<const Point> places,
                                       const AccuracySettings& settings, unsigned threads,
                                       const Progress& progress) {
  std::vector<PlaceAccuracy> results(places.size());
  const BeamNoise noise(settings.noise, settings.laser.max_range_m);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(places.size(), kBatch, threads, [&](std::size_t begin, std::size_t end) {
    PlaceCaster(caster, settings, noise)
        .cast(places.subspan(begin, end - begin), std::span(results).subspan(begin, end - begin));
    const std::lock_guard lock(mutex);
    done += end - begin;
    if (progress) progress(done, places.size());
  });
  return results;
}

}  // namespace mapwright::navcore
