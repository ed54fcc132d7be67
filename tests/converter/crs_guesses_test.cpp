// Drawings whose CRS nobody states, and what the detective makes of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "converter/detective/crs_guesses.hpp"
#include "converter/frame/local_frame.hpp"

namespace mapwright::converter {
namespace {

using Draw = std::function<Point(Point)>;

SourceGeometry path_of(std::vector<Point> points, PathRole role, const Draw& draw) {
  SourceGeometry geometry;
  for (const Point p : points) {
    const Point q = draw(p);
    geometry.xs.push_back(q.x);
    geometry.ys.push_back(q.y);
  }
  geometry.paths.push_back({0, static_cast<std::uint32_t>(points.size()), role, false});
  return geometry;
}

// A street of turned houses of 12 by 8 m over some 200 m, and a flight of steps 30 cm deep.
DrawingEvidence street(const Draw& draw, bool with_steps) {
  EvidenceCollector collector;
  for (int i = 0; i < 30; ++i) {
    const Point u{std::cos(0.5), std::sin(0.5)}, v{-u.y, u.x};
    const Point o{7.0 * i, 3.0 * i};
    collector.add("buildings", path_of({o, o + 12.0 * u, o + 12.0 * u + 8.0 * v, o + 8.0 * v, o},
                                       PathRole::kOuterRing, draw));
  }
  for (int i = 0; with_steps && i < 10; ++i) {
    collector.add("steps", path_of({{0.3 * i, 0.0}, {0.3 * i, 2.0}}, PathRole::kLine, draw));
  }
  return collector.evidence();
}

// A drawing in metres about Barcelona or Rotterdam, in a CRS.
class Placed {
 public:
  explicit Placed(const char* code)
      : transform_(*CrsTransform::create(*parse_crs(code))), frame_(origin_of(code)) {}

  Point operator()(Point metres) const {
    const GeoPoint place = frame_.to_wgs84(metres);
    std::array<double, 1> x{place.longitude_deg}, y{place.latitude_deg};
    transform_.from_wgs84(x, y);
    return {x[0], y[0]};
  }

 private:
  static Georeference origin_of(const std::string& code) {
    Georeference g;
    g.origin_latitude_deg = code == "EPSG:28992" ? 51.92 : 41.389;
    g.origin_longitude_deg = code == "EPSG:28992" ? 4.48 : 2.113;
    return g;
  }

  CrsTransform transform_;
  LocalFrame frame_;
};

Draw placed_in(const char* code) {
  return [placed = std::make_shared<Placed>(code)](Point p) { return (*placed)(p); };
}

std::string first_remedy(const DrawingEvidence& evidence) {
  const auto guesses = guess_crs(evidence, {});
  return guesses.empty() ? "" : guesses.front().remedy;
}

TEST(CrsGuesses, KnowDegrees) {
  const auto evidence = street(placed_in("EPSG:4326"), false);
  EXPECT_EQ(first_remedy(evidence), "--source-crs EPSG:4326");
}

TEST(CrsGuesses, KnowExchangedDegreesByTheirRightAngles) {
  const auto exchanged = [placed = placed_in("EPSG:4326")](Point p) {
    const Point q = placed(p);
    return Point{q.y, q.x};
  };
  EXPECT_EQ(first_remedy(street(exchanged, false)), "--source-crs EPSG:4326 --swap-axes");
}

TEST(CrsGuesses, KnowPlainMetres) {
  EXPECT_EQ(first_remedy(street([](Point p) { return p; }, false)), "--local");
  EXPECT_EQ(first_remedy(street([](Point p) { return p; }, true)), "--local");
}

TEST(CrsGuesses, KnowFeetByTheStepsAndMillimetresByTheWalls) {
  EXPECT_EQ(first_remedy(street([](Point p) { return (1.0 / 0.3048) * p; }, true)),
            "--local --local-unit 0.3048");
  EXPECT_EQ(first_remedy(street([](Point p) { return 1000.0 * p; }, false)),
            "--local --local-unit 0.001");
}

TEST(CrsGuesses, KnowUtmButNotItsZone) {
  const auto guesses = guess_crs(street(placed_in("EPSG:25831"), false), {});
  ASSERT_FALSE(guesses.empty());
  EXPECT_NE(guesses.front().remedy.find("EPSG:326ZZ"), std::string::npos);
  EXPECT_NE(guesses.front().because.find("latitude 41.3"), std::string::npos);
}

TEST(CrsGuesses, TellWebMercatorByItsLongMetres) {
  const auto evidence = street(placed_in("EPSG:3857"), true);
  EXPECT_EQ(first_remedy(evidence), "--source-crs EPSG:3857");
}

TEST(CrsGuesses, OfferNationalGridsThatHoldThePlace) {
  const auto guesses = guess_crs(street(placed_in("EPSG:28992"), true), {}, 10);
  const auto dutch = std::find_if(guesses.begin(), guesses.end(), [](const CrsGuess& guess) {
    return guess.remedy == "--source-crs EPSG:28992";
  });
  ASSERT_NE(dutch, guesses.end());
  EXPECT_NE(dutch->because.find("51.92 N, 4.48 E"), std::string::npos) << dutch->because;
}

TEST(CrsGuesses, BelieveANeighbourInTheSamePlaceFirst) {
  const auto evidence = street(placed_in("EPSG:25831"), false);
  const auto crs = parse_crs("EPSG:25831");
  ASSERT_TRUE(crs);
  const Neighbour beside{"walls.shp", *crs, evidence.extent};
  const Neighbour elsewhere{"far.shp", *parse_crs("EPSG:2154"), {0.0, 0.0, 10.0, 10.0}};
  const auto guesses = guess_crs(evidence, {elsewhere, beside});
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(guesses.front().remedy, "--source-crs EPSG:25831");
  EXPECT_NE(guesses.front().because.find("walls.shp"), std::string::npos);
}

TEST(CrsGuesses, SayNothingOfNothing) {
  EXPECT_TRUE(guess_crs(DrawingEvidence{}, {}).empty());
  EXPECT_EQ(guesses_text(DrawingEvidence{}, {}), "");
}

}  // namespace
}  // namespace mapwright::converter
