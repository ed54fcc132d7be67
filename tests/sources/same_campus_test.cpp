// One campus in many formats and coordinate systems is one map; names survive every encoding.
#include <gdal_utils.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using test::run;

constexpr double kSame_m = 0.01;

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Dress {
  std::string driver, extension, crs;
};

std::string name_of(const Dress& dress) {
  return dress.driver + " in " + dress.crs;
}

class SameCampus : public testing::Test {
 protected:
  static void SetUpTestSuite() { GDALAllRegister(); }

  // Writes one layer of the campus in another dress.
  std::string dressed(const std::string& layer, const Dress& dress) {
    const auto source = test::real_data("campus_nord/campus_nord_25831.gpkg").string();
    const auto target = folder_.path(layer + dress.extension);
    std::vector<std::string> words{"-f", dress.driver, "-t_srs", dress.crs, "-nln", layer};
    if (dress.extension == ".mif") words.insert(words.end(), {"-dsco", "FORMAT=MIF"});
    if (dress.driver == "CSV") words.insert(words.end(), {"-lco", "GEOMETRY=AS_WKT"});
    words.push_back(layer);
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    auto* input = GDALOpenEx(source.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
    auto* options = GDALVectorTranslateOptionsNew(pointers.data(), nullptr);
    auto* output = GDALVectorTranslate(target.c_str(), nullptr, 1, &input, options, nullptr);
    EXPECT_NE(output, nullptr) << name_of(dress);
    GDALVectorTranslateOptionsFree(options);
    if (output != nullptr) GDALClose(output);
    GDALClose(input);
    return target;
  }

  Map converted(const Dress& dress) {
    const auto map = folder_.path("map.txt");
    std::vector<std::string> arguments{"convert"};
    for (const auto* layer : {"obstacles", "walls", "furniture", "steps"}) {
      arguments.push_back(dressed(layer, dress));
    }
    arguments.insert(arguments.end(), {"-o", map, "--origin", "425800,4582230", "--origin-crs",
                                       "EPSG:25831", "--heading", "-20"});
    if (dress.driver == "CSV") arguments.insert(arguments.end(), {"--source-crs", dress.crs});
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 0) << name_of(dress) << "\n" << result.err;
    return read_map(text_of(map)).map;
  }

  test::TemporaryFolder folder_;
};

double distance_between(const Obstacle& p, const Obstacle& q) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < p.segments.size(); ++k) {
    const auto& a = p.segments[k];
    const auto& b = q.segments[k];
    farthest = std::max(
        {farthest, distance(a.a, b.a), distance(a.b, b.b), std::abs(a.height_m - b.height_m)});
  }
  return farthest;
}

bool are_same(const Obstacle& p, const Obstacle& q) {
  return p.shape_type == q.shape_type && p.segments.size() == q.segments.size() &&
         distance(p.segments[0].a, q.segments[0].a) <= kSame_m &&
         p.semantic.view() == q.semantic.view() && distance_between(p, q) <= kSame_m;
}

// Formats with a spatial index (FlatGeobuf) keep features in its order.
void expect_same(const Map& expected, const Map& map, const std::string& name) {
  ASSERT_EQ(map.obstacles.size(), expected.obstacles.size()) << name;
  std::vector<bool> found(map.obstacles.size(), false);
  std::size_t lacking = 0;
  for (const auto& obstacle : expected.obstacles) {
    std::size_t i = 0;
    while (i < found.size() && (found[i] || !are_same(obstacle, map.obstacles[i]))) ++i;
    if (i < found.size())
      found[i] = true;
    else
      ++lacking;
  }
  EXPECT_EQ(lacking, 0U) << name << ": obstacles that are not the same within 1 cm";
}

TEST_F(SameCampus, InEveryFormat) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/campus_nord_25831.gpkg");
  const auto expected = converted({"GPKG", ".gpkg", "EPSG:25831"});
  ASSERT_GT(expected.obstacles.size(), 1000U);
  for (const Dress& dress : std::vector<Dress>{{"ESRI Shapefile", ".shp", "EPSG:25831"},
                                               {"FlatGeobuf", ".fgb", "EPSG:25831"},
                                               {"MapInfo File", ".mif", "EPSG:25831"},
                                               {"CSV", ".csv", "EPSG:25831"},
                                               {"GML", ".gml", "EPSG:25831"},
                                               {"GeoJSON", ".geojson", "EPSG:4326"},
                                               {"KML", ".kml", "EPSG:4326"}}) {
    const auto map = converted(dress);
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, map, name_of(dress)));
  }
}

TEST_F(SameCampus, InEveryCoordinateSystem) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/campus_nord_25831.gpkg");
  const auto expected = converted({"GPKG", ".gpkg", "EPSG:25831"});
  for (const auto* crs : {"EPSG:4326", "EPSG:4258", "EPSG:32631", "EPSG:25830", "EPSG:3857",
                          "EPSG:3035", "EPSG:2154"}) {
    const Dress dress{"GPKG", ".gpkg", crs};
    const auto map = converted(dress);
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, map, name_of(dress)));
  }
}

TEST_F(SameCampus, CatalanNamesSurviveLatin1) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/shp_25831_latin1/furniture.shp");
  const auto rules = folder_.file("rules.yaml", R"(mapwright_rules: 1
rules:
  - name: furniture
    kind: solid
    height: 1
    semantic: "furniture,name={nom}"
)");
  const auto source = test::real_data("campus_nord/shp_25831_latin1/furniture.shp").string();
  const auto result = run({"convert", source, "-o", folder_.path("map.txt"), "--rules", rules});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto text = text_of(folder_.path("map.txt"));
  EXPECT_NE(text.find("il·luminació"), std::string::npos);
}

// A zip file with 23 shapefiles of a Japanese station.
TEST_F(SameCampus, JapaneseNamesSurvive) {
  MAPWRIGHT_REQUIRE_REAL_DATA("1_gis/indoor/JRShinjukuSta_6677.zip");
  const auto rules = folder_.file("rules.yaml", R"(mapwright_rules: 1
rules:
  - name: the station
    layer: "*building"
    kind: solid
    radius: 1
    height: 1
    semantic: "name={name}"
  - name: all the rest
    kind: ignore
    reason: not asked for
)");
  const auto source = test::real_data("1_gis/indoor/JRShinjukuSta_6677.zip").string();
  const auto result = run({"convert", source, "-o", folder_.path("map.txt"), "--rules", rules});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto text = text_of(folder_.path("map.txt"));
  EXPECT_NE(text.find("新宿"), std::string::npos) << text;
}

}  // namespace
}  // namespace mapwright
