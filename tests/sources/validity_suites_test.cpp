// Validity suites of others: the ledger says changed or dropped exactly where the suite says
// invalid, and what is written is valid by GEOS.
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/sources/suites.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using test::SuiteCase;

constexpr const char* kEverythingIsSolid = R"(mapwright_rules: 1
rules:
  - name: polygons
    geometry: polygon
    kind: solid
    height: 1
    semantic: "polygon"
  - name: all the rest
    kind: ignore
    reason: not asked for
)";

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string ring_text(const Obstacle& obstacle) {
  std::ostringstream out;
  out.precision(15);
  out << "(";
  for (const auto& segment : obstacle.segments) out << segment.a.x << " " << segment.a.y << ",";
  out << obstacle.segments.front().a.x << " " << obstacle.segments.front().a.y << ")";
  return out.str();
}

// Each outline with its holes as WKT.
std::vector<std::string> polygons_of(const Map& map) {
  std::map<std::string, std::string> outlines;
  for (const auto& obstacle : map.obstacles) {
    const auto outer = obstacle.semantic.value("inner_of");
    if (outer)
      outlines[std::string(*outer)] += "," + ring_text(obstacle);
    else
      outlines[std::to_string(obstacle.id)] =
          ring_text(obstacle) + outlines[std::to_string(obstacle.id)];
  }
  std::vector<std::string> polygons;
  for (const auto& [id, rings] : outlines) polygons.push_back("POLYGON (" + rings + ")");
  return polygons;
}

struct Converted {
  std::map<std::int64_t, std::string> outcomes;  // by feature
  std::vector<std::string> polygons;
  std::string messages;
};

class ValiditySuites : public testing::Test {
 protected:
  Converted convert(const std::string& source, const std::string& layer = "") {
    const auto rules = folder_.file("rules.yaml", kEverythingIsSolid);
    const auto map = folder_.path("map.txt");
    const auto report = folder_.path("ledger.json");
    std::vector<std::string> arguments{"convert",  source, "-o",           map, "--rules", rules,
                                       "--report", report, "--skip-broken"};
    // Finer than any case: at 1 mm the small faces would vanish.
    if (layer.empty())
      arguments.insert(arguments.end(), {"--local", "--resolution", "0.000000001"});
    const auto run = test::run(arguments);
    Converted converted;
    converted.messages = run.err;
    const auto ledger = nlohmann::json::parse(text_of(report), nullptr, false);
    if (ledger.is_discarded()) return converted;
    for (const auto& feature : ledger["features"]) {
      const auto& reasons = feature["reasons"];
      const bool dropped = feature["outcome"] == "dropped";
      if (dropped && reasons[0]["code"] == "C208") continue;  // no polygon
      auto& outcome = converted.outcomes[feature["fid"]];
      if (outcome.empty() || outcome == "written") outcome = feature["outcome"];
    }
    if (std::filesystem::exists(map)) {
      converted.polygons = polygons_of(read_map(text_of(map)).map);
      std::filesystem::remove(map);
      std::filesystem::remove(folder_.path("map.georef.json"));
    }
    return converted;
  }

  // Names of the cases in which ledger and suite disagree.
  std::set<std::string> disagreements(const std::string& suite,
                                      const std::vector<SuiteCase>& cases) {
    std::string csv = "id,WKT\n";
    for (std::size_t i = 0; i < cases.size(); ++i) {
      csv += std::to_string(i) + ",\"" + cases[i].wkt + "\"\n";
    }
    const auto converted = convert(folder_.file("cases.csv", csv));
    EXPECT_EQ(converted.outcomes.size(), cases.size()) << converted.messages;
    std::set<std::string> names;
    std::map<std::string, int> counts;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto found = converted.outcomes.find(static_cast<std::int64_t>(i) + 1);
      if (found == converted.outcomes.end()) continue;
      const bool untouched = found->second == "written";
      ++counts[std::string(cases[i].valid ? "valid, " : "invalid, ") + found->second];
      if (untouched == cases[i].valid) continue;
      names.insert(cases[i].name);
      std::printf("%s: %s: suite says %s, ledger %s: %s\n", suite.c_str(), cases[i].name.c_str(),
                  cases[i].valid ? "valid" : "invalid", found->second.c_str(),
                  cases[i].wkt.substr(0, 300).c_str());
    }
    for (const auto& [what, count] : counts) {
      std::printf("%s: %d polygons %s\n", suite.c_str(), count, what.c_str());
    }
    std::size_t sound = 0;
    for (const auto& polygon : converted.polygons) {
      EXPECT_TRUE(test::is_valid_by_geos(polygon)) << polygon;
      ++sound;
    }
    std::printf("%s: %zu outlines written, all valid by GEOS\n", suite.c_str(), sound);
    return names;
  }

  test::TemporaryFolder folder_;
};

