// OpenStreetMap files as layers of features.
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "converter/osm/osm_reader.hpp"
#include "tests/cli/program_run.hpp"

namespace mapwright::converter {
namespace {

struct Read {
  std::map<std::string, std::vector<SourceFeature>> features;  // by layer
  std::vector<std::string> fields;
};

class Osm : public testing::Test {
 protected:
  static std::string node(int id, double lat, double lon, const std::string& tags = "") {
    return "<node id='" + std::to_string(id) + "' lat='" + std::to_string(lat) + "' lon='" +
           std::to_string(lon) + "'>" + tags + "</node>";
  }
  static std::string tag(const std::string& key, const std::string& value) {
    return "<tag k='" + key + "' v='" + value + "'/>";
  }
  static std::string way(int id, const std::vector<int>& nodes, const std::string& tags = "") {
    std::string text = "<way id='" + std::to_string(id) + "'>";
    for (const int n : nodes) text += "<nd ref='" + std::to_string(n) + "'/>";
    return text + tags + "</way>";
  }
  // A square of nodes first, first + 1 … counter-clockwise.
  static std::string square(int first, double low, double size) {
    return node(first, low, low) + node(first + 1, low, low + size) +
           node(first + 2, low + size, low + size) + node(first + 3, low + size, low);
  }

  OpenedReader open(const std::string& content) {
    return open_osm(folder_.file("a.osm", "<osm version='0.6'>" + content + "</osm>"));
  }

  Read read(const std::string& content) {
    auto reader = open(content);
    EXPECT_TRUE(reader) << (reader ? "" : reader.error().message);
    Read all;
    if (!reader) return all;
    for (std::size_t i = 0; i < (*reader)->layers().size(); ++i) {
      const auto& layer = (*reader)->layers()[i];
      all.fields = layer.fields;
      auto& features = all.features[layer.name];
      const auto count =
          (*reader)->read(i, {}, [&](SourceFeature& feature) { features.push_back(feature); });
      EXPECT_EQ(count.value_or(0), features.size());
    }
    return all;
  }

