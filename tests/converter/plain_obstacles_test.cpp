// The short way and the long way through a conversion make the same map and the same ledger.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <sstream>

#include "converter/pipeline/convert.hpp"
#include "converter/rules/rule_reader.hpp"
#include "mapcore/random.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;
using test::GisFeature;

constexpr const char* kRules = R"(mapwright_rules: 1
rules:
  - { name: houses, layer: "houses*", kind: solid, height: [height, 3], semantic: "house,{label},name={name}" }
  - { name: rooms, layer: rooms, kind: room, height: 2.5 }
  - { name: walls, layer: walls, kind: wall, height: [height, 2], semantic: "wall,{label}" }
  - { name: steps, layer: steps, kind: steps, stair_id: stair_id, step_no: no, height: height }
)";

std::string ring(double x, double y, double side, bool clockwise) {
  const auto at = [&](double dx, double dy) {
    return std::to_string(x + dx * side) + " " + std::to_string(y + dy * side);
  };
  const std::string second = clockwise ? at(0, 1) : at(1, 0);
  const std::string fourth = clockwise ? at(1, 0) : at(0, 1);
  return "(" + at(0, 0) + "," + second + "," + at(1, 1) + "," + fourth + "," + at(0, 0) + ")";
}

// Houses of every make: courtyards, parts, bow-ties, doubled points, no area.
std::vector<GisFeature> houses(Random& random, int count, double east) {
  std::vector<GisFeature> features;
  for (int i = 0; i < count; ++i) {
    const double x = east + 30.0 * (i % 20), y = 30.0 * (i / 20);
    const bool clockwise = random.below(2) == 0;
    const std::string outer = ring(x, y, 20, clockwise);
    std::string wkt = "POLYGON(" + outer + ")";
    const auto make = random.below(8);
    if (make == 0)
      wkt = "POLYGON(" + outer + "," + ring(x + 5, y + 5, 8, random.below(2) == 0) + ")";
    if (make == 1)
      wkt = "MULTIPOLYGON((" + ring(x, y, 9, clockwise) + "),(" + ring(x + 12, y, 7, true) + "))";
    if (make == 2) {
      const auto p = [&](double dx, double dy) {
        return std::to_string(x + dx) + " " + std::to_string(y + dy);
      };
      wkt = "POLYGON((" + p(0, 0) + "," + p(9, 9) + "," + p(9, 0) + "," + p(0, 9) + "," + p(0, 0) +
            "))";
      if (i % 3 == 0)
        wkt = "POLYGON((" + p(0, 0) + "," + p(9, 0) + "," + p(9, 0) + "," + p(9, 9) + "," +
              p(0, 0) + "))";
      if (i % 3 == 1)
        wkt =
            "POLYGON((" + p(0, 0) + "," + p(0.0001, 0) + "," + p(0, 0.0002) + "," + p(0, 0) + "))";
    }
    GisFeature feature{wkt, {{"name", "H " + std::to_string(i)}}};
    if (random.below(3) > 0) feature.attributes["height"] = std::to_string(random.uniform(-1, 9));
    if (random.below(2) == 0) feature.attributes["label"] = i % 5 == 0 ? "brick;red" : "brick";
    features.push_back(std::move(feature));
  }
  return features;
}

// Along houses, with and against their sides; closed ones; polygons; one that is a step of stairs.
std::vector<GisFeature> walls(Random& random) {
  std::vector<GisFeature> features{
      {"LINESTRING(0 -20,2 -20)", {}},
      {"LINESTRING(700 0,705 0,705 5,700 5,700 0)", {}},
      {"LINESTRING(710 0,715 5,715 0,710 5)", {}},
      {"POLYGON" + std::string("((720 0,730 0,730 1,720 1,720 0))"), {}}};
  for (int i = 0; i < 60; ++i) {
    const double x = 30.0 * (i % 20), y = 30.0 * (i / 20);
    const auto a = std::to_string(x) + " " + std::to_string(y);
    const auto b = std::to_string(x + 20) + " " + std::to_string(y);
    features.push_back({"LINESTRING(" + (random.below(2) == 0 ? a + "," + b : b + "," + a) + ")",
                        {{"height", std::to_string(1 + i % 3)}, {"label", "fence"}}});
  }
  return features;
}

struct Outcomes {
  std::string map, ledger;
};

Outcomes converted(const std::vector<std::string>& sources, double snap_m) {
  ConvertOptions options;
  options.sources = sources;
  options.rules = read_rules(kRules, "test").value();
  options.local = true;
  options.snap_m = snap_m;
  const auto conversion = convert(options);
  EXPECT_TRUE(conversion) << conversion.error().message;
  EXPECT_TRUE(balances(conversion->ledger));
  std::ostringstream map, ledger;
  conversion->map.write(map, {conversion->resolution_m});
  write_ledger(conversion->ledger, ledger);
  EXPECT_EQ(map.str(), format_map(conversion->map.whole()));
  return {map.str(), ledger.str()};
}

// Snapping asks for the whole drawing, so nothing is plain; a micrometre moves nothing.
TEST(PlainObstacles, ComeOutAsDraftsDo) {
  const auto folder =
      fs::path(testing::TempDir()) / ("plain_obstacles_test_" + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto first = (folder / "a.gpkg").string(), second = (folder / "b.gpkg").string();
  Random random(7);
  test::write_gis(
      first, "GPKG",
      {{"walls", "", walls(random)},
       {"houses", "", houses(random, 120, 0.0)},
       {"steps",
        "",
        {{"LINESTRING(0 -20,2 -20)", {{"stair_id", "s"}, {"no", "1"}, {"height", "0.2"}}},
         {"LINESTRING(0 -19.7,2 -19.7)", {{"stair_id", "s"}, {"no", "2"}, {"height", "0.4"}}},
         {"LINESTRING(0 -25,2 -25)", {}}}}});
  test::write_gis(second, "GPKG",
                  {{"rooms", "", {{"POLYGON((0 0,0 9,9 9,9 0,0 0),(2 2,3 2,3 3,2 3,2 2))", {}}}},
                   {"houses", "", houses(random, 60, 2000.0)},
                   {"houses of old", "", houses(random, 60, 4000.0)}});
  const auto plain = converted({first, second}, 0.0);
  const auto drafts = converted({first, second}, 1e-6);
  EXPECT_TRUE(plain.map == drafts.map);
  EXPECT_TRUE(plain.ledger == drafts.ledger);
  for (const char* code : {"C201", "C202", "C204", "C212", "C215", "C216", "C228"}) {
    EXPECT_NE(plain.ledger.find(code), std::string::npos) << code << " is not tried";
  }
  EXPECT_NE(plain.map.find("inner_of="), std::string::npos);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace mapwright::converter
