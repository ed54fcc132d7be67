// Many poses, many threads, little memory: the numbers stay the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/ray_exactness.hpp"
#include "tests/navcore_engine/engines.hpp"

namespace mapwright::navcore {
namespace {

const Map& campus() {
  static const Map kMap = bench::generate_campus(bench::kCampus100m);
  return kMap;
}

std::vector<float> cast(const ScanEngine& engine, const std::vector<Pose>& poses,
                        const LaserModel& laser, unsigned threads) {
  std::vector<float> ranges(poses.size() * laser.rays);
  engine.cast_all(poses, laser, ranges, threads);
  return ranges;
}

TEST(ScanEngineBatch, SameBytesForAnyNumberOfThreads) {
  const auto poses = bench::poses_everywhere(campus(), 3001, 1);
  const LaserModel laser;
  test::on_each_instruction_set(campus(), [&](const ScanEngine& engine) {
    const auto expected = cast(engine, poses, laser, 1);
    for (const unsigned threads : {2U, 3U, 8U, 0U}) {
      EXPECT_EQ(cast(engine, poses, laser, threads), expected) << threads;
    }
  });
}

TEST(ScanEngineBatch, OnePoseAtATimeGivesTheSame) {
  const auto poses = bench::poses_everywhere(campus(), 300, 2);
  const LaserModel laser;
  test::on_each_instruction_set(campus(), [&](const ScanEngine& engine) {
    const auto all = cast(engine, poses, laser, 1);
    std::vector<double> one(laser.rays);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      engine.cast(poses[i], laser, one);
      for (std::size_t j = 0; j < laser.rays; ++j) {
        ASSERT_EQ(one[j], static_cast<double>(all[i * laser.rays + j]));
      }
    }
  });
}

// Scans from one cell share work; a scan alone does not. Any field of view, staircases and ramps
// seen and not seen, groups of all sizes.
TEST(ScanEngineBatch, TogetherAndAloneGiveTheSame) {
  const auto poses = bench::poses_in_clusters(campus(), 2400, 5);
  for (const LaserModel& laser :
       {LaserModel{131, 180.0, 15.0, 0.5}, LaserModel{90, 360.0, 15.0, 0.1},
        LaserModel{1081, 270.0, 15.0, 0.3}, LaserModel{5, 40.0, 9.0, 0.2},
        LaserModel{1, 10.0, 15.0, 0.4}}) {
    test::on_each_instruction_set(campus(), [&](const ScanEngine& engine) {
      const auto all = cast(engine, poses, laser, 1);
      std::vector<double> one(laser.rays);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        engine.cast(poses[i], laser, one);
        for (std::size_t j = 0; j < laser.rays; ++j) {
          ASSERT_EQ(static_cast<float>(one[j]), all[i * laser.rays + j]) << i << ' ' << j;
        }
      }
    });
  }
}

// Every pose must come back in its own place, wherever its cell puts it among the others.
TEST(ScanEngineBatch, OrderDoesNotMatter) {
  auto poses = bench::poses_in_clusters(campus(), 1500, 6);
  const LaserModel laser;
  const std::vector<double> scan(laser.rays, 5.0);
  test::on_each_instruction_set(campus(), [&](const ScanEngine& engine) {
    std::vector<double> forward(poses.size()), backward(poses.size());
    engine.weigh(scan, laser, report_likelihood(), poses, forward, 1);
    const std::vector<Pose> turned(poses.rbegin(), poses.rend());
    engine.weigh(scan, laser, report_likelihood(), turned, backward, 2);
    std::reverse(backward.begin(), backward.end());
    EXPECT_EQ(forward, backward);
  });
}

TEST(ScanEngineBatch, LittleMemoryCostsTimeOnly) {
  const LaserModel laser;
  const ScanEngine roomy(campus());
  ScanEngineOptions options;
  options.cell_memory_bytes = std::size_t{1} << 19U;
  const ScanEngine tight(campus(), options);
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto poses = bench::poses_everywhere(campus(), 400, seed);
    ASSERT_EQ(cast(tight, poses, laser, 2), cast(roomy, poses, laser, 1));
  }
  // What one call asked for, and the generation before it.
  EXPECT_LT(tight.cell_statistics(laser).bytes, std::size_t{3} << 19U);
  EXPECT_LT(tight.cell_statistics(laser).cells, roomy.cell_statistics(laser).cells);
}

TEST(ScanEngineBatch, ManyThreadsMayCallAtOnce) {
  const auto poses = bench::poses_everywhere(campus(), 500, 3);
  const LaserModel laser;
  const auto expected = cast(ScanEngine(campus()), poses, laser, 1);
  ScanEngineOptions options;
  options.cell_memory_bytes = std::size_t{1} << 18U;
  const ScanEngine engine(campus(), options);
  std::vector<std::vector<float>> results(4);
  {
    std::vector<std::jthread> threads;
    for (auto& result : results) {
      threads.emplace_back([&] {
        for (int i = 0; i < 5; ++i) result = cast(engine, poses, laser, 2);
      });
    }
  }
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

TEST(ScanEngineBatch, LasersTakeTurns) {
  const auto poses = bench::poses_everywhere(campus(), 50, 4);
  const ScanEngine engine(campus());
  for (int round = 0; round < 2; ++round) {
    for (const double height : {0.1, 0.3, 0.5, 0.7, 0.9, 1.1}) {
      LaserModel laser;
      laser.height_m = height;
      EXPECT_EQ(cast(engine, poses, laser, 1), cast(ScanEngine(campus()), poses, laser, 1));
    }
  }
}

}  // namespace
}  // namespace mapwright::navcore