using Names = std::set<std::string>;

TEST_F(ValiditySuites, Geos) {
  MAPWRIGHT_REQUIRE_REAL_DATA("2_hostile/geos_xml/TestValid.xml");
  const auto cases = test::geos_validity_cases(test::real_data("2_hostile/geos_xml/TestValid.xml"));
  ASSERT_GT(cases.size(), 20U);
  // Nothing can be written of a polygon that is empty, valid as it is.
  EXPECT_EQ(disagreements("geos_xml", cases), Names{"A - empty shell and holes (valid)"});
}

TEST_F(ValiditySuites, Postgis) {
  MAPWRIGHT_REQUIRE_REAL_DATA("2_hostile/postgis");
  const auto cases = test::postgis_validity_cases(test::real_data("2_hostile/postgis"));
  ASSERT_GT(cases.size(), 1U);
  EXPECT_EQ(disagreements("postgis", cases), Names{});
}

TEST_F(ValiditySuites, Val3dity) {
  for (const auto* folder : {"val3dity_poly", "val3dity_generic"}) {
    MAPWRIGHT_REQUIRE_REAL_DATA(std::string("2_hostile/") + folder);
    const auto cases = test::val3dity_faces(test::real_data(std::string("2_hostile/") + folder));
    ASSERT_GT(cases.size(), 50U);
    EXPECT_EQ(disagreements(folder, cases), Names{});
  }
}

// Osmium's grid of multipolygons: one file a case.
TEST_F(ValiditySuites, Osmium) {
  MAPWRIGHT_REQUIRE_REAL_DATA("2_hostile/osm_testdata_grid");
  std::map<std::string, int> counts;
  Names names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           test::real_data("2_hostile/osm_testdata_grid"))) {
    if (entry.path().filename() != "result") continue;
    const auto folder = entry.path().parent_path();
    const std::string verdict = text_of(entry.path().string()).substr(0, 5);
    const auto test_json = nlohmann::json::parse(text_of((folder / "test.json").string()));
    if (!test_json.contains("areas")) continue;  // nodes and ways alone
    const auto converted = convert((folder / "data.osm").string(), "multipolygons");
    bool touched = converted.outcomes.empty();
    for (const auto& [fid, outcome] : converted.outcomes) touched = touched || outcome != "written";
    const bool valid = verdict == "valid";
    ++counts[std::string(valid ? "valid, " : "invalid, ") + (touched ? "touched" : "written")];
    if (touched == valid) {
      names.insert(folder.filename().string());
      std::printf("osmium: %s: suite says %s, ledger %s: %s\n%s", folder.filename().c_str(),
                  valid ? "valid" : "invalid", touched ? "touched" : "written",
                  test_json["description"].get<std::string>().c_str(), converted.messages.c_str());
    }
    for (const auto& polygon : converted.polygons) {
      EXPECT_TRUE(test::is_valid_by_geos(polygon)) << folder << polygon;
    }
  }
  for (const auto& [what, count] : counts)
    std::printf("osmium: %d cases %s\n", count, what.c_str());
  // Explained in docs/sources.md: where OSM's idea of a sound multipolygon is not the geometry's.
  EXPECT_EQ(names, (Names{"749", "903"}));
}

}  // namespace
}  // namespace mapwright
