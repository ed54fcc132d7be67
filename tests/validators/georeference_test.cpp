// Sidecars that do not fit their map: each way of going wrong is found, sound ones are let alone.
#include <gtest/gtest.h>

#include "mapcore/random.hpp"
#include "tests/validators/mutators.hpp"
#include "validators/georeference_checks.hpp"

namespace mapwright::validators {
namespace {

constexpr std::uint64_t kMutants = 40;

std::string codes_of(const std::vector<Finding>& findings) {
  std::string codes;
  for (const auto& finding : findings) codes += std::string(finding_type(finding.code).id) + " ";
  return codes;
}

Georeference somewhere(Random& random) {
  Georeference georeference;
  georeference.origin_latitude_deg = random.uniform(-89.0, 89.0);
  georeference.origin_longitude_deg = random.uniform(-180.0, 180.0);
  georeference.heading_deg = random.uniform(-180.0, 180.0);
  return georeference;
}

void move(Border& border, Point by) {
  border.left += by.x;
  border.right += by.x;
  border.top += by.y;
  border.bottom += by.y;
}

TEST(Georeference, OfACleanMapIsSound) {
  for (std::uint64_t seed = 1; seed <= kMutants; ++seed) {
    Random random(seed);
    const Map map = test::clean_map(seed);
    EXPECT_EQ(codes_of(check_georeference(map, somewhere(random))), "");
    EXPECT_EQ(codes_of(check_georeference(map, std::nullopt)), "");
  }
}

TEST(Georeference, IsMissedWhereFeaturesAreNamed) {
  for (std::uint64_t seed = 1; seed <= kMutants; ++seed) {
    Random random(seed);
    Map map = test::clean_map(seed);
    auto& semantic = map.obstacles[random.below(map.obstacles.size())].semantic;
    semantic = semantic.with_value(semantic_key::kSource, "buildings:12");
    EXPECT_EQ(codes_of(check_georeference(map, std::nullopt)), "C240 ");
    EXPECT_EQ(codes_of(check_georeference(map, somewhere(random))), "");
  }
}

TEST(Georeference, FarFromTheMapIsFound) {
  for (std::uint64_t seed = 1; seed <= kMutants; ++seed) {
    Random random(seed);
    Map map = test::clean_map(seed);
    const bool east = random.below(2) == 0;
    const double by_m = (random.below(2) == 0 ? -1.0 : 1.0) * random.uniform(31.0e3, 4.0e6);
    move(map.border, east ? Point{by_m, 0.0} : Point{0.0, by_m});
    const auto findings = check_georeference(map, somewhere(random));
    ASSERT_EQ(codes_of(findings), "C242 ");
    EXPECT_TRUE(map.border.contains(findings.front().at.value()));
  }
}

TEST(Georeference, NearTheLimitIsSound) {
  Random random(1);
  Map map = test::clean_map(1);
  move(map.border, {29.9e3 - map.border.left, 0.0});
  EXPECT_EQ(codes_of(check_georeference(map, somewhere(random))), "");
}

TEST(Georeference, InTheGulfOfGuineaIsUnset) {
  const Map map = test::clean_map(1);
  Georeference georeference;
  EXPECT_EQ(codes_of(check_georeference(map, georeference)), "C243 ");
  georeference.origin_longitude_deg = 9.67;  // Gabon lies on the equator too
  EXPECT_EQ(codes_of(check_georeference(map, georeference)), "");
}

}  // namespace
}  // namespace mapwright::validators
