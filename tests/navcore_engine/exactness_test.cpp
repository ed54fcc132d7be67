// The scan engine against double precision.
#include "bench/support/ray_exactness.hpp"

#include <gtest/gtest.h>

#include "bench/support/campus_generator.hpp"
#include "navcore/engine/aligned.hpp"
#include "navcore/engine/cell_compiler.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/culled_ray_caster.hpp"
#include "tests/navcore/shapes.hpp"
#include "tests/navcore_engine/engines.hpp"

namespace mapwright::navcore {
namespace {

const LaserModel kLasers[] = {{131, 180.0, 15.0, 0.5},
                              {361, 360.0, 15.0, 0.05},
                              {97, 270.0, 8.0, 1.2},
                              {17, 33.0, 15.0, 0.3}};

void expect_exact(const Map& map, const ScanEngineOptions& options, std::size_t poses,
                  std::uint64_t seed) {
  const CulledRayCaster reference(map);
  test::on_each_instruction_set(
      map,
      [&](const ScanEngine& engine) {
        for (const LaserModel& laser : kLasers) {
          for (const auto& where : {bench::poses_everywhere(map, poses, seed),
                                    bench::poses_in_clusters(map, poses, seed)}) {
            const auto result = bench::measure_exactness(map, engine, reference, where, laser);
            EXPECT_EQ(result.wrong, 0U) << result.first_wrong;
            EXPECT_LE(result.worst_error_m, bench::kTolerance_m);
            EXPECT_GT(result.stopped, poses);  // or nothing was tested
          }
        }
      },
      options);
}

TEST(ScanEngineExactness, OnGeneratedCampuses) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    expect_exact(bench::generate_campus({100.0, 520, seed}), {}, 200, seed);
  }
}

TEST(ScanEngineExactness, OnADenseCampus) {
  expect_exact(bench::generate_campus({50.0, 520, 4}), {}, 150, 4);
}

TEST(ScanEngineExactness, WithCellsOfAnySize) {
  const Map map = bench::generate_campus({60.0, 300, 5});
  for (const double size : {0.1, 0.37, 3.0, 25.0}) {
    ScanEngineOptions options;
    options.cell_size_m = size;
    expect_exact(map, options, 60, 5);
  }
}

TEST(ScanEngineExactness, OnClutteredSquares) {
  for (const std::uint64_t seed : {1U, 2U}) {
    expect_exact(test::cluttered_square(seed), {}, 150, seed);
  }
}

// More staircases in sight than a vector has lanes, which are searched in several turns.
TEST(ScanEngineExactness, AmongManyStairs) {
  Random random(8);
  Map map{{0.0, 20.0, 20.0, 0.0}, {}};
  for (std::int64_t id = 1; id <= 60; ++id) {
    const test::Placement at{{random.uniform(1, 19), random.uniform(1, 19)},
                             random.uniform(0, 6.3)};
    map.obstacles.push_back(test::stairs(id, at, 10, 0.15, random.uniform(0.3, 1.0)));
  }
  const engine::Scene scene(map);
  const auto walls = engine::compile_cell(scene, {0.5, 15.0, 1.0}, {10.5, 10.5});
  EXPECT_GT(walls.stairs.size(), engine::kBlock);
  expect_exact(map, {}, 100, 8);
}

// Lists longer than a vector, of walls and of ramps.
TEST(ScanEngineExactness, AmongManyRamps) {
  Random random(9);
  Map map{{0.0, 20.0, 20.0, 0.0}, {}};
  for (std::int64_t id = 1; id <= 80; ++id) {
    const test::Placement at{{random.uniform(1, 19), random.uniform(1, 19)},
                             random.uniform(0, 6.3)};
    map.obstacles.push_back(id % 2 == 0 ? test::ramp(id, at, random.uniform(0.2, 1.0), 6.0, 0.2)
                                        : test::wall(id, at({0, 0}), at({0.3, 0.1}), 2.0));
  }
  const engine::Scene scene(map);
  const auto walls = engine::compile_cell(scene, {0.5, 15.0, 1.0}, {10.5, 10.5});
  EXPECT_GT(walls.two_sided.size(), engine::kBlock);
  EXPECT_GT(walls.one_sided.size(), engine::kBlock);
  expect_exact(map, {}, 100, 9);
}

// Ten kilometres from the frame's origin, where single precision alone is off by half a millimetre.
TEST(ScanEngineExactness, FarFromTheOrigin) {
  Map map = bench::generate_campus({60.0, 300, 6});
  const Point offset{10'000.0, -7'000.0};
  for (auto& obstacle : map.obstacles) {
    for (auto& segment : obstacle.segments) {
      segment.a = segment.a + offset;
      segment.b = segment.b + offset;
    }
  }
  map.border = {map.border.left + offset.x, map.border.top + offset.y, map.border.right + offset.x,
                map.border.bottom + offset.y};
  expect_exact(map, {}, 150, 6);
}

// Whole metres and right angles: rays run along walls, through corners, along steps, and the laser
// stands on walls.
TEST(ScanEngineExactness, OnTheGridLinesOfATown) {
  const Map map = test::rectilinear_town();
  const CulledRayCaster reference(map);
  std::vector<Pose> poses;
  for (int x = 0; x <= 60; x += 2) {
    for (int y = 0; y <= 60; ++y) {
      poses.push_back({static_cast<double>(x), static_cast<double>(y), Angle()});
    }
  }
  test::on_each_instruction_set(map, [&](const ScanEngine& engine) {
    const auto result =
        bench::measure_exactness(map, engine, reference, poses, LaserModel{37, 360.0, 15.0, 0.5});
    EXPECT_EQ(result.wrong, 0U) << result.first_wrong;
  });
}

TEST(ScanEngineExactness, SingleRaysAreExact) {
  const Map map = bench::generate_campus(bench::kCampus100m);
  const ScanEngine engine(map);
  const BruteForceRayCaster exact(map);
  for (const Pose& pose : bench::poses_everywhere(map, 4000, 9)) {
    const Point direction = unit_vector_deg(pose.theta.degrees());
    for (const double range : {3.0, 40.0, 1000.0}) {
      ASSERT_NEAR(engine.cast_ray(pose.position(), pose.theta, 0.3, range),
                  exact.cast_ray(pose.position(), direction, 0.3, range), 1e-9)
          << pose.x << ' ' << pose.y << ' ' << pose.theta.degrees();
    }
  }
}

}  // namespace
}  // namespace mapwright::navcore
