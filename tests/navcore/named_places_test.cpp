#include "navcore/named_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mapcore/tolerances.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright::navcore {
namespace {

using namespace mapwright::test;

Obstacle named(Obstacle obstacle, const std::string& name) {
  obstacle.semantic = obstacle.semantic.with_value("name", name);
  return obstacle;
}

TEST(NamedPlaces, AreTheValuesOfNameInTheOrderOfTheMap) {
  const Map site = map10({named(box(1, 1, 1, 2, 2), "Bar"), box(2, 3, 3, 4, 4),
                          named(box(3, 5, 5, 6, 6), " Café = 2 "), named(box(4, 7, 7, 8, 8), "Bar"),
                          named(box(5, 7, 1, 8, 2), "")});
  const auto places = named_places(site);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].name, "Bar");
  EXPECT_EQ(places[0].obstacles, (std::vector<std::uint32_t>{0, 3}));
  EXPECT_EQ(places[1].name, "Café = 2");
}

TEST(NamedPlaces, SimilarNamesAreTheNearest) {
  std::vector<NamedPlace> places;
  for (const char* name : {"Library", "Bench 1", "Bench 2", "Bench 12", "Café", "Lecture hall"}) {
    places.push_back({name, {}});
  }
  using Names = std::vector<std::string>;
  EXPECT_EQ(similar_names(places, "Libary"), Names{"Library"});
  EXPECT_EQ(similar_names(places, "library"), Names{"Library"});
  EXPECT_EQ(similar_names(places, "Bench 3"), (Names{"Bench 1", "Bench 2", "Bench 12"}));
  EXPECT_EQ(similar_names(places, "hall"), Names{"Lecture hall"});
  EXPECT_EQ(similar_names(places, "Swimming pool"), Names{});
}

class StandingPoint : public testing::Test {
 protected:
  std::optional<Point> beside(const Map& site, double radius_m,
                              const std::function<bool(Point)>& preferred = nullptr) const {
    const FreeSpace space(site);
    const PlaceFinder finder(site, space);
    const NamedPlace* place = finder.find("X");
    EXPECT_NE(place, nullptr);
    EXPECT_EQ(finder.find("x"), nullptr);
    const auto p = finder.standing_point(*place, radius_m, preferred);
    if (p) {
      EXPECT_TRUE(space.is_free(*p, radius_m));
    }
    return p;
  }
};

constexpr double kGap_m = tolerance::kStandoff_m;

TEST_F(StandingPoint, IsInFrontOfTheMiddleOfTheLongestSegment) {
  const auto p = beside(map10({named(box(1, 3, 4, 7, 6), "X")}), 0.3);
  ASSERT_TRUE(p.has_value());
  EXPECT_NEAR(p->x, 5.0, 1e-12);
  EXPECT_NEAR(p->y, 4.0 - 0.3 - kGap_m, 1e-12);
}

TEST_F(StandingPoint, MovesAlongWhereAnotherObstacleStandsThere) {
  const auto p = beside(map10({named(box(1, 3, 4, 7, 6), "X"), box(2, 4.9, 3, 5.1, 3.9)}), 0.3);
  ASSERT_TRUE(p.has_value());
  EXPECT_NEAR(p->x, 5.5, 1e-12);
}

TEST_F(StandingPoint, IsAsNearAsTheRobotFits) {
  // A bench in a niche 0.5 m deep and hardly wider than itself.
  const Map site =
      map10({named(box(1, 4, 9.5, 6, 9.99), "X"), box(2, 0, 9, 3.9, 10), box(3, 6.1, 9, 10, 10)});
  EXPECT_NEAR(beside(site, 0.3)->y, 9.5 - 0.3 - kGap_m, 1e-12);
  const double deepest_m = 9.0 - std::sqrt(1.5 * 1.5 - 1.1 * 1.1);  // held by the niche's corners
  EXPECT_LE(beside(site, 1.5)->y, deepest_m);
  EXPECT_NEAR(beside(site, 1.5)->y, deepest_m, 0.11);
}

TEST_F(StandingPoint, IsNowhereWithoutRoom) {
  EXPECT_EQ(beside(map10({named(box(1, 4, 4, 6, 6), "X"), box(2, 1, 1, 9, 9)}), 0.3), std::nullopt);
  EXPECT_EQ(beside(map10({named(box(1, 4, 4, 6, 6), "X")}), 2.5), std::nullopt);
}

TEST_F(StandingPoint, PrefersWhatThePlannerCanReach) {
  const Map site = map10({named(box(1, 3, 4, 7, 6), "X")});
  const auto above = [](Point p) { return p.y > 5.0; };
  EXPECT_GT(beside(site, 0.3, above)->y, 6.0);
  const auto nowhere = [](Point) { return false; };
  EXPECT_EQ(beside(site, 0.3, nowhere), beside(site, 0.3));
}

TEST_F(StandingPoint, IsInsideOfARoomAndOnARamp) {
  EXPECT_TRUE(Box({2, 2, 8, 8}).contains(*beside(map10({named(hollow(1, 2, 2, 8, 8), "X")}), 0.3)));
  EXPECT_TRUE(Box({2, 2, 8, 8}).contains(*beside(map10({named(ramp(1, 2, 2, 8, 8), "X")}), 0.3)));
}

TEST_F(StandingPoint, IsBesideStairsAndThinWalls) {
  EXPECT_LT(beside(map10({named(stairs(1, 2, 8, 4, 3), "X")}), 0.3)->y, 4.0);
  EXPECT_NE(beside(map10({named(wall(1, {{2, 5}, {8, 5}}), "X")}), 0.3), std::nullopt);
}

}  // namespace
}  // namespace mapwright::navcore
