// Localization on recorded scans: adaptive NP and NL, kidnapping, the verdict.
#include "navcore/localization/recorded_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "navcore/engine/scan_engine.hpp"
#include "navcore/localization/roaming.hpp"
#include "navcore/localization/scan_agreement.hpp"
#include "navcore/sensors/laser_noise.hpp"

namespace mapwright::navcore {
namespace {

TEST(KldSampling, GivesFoxsNumbers) {
  const KldSettings settings{0.05, 2.326, 1.0, 10.0, 1};
  EXPECT_EQ(kld_sample_size(0, settings), 1.0);
  EXPECT_EQ(kld_sample_size(1, settings), 1.0);
  // By hand: 1 / 0.1 · (1 − 2/9 + √(2/9) · 2.326)³.
  EXPECT_NEAR(kld_sample_size(2, settings), 65.841, 0.01);
  // Tables: the 99 % quantile of chi-square is 134.642 for 99 degrees of freedom and 1106.97 for
  // 1000; the sample size is quantile / 2ε.
  EXPECT_NEAR(kld_sample_size(100, settings), 134.642 / 0.1, 1.0);
  EXPECT_NEAR(kld_sample_size(1001, settings), 1106.97 / 0.1, 2.0);
}

TEST(KldSampling, CountsBinsOfPlaceAndHeading) {
  const KldSettings settings{0.05, 2.326, 0.5, 10.0, 1};
  const auto pose = [](double x, double y, double deg) {
    return Pose{x, y, Angle::from_degrees(deg)};
  };
  const std::vector<Pose> poses{pose(0.1, 0.1, 1),  pose(0.4, 0.4, 9),   pose(0.6, 0.1, 1),
                                pose(0.1, -0.1, 1), pose(0.1, 0.1, -11), pose(0.1, 0.1, 349)};
  EXPECT_EQ(occupied_bins(poses, settings), 4U);
}

TEST(ScanQuality, CountsTenTenthsOfAScanAsOne) {
  ScanQuality whole({0.05, 0.5}), tenths({0.05, 0.5});
  for (ScanQuality* quality : {&whole, &tenths}) quality->add(0.9);
  whole.add(0.3);
  for (int i = 0; i < 10; ++i) tenths.add(0.3, false, 0.1);
  EXPECT_GT(whole.share_lost(), 0.2);
  EXPECT_NEAR(tenths.share_lost(), whole.share_lost(), 1e-12);
}

TEST(ScanQuality, IsLostWhileScansFitWorseThanTheyUsedTo) {
  ScanQuality quality({0.05, 0.5});
  for (int i = 0; i < 20; ++i) quality.add(2.0);
  EXPECT_NEAR(quality.share_lost(), 0.0, 1e-12);
  quality.add(0.2);
  EXPECT_GT(quality.share_lost(), 0.3);
  ScanQuality lost = quality;
  for (int i = 0; i < 300; ++i) lost.add(0.2, true);
  EXPECT_NEAR(lost.share_lost(), 0.9, 0.05);  // nobody gets used to a wrong place
  lost.begin_anew(2.0);
  EXPECT_NEAR(lost.share_lost(), 0.0, 0.05);
  for (int i = 0; i < 300; ++i) quality.add(0.2);
  EXPECT_NEAR(quality.share_lost(), 0.0, 1e-3);
}

TEST(AgreeingShare, IsOneWhereAllBeamsEndAsTheMapSaysAndZeroWhereNoneDoes) {
  const LikelihoodModel model{LikelihoodKind::kRobust, 1.0, 0.5, 0.5, 0.15};
  const double all = std::log(1.0 / (0.15 * 2.5066282746));  // density of the normal part's peak
  const double none = std::log(0.5 / 25.0);
  EXPECT_NEAR(agreeing_share(all, model, 25.0), 1.0, 1e-9);
  EXPECT_NEAR(agreeing_share(none, model, 25.0), 0.0, 1e-9);
  EXPECT_NEAR(agreeing_share(0.25 * all + 0.75 * none, model, 25.0), 0.25, 1e-9);
  EXPECT_EQ(agreeing_share(none - 1.0, model, 25.0), 0.0);
}

TEST(ScanAgreement, IsAnAverageFromTheFirstScanOn) {
  ScanAgreement agreement(0.2);
  agreement.add(0.8);
  EXPECT_NEAR(agreement.mean(), 0.8, 1e-12);
  agreement.add(0.3);
  EXPECT_NEAR(agreement.mean(), (0.8 * 0.8 + 0.3) / 1.8, 1e-12);
  EXPECT_NEAR(agreement.scans(), 2.0, 1e-12);
  ScanAgreement tenths = agreement;
  agreement.add(0.1);
  for (int i = 0; i < 10; ++i) tenths.add(0.1, 0.1);
  EXPECT_NEAR(tenths.mean(), agreement.mean(), 1e-12);
  agreement.begin_anew();
  agreement.add(0.6);
  EXPECT_NEAR(agreement.mean(), 0.6, 1e-12);
}

RecordedScan scan_of(std::size_t beams, double first_deg, double step_deg) {
  RecordedScan scan;
  scan.fan = {beams, Angle::from_degrees(first_deg), Angle::from_degrees(step_deg)};
  for (std::size_t i = 0; i < beams; ++i) scan.ranges.push_back(0.1 * static_cast<double>(i));
  return scan;
}

TEST(SampleBeams, TakesEquallySpacedBeamsAndKnowsWhereTheyLook) {
  for (const std::size_t wanted : {2U, 3U, 7U, 60U, 61U, 91U, 179U, 180U, 500U}) {
    const RecordedScan scan = scan_of(180, -90.0, 1.0);
    const SampledScan sampled = sample_beams(scan, wanted, 100.0, 0.5);
    ASSERT_LE(sampled.laser.rays, wanted);
    ASSERT_GE(2 * sampled.laser.rays, std::min<std::size_t>(wanted, 180));
    for (std::size_t i = 0; i < sampled.laser.rays; ++i) {
      const double direction_deg = sampled.heading.degrees() + ray_angle_deg(sampled.laser, i);
      // The ranges say which beam it was.
      EXPECT_NEAR(direction_deg, -90.0 + 10.0 * sampled.ranges[i], 1e-9) << wanted;
    }
  }
}

TEST(SampleBeams, ReadingsBeyondTheRangeSayNoMore) {
  RecordedScan scan = scan_of(3, -90.0, 90.0);
  scan.ranges = {4.0, std::numeric_limits<double>::infinity(), 11.0};
  EXPECT_EQ(sample_beams(scan, 3, 10.0, 0.5).ranges, (std::vector<double>{4.0, 10.0, 10.0}));
}

RecordedIteration iteration(bool right, double x) {
  RecordedIteration result;
  result.reference = Pose{x, 0.0, Angle()};
  result.position_error_m = right ? 0.1 : 2.0;
  return result;
}

RecordedRun run_of(const std::string& pattern) {  // '+' right, '-' wrong; a metre a scan
  RecordedRun run;
  for (const char c : pattern) {
    run.iterations.push_back(iteration(c == '+', static_cast<double>(run.iterations.size())));
  }
  return run;
}

TEST(Judge, WantsTheLastTenthRightAndAlmostAllBefore) {
  EXPECT_TRUE(judge(run_of("++++++++++")).strict_from_start);
  const auto late = judge(run_of("---+++++++"));
  EXPECT_TRUE(late.strict);
  EXPECT_FALSE(late.strict_from_start);
  EXPECT_EQ(late.right_from, 3U);
  EXPECT_NEAR(late.way_m, 3.0, 1e-12);
  EXPECT_FALSE(judge(run_of("+++++++++-")).strict);
  EXPECT_EQ(judge(run_of("+++++-++++")).right_from, 6U);  // one of ten is more than 2 %
  const auto blip = judge(run_of(std::string(40, '+') + "-" + std::string(60, '+')));
  EXPECT_EQ(blip.right_from, 0U);
  EXPECT_TRUE(blip.strict_from_start);
}

// -- a simulated robot, recorded ------------------------------------------------------------------

Map hall() {
  Map map;
  map.border = {0.0, 20.0, 30.0, 0.0};
  std::int64_t id = 0;
  const auto block = [&](double left, double bottom, double right, double top) {
    Obstacle obstacle{++id, ShapeType::kClosedPolygon, "block", {}};
    const std::vector<Point> corners{{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    for (std::size_t i = 0; i < 4; ++i) {
      obstacle.segments.push_back({corners[i], corners[(i + 1) % 4], 3.0, InOut::kIndoor, "wall"});
    }
    map.obstacles.push_back(std::move(obstacle));
  };
  block(0.0, 0.0, 30.0, 0.5);
  block(0.0, 19.5, 30.0, 20.0);
  block(0.0, 0.5, 0.5, 19.5);
  block(29.5, 0.5, 30.0, 19.5);
  block(4.0, 4.0, 9.0, 6.0);
  block(13.0, 3.0, 14.0, 9.0);
  block(20.0, 12.0, 26.0, 15.0);
  block(5.0, 12.0, 7.0, 17.0);
  block(22.0, 4.0, 23.0, 5.0);
  return map;
}

constexpr std::size_t kScans = 60;
constexpr std::size_t kKidnapped = 30;  // the first scan elsewhere

// Drives about, is carried off between two scans, drives on. Odometry does not notice.
std::vector<RecordedStep> kidnapped_drive(const FreeSpace& space, const RayCaster& caster) {
  Random random(7);
  const LaserModel laser{181, 180.0, 25.0, 0.5};
  Pose pose{2.0, 2.0, Angle::from_degrees(60.0)};
  Pose odometry;
  std::vector<RecordedStep> steps;
  for (std::size_t i = 0; i < kScans; ++i) {
    if (i == kKidnapped) {
      pose = {27.0, 17.5, Angle::from_degrees(-120.0)};
    } else if (i > 0) {
      const OdometryStep step = stroll(space, pose, 0.5, 0.4, random);
      pose = moved(pose, step);
      odometry = moved(odometry, perturbed(step, {}, random));
    }
    RecordedStep step{{0, static_cast<double>(i), {}, {}, odometry}, odometry, pose};
    step.scan.fan = {181, Angle::from_degrees(-90.0), Angle::from_degrees(1.0)};
    step.scan.ranges = perceive(caster, pose, laser, {0.03, 0.1}, random);
    steps.push_back(std::move(step));
  }
  return steps;
}

class Kidnapping : public testing::Test {
 protected:
  RecordedRun run(const RecordedSettings& settings, std::uint64_t seed) {
    auto result = run_recorded(space_, engine_, settings, steps_, 0, kScans - 1, seed);
    EXPECT_TRUE(result);
    return *std::move(result);
  }

  RecordedSettings tracking() {
    RecordedSettings settings = recorded_settings();
    settings.initial_pose = steps_.front().reference;
    settings.patience = 5;  // the map is whole: what does not fit is elsewhere
    return settings;
  }

  Map map_ = hall();
  FreeSpace space_{map_};
  ScanEngine engine_{map_};
  std::vector<RecordedStep> steps_ = kidnapped_drive(space_, engine_);
};

TEST_F(Kidnapping, IsNoticedAndRecoveredFrom) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RecordedRun result = run(tracking(), seed);
    for (std::size_t i = 10; i < kKidnapped; ++i) {
      EXPECT_TRUE(result.iterations[i].is_right()) << "seed " << seed << " scan " << i;
    }
    for (std::size_t i = kKidnapped + 22; i < kScans; ++i) {
      EXPECT_TRUE(result.iterations[i].is_right()) << "seed " << seed << " scan " << i;
    }
  }
}

TEST_F(Kidnapping, IsFatalWithoutExtraParticles) {
  RecordedSettings settings = tracking();
  settings.recover.elsewhere_particles = 0;
  settings.patience = kScans;
  EXPECT_FALSE(run(settings, 1).iterations.back().is_right());
}

TEST_F(Kidnapping, TracksWithFewParticlesAndSearchesWithMany) {
  const RecordedRun result = run(tracking(), 1);
  EXPECT_LT(result.iterations[kKidnapped - 1].update.particles, 400U);
  EXPECT_TRUE(result.iterations[kKidnapped - 1].tracked);
  bool searched = false;
  for (std::size_t i = kKidnapped; i < kKidnapped + 16; ++i) {
    searched = searched || result.iterations[i].update.particles > 4000;
  }
  EXPECT_TRUE(searched);
}

TEST_F(Kidnapping, AWrongStartIsDoubtedAlthoughNoScanEverFittedBetter) {
  RecordedSettings settings = tracking();
  settings.initial_pose = Pose{17.0, 17.0, Angle::from_degrees(200.0)};
  const auto last_is_right = [&] {
    const auto result = run_recorded(space_, engine_, settings, steps_, 0, kKidnapped - 1, 1);
    return result && result->iterations.back().is_right();
  };
  EXPECT_TRUE(last_is_right());
  settings.least_agreement = 0.0;
  EXPECT_FALSE(last_is_right());
}

// From scan `first` to before `end` a share of the beams sees what it would see elsewhere on the
// map.
void dream(std::vector<RecordedStep>& steps, const RayCaster& caster, std::size_t first,
           std::size_t end, double share) {
  const LaserModel laser{181, 180.0, 25.0, 0.5};
  Random random(9);
  std::vector<double> ranges(181);
  Pose pose{27.0, 17.5, Angle::from_degrees(-120.0)};
  for (std::size_t i = first; i < end; ++i) {
    pose = moved(pose, step_between(steps[i - 1].odometry, steps[i].odometry));
    caster.cast(pose, laser, ranges);
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      if (random.uniform() < share) steps[i].scan.ranges[j] = ranges[j];
    }
  }
}

std::string right_scans(const RecordedRun& run) {  // '+' right, '-' wrong
  std::string signs;
  for (const auto& iteration : run.iterations) signs += iteration.is_right() ? '+' : '-';
  return signs;
}

TEST_F(Kidnapping, WhoGaveWayComesBackAtOnceWhenItWasRight) {
  constexpr std::size_t kEnd = 24;
  dream(steps_, engine_, 10, kEnd, 0.85);
  const auto signs = [&](double regret_scans) {
    RecordedSettings settings = tracking();
    settings.patience = 3.0;  // easily convinced
    settings.conviction = 30.0;
    settings.conviction_scans = 2.0;
    settings.regret_scans = regret_scans;
    const auto result = run_recorded(space_, engine_, settings, steps_, 0, kKidnapped - 1, 1);
    return result ? right_scans(*result) : std::string();
  };
  const std::string with = signs(20.0), without = signs(0.0);
  EXPECT_EQ(with[kEnd - 1], '-') << with;  // the dream was convincing
  EXPECT_EQ(with.find('-', kEnd + 1), std::string::npos) << with;
  EXPECT_NE(without.find('-', kEnd + 1), std::string::npos) << without;
}

TEST_F(Kidnapping, AShortDreamConvincesNobody) {
  dream(steps_, engine_, 10, 13, 0.8);
  const auto result = run_recorded(space_, engine_, tracking(), steps_, 0, kKidnapped - 1, 1);
  ASSERT_TRUE(result);
  const std::string signs = right_scans(*result);
  EXPECT_EQ(signs.find('-', 15), std::string::npos) << signs;
}

TEST_F(Kidnapping, SameSeedSameRun) {
  const RecordedRun first = run(tracking(), 5);
  const RecordedRun second = run(tracking(), 5);
  for (std::size_t i = 0; i < kScans; ++i) {
    EXPECT_EQ(first.iterations[i].estimate.pose, second.iterations[i].estimate.pose);
  }
}

TEST_F(Kidnapping, TheUnknownHeadingIsFoundFromScratch) {
  RecordedSettings settings = recorded_settings();
  settings.filter.first_particles = 50000;
  const auto result = run_recorded(space_, engine_, settings, steps_, 0, kKidnapped - 1, 1);
  ASSERT_TRUE(result);
  EXPECT_TRUE(judge(*result).strict);
}

}  // namespace
}  // namespace mapwright::navcore