  test::TemporaryFolder folder_;
};

// Of nodes with one id the last counts, in whatever order they come; ways may say where nodes lie
// (Overpass), and count where no node says it.
TEST_F(Osm, PlacesOfNodes) {
  std::string many;
  for (int i = 400; i > 0; --i) many += node(-i, 0.5, 0.001 * i);
  auto all = read(many + node(7, 0.1, 0.1) + node(5, 0.2, 0.3) + node(7, 0.4, 0.6) +
                  way(1, {5, 7, -250, -400}, tag("barrier", "wall")));
  const auto& g = all.features.at("lines").at(0).geometry;
  EXPECT_EQ(g.xs, (std::vector<double>{0.3, 0.6, 0.25, 0.4}));
  EXPECT_EQ(g.ys, (std::vector<double>{0.2, 0.4, 0.5, 0.5}));
  auto given =
      read(node(1, 0.1, 0.2) +
           "<way id='3'><nd ref='1' lat='0.9' lon='0.9'/><nd ref='2' lat='0.5' lon='0.6'/>" +
           tag("barrier", "wall") +
           "</way><way id='4'><nd ref='2' lat='0.7' lon='0.7'/>"
           "<nd ref='1'/></way>");
  EXPECT_EQ(given.features.at("lines").at(0).geometry.xs, (std::vector<double>{0.2, 0.6}));
}

TEST_F(Osm, SortsWaysIntoLinesAndPolygons) {
  const auto all = read(square(1, 0.0, 0.001) + way(10, {1, 2, 3, 4, 1}, tag("building", "yes")) +
                        way(11, {1, 2, 3, 4, 1}, tag("barrier", "wall")) +
                        way(12, {1, 2}, tag("highway", "path")) + way(13, {2, 3}) +
                        way(14, {1, 2, 3, 1}, tag("building", "yes") + tag("area", "no")));
  ASSERT_EQ(all.features.size(), 2U);
  ASSERT_EQ(all.features.at("polygons").size(), 1U);
  EXPECT_EQ(all.features.at("polygons")[0].fid, 10);
  EXPECT_EQ(all.features.at("lines").size(), 3U);
}

TEST_F(Osm, TakesObjectsInAnyOrderAndNegativeNumbers) {
  const auto all = read(way(-10, {-1, -2, -3, -1}, tag("building", "yes")) + node(-1, 0, 0) +
                        node(-2, 0, 0.001) + node(-3, 0.001, 0));
  ASSERT_EQ(all.features.at("polygons").size(), 1U);
  EXPECT_EQ(all.features.at("polygons")[0].fid, -10);
  EXPECT_EQ(all.features.at("polygons")[0].geometry.xs.size(), 4U);
}

TEST_F(Osm, PutsMultipolygonsTogether) {
  const auto all = read(square(1, 0.0, 0.003) + square(5, 0.001, 0.001) + way(10, {1, 2, 3}) +
                        way(11, {3, 4, 1}) + way(12, {5, 6, 7, 8, 5}) +
                        "<relation id='20'><member type='way' ref='10' role='outer'/>"
                        "<member type='way' ref='11' role='outer'/>"
                        "<member type='way' ref='12' role='inner'/>" +
                        tag("type", "multipolygon") + tag("building", "yes") + "</relation>");
  ASSERT_EQ(all.features.size(), 1U);
  const auto& feature = all.features.at("multipolygons").at(0);
  ASSERT_EQ(feature.geometry.paths.size(), 2U);
  EXPECT_EQ(feature.geometry.paths[0].role, PathRole::kOuterRing);
  EXPECT_EQ(feature.geometry.paths[1].role, PathRole::kInnerRing);
  EXPECT_TRUE(feature.broken.empty());
  EXPECT_TRUE(feature.warnings.empty());
}

TEST_F(Osm, LendsAMultipolygonWithoutTagsThoseOfItsOuterWay) {
  const auto all =
      read(square(1, 0.0, 0.003) + square(5, 0.001, 0.001) +
           way(10, {1, 2, 3, 4, 1}, tag("building", "yes")) + way(12, {5, 6, 7, 8, 5}) +
           "<relation id='20'><member type='way' ref='10' role='outer'/>"
           "<member type='way' ref='12' role='inner'/>" +
           tag("type", "multipolygon") + "</relation>");
  ASSERT_EQ(all.features.size(), 1U) << "the outer way is no building of its own";
  EXPECT_EQ(all.features.at("multipolygons").at(0).values.at(0), FieldValue(std::string("yes")));
}

TEST_F(Osm, SaysWhatTheFileLacks) {
  const auto all = read(node(1, 0, 0) + node(2, 0, 0.001) + node(4, 0, 0.003) + node(5, 0, 0.004) +
                        way(10, {1, 2, 3, 4, 5}, tag("barrier", "wall")) +
                        way(11, {1, 2, 3, 1}, tag("building", "yes")) +
                        "<relation id='20'><member type='way' ref='99' role='outer'/>" +
                        tag("type", "multipolygon") + tag("building", "yes") + "</relation>");
  const auto& wall = all.features.at("lines").at(0);
  EXPECT_EQ(wall.geometry.paths.size(), 2U) << "both sides of the gap";
  ASSERT_EQ(wall.warnings.size(), 1U);
  EXPECT_NE(wall.warnings[0].find("lacks 1 of its 5 nodes"), std::string::npos);
  EXPECT_NE(all.features.at("polygons").at(0).broken.find("lacks 1 of its 4 nodes"),
            std::string::npos);
  EXPECT_NE(all.features.at("multipolygons").at(0).broken.find("lacks 1 of its 1 ways"),
            std::string::npos);
}

TEST_F(Osm, HandsOverCrossingRingsForRepair) {
  const auto all = read(node(1, 0, 0) + node(2, 0.001, 0.001) + node(3, 0, 0.001) +
                        node(4, 0.001, 0) + way(10, {1, 2, 3, 4, 1}) +
                        "<relation id='20'><member type='way' ref='10' role='outer'/>" +
                        tag("type", "multipolygon") + tag("building", "yes") + "</relation>");
  const auto& feature = all.features.at("multipolygons").at(0);
  EXPECT_EQ(feature.geometry.paths.size(), 1U);
  ASSERT_EQ(feature.warnings.size(), 1U);
  EXPECT_NE(feature.warnings[0].find("cross"), std::string::npos) << feature.warnings[0];
}

// Two rooms side by side with a door in the wall they share.
TEST_F(Osm, MakesWallsOfOsmAgAreas) {
  const auto room = tag("osmAG:type", "area") + tag("osmAG:areaType", "room") + tag("level", "1");
  const auto all =
      read(node(1, 0, 0) + node(2, 0, 0.001) + node(3, 0.0004, 0.001) + node(4, 0.0006, 0.001) +
           node(5, 0.001, 0.001) + node(6, 0.001, 0) + node(7, 0, 0.002) + node(8, 0.001, 0.002) +
           way(-10, {1, 2, 3, 4, 5, 6, 1}, room) + way(-11, {2, 7, 8, 5, 4, 3, 2}, room) +
           way(-12, {3, 4}, tag("osmAG:type", "passage") + tag("level", "1")));
  const auto& features = all.features.at("osmAG level 1");
  ASSERT_EQ(features.size(), 3U);
  std::size_t edges = 0;
  for (const auto& feature : features) {
    if (feature.fid == -12) continue;
    for (const auto& path : feature.geometry.paths) edges += path.count - 1;
  }
  EXPECT_EQ(edges, 8U) << "five of the first room, three of the second, the door in neither";
}

TEST_F(Osm, FiltersBySqlCondition) {
  auto reader = open(node(1, 0, 0, tag("natural", "tree")) + node(2, 0, 0.1, tag("a", "b")));
  ASSERT_TRUE(reader);
  ReadOptions options;
  options.where = "\"natural\" = 'tree'";
  int selected = 0;
  const auto count = (*reader)->read(
      0, options, [&](SourceFeature& feature) { selected += feature.selected ? 1 : 0; });
  EXPECT_EQ(count.value_or(0), 2U);
  EXPECT_EQ(selected, 1);
  options.where = "nonsense (";
  EXPECT_EQ((*reader)->read(0, options, [](SourceFeature&) {}).error().kind, FailureKind::kUsage);
}

TEST_F(Osm, RefusesDamagedFiles) {
  const auto message = [&](const std::string& name, const std::string& text) {
    const auto reader = open_osm(folder_.file(name, text));
    return reader ? std::string("opened") : reader.error().message;
  };
  EXPECT_NE(message("a.osm", "<osm version='0.6'><node id='1'").find("damaged"), std::string::npos);
  EXPECT_NE(message("a.osm", "<osm version='0.6'></osm>").find("no tagged object"),
            std::string::npos);
  EXPECT_NE(message("a.osm.pbf", "nonsense").find("damaged"), std::string::npos);
  EXPECT_NE(message("a.osc", "<osmChange/>").find("changes"), std::string::npos);
}

// What a file says, and the same in a zip file and in a tar file.
TEST_F(Osm, InArchivesIsTheSame) {
  const std::string content = "<osm version='0.6'>" + square(1, 10, 0.001) +
                              way(7, {1, 2, 3, 4, 1}, tag("building", "yes")) + "</osm>";
  const auto converted = [&](const std::string& source) {
    const std::string map = folder_.path("m.txt");
    const auto result = test::run({"convert", source, "-o", map});
    EXPECT_EQ(result.status, 0) << result.err;
    std::ifstream in(map);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto plain = converted(folder_.file("site.osm", content));
  const std::string zip = folder_.path("site.zip");
  auto* out = VSIFOpenL(("/vsizip/" + zip + "/data/site.osm").c_str(), "wb");
  ASSERT_NE(out, nullptr);
  VSIFWriteL(content.data(), 1, content.size(), out);
  VSIFCloseL(out);
  EXPECT_NE(plain.find("obstacle"), std::string::npos);
  EXPECT_EQ(converted(zip), plain);
}

TEST_F(Osm, LevelsOnTopOfEachOtherAreWarnedOf) {
  const auto area = [&](int id, int first, const std::string& level) {
    return way(id, {first, first + 1, first + 2, first + 3, first},
               tag("osmAG:type", "area") + tag("level", level));
  };
  const std::string one = square(1, 10, 0.001) + area(7, 1, "1");
  EXPECT_TRUE((*open(one))->take_warnings().empty());
  const auto warnings = (*open(one + square(11, 10, 0.001) + area(8, 11, "2")))->take_warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("--layer 'osmAG level 1'"), std::string::npos);
}

}  // namespace
}  // namespace mapwright::converter
