// `mapwright export`: back to GIS and from there to the same map again.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mapcore/georeference.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"
#include "tests/support/file_content.hpp"
#include "tests/support/gis_files.hpp"
#include "tests/support/random_map.hpp"
#include "tests/support/random_site.hpp"

namespace mapwright {
namespace {

using test::content;
using test::project_file;
using test::run;
using test::TemporaryFolder;

const std::vector<std::string> kFormats{"gpkg", "shp", "geojson", "fgb", "kml", "dxf"};

// Exports a map, converts that without any option and returns the map's text, or what went wrong.
std::string round_trip(const TemporaryFolder& folder, const std::string& map,
                       const std::string& extension, const std::vector<std::string>& more = {}) {
  const std::string out = folder.path("x." + extension);
  for (const char* left : {"back.txt", "back.georef.json"}) {
    std::filesystem::remove(folder.path(left));
  }
  std::vector<std::string> arguments{"export", map, "-o", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto exported = run(arguments);
  if (exported.status != 0) return "export: " + exported.err;
  const auto converted = run({"convert", out, "-o", folder.path("back.txt")});
  if (converted.status > 1) return "convert: " + converted.err;
  return content(folder.path("back.txt"));
}

// The first line in which two texts differ; empty for equal ones.
std::string difference(const std::string& actual, const std::string& expected) {
  if (actual == expected) return {};
  std::istringstream a(actual), b(expected);
  std::string line_a, line_b;
  for (int number = 1;; ++number) {
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (more_a && more_b && line_a == line_b) continue;
    return "line " + std::to_string(number) + ": '" + (more_a ? line_a : "(end)") + "' for '" +
           (more_b ? line_b : "(end)") + "'";
  }
}

std::string sidecar(double latitude, double longitude, double heading, FrameProjection projection,
                    const std::string& crs) {
  Georeference georeference;
  georeference.origin_latitude_deg = latitude;
  georeference.origin_longitude_deg = longitude;
  georeference.origin_height_m = 71.5;
  georeference.heading_deg = heading;
  georeference.projection = projection;
  georeference.sources = {{"site.gpkg", "buildings", crs}};
  return format_georeference(georeference);
}

TEST(Export, SamplesComeBackToTheByte) {
  const TemporaryFolder folder;
  for (const std::string name :
       {"samples/campus/campus.txt", "samples/fib_square/fib_square.txt"}) {
    const std::string map = project_file(name).string();
    const bool has_place = std::filesystem::exists(sidecar_path(map));
    for (const auto& format : kFormats) {
      if (format == "kml" && !has_place) continue;
      EXPECT_EQ(difference(round_trip(folder, map, format), content(map)), "")
          << name << " " << format;
    }
  }
}

TEST(Export, FrameComesBackAsItWas) {
  const TemporaryFolder folder;
  const std::string map = folder.file("m.txt", content(project_file("samples/campus/campus.txt")));
  folder.file("m.georef.json", sidecar(-41.123456789012, 174.98765432109, -31.4381726561,
                                       FrameProjection::kEastNorthUp, "EPSG:2193"));
  const auto before = parse_georeference(content(folder.path("m.georef.json")));
  for (const auto& format : kFormats) {
    EXPECT_EQ(difference(round_trip(folder, map, format), content(map)), "") << format;
    auto after = parse_georeference(content(folder.path("back.georef.json")));
    ASSERT_TRUE(after);
    EXPECT_EQ(after->origin_latitude_deg, before->origin_latitude_deg) << format;
    EXPECT_EQ(after->origin_longitude_deg, before->origin_longitude_deg) << format;
    EXPECT_EQ(after->origin_height_m, before->origin_height_m) << format;
    EXPECT_EQ(after->heading_deg, before->heading_deg) << format;
    EXPECT_EQ(after->projection, before->projection) << format;
  }
}

// Coordinate systems whose way there and back is exact, nearly exact, and far off the plane.
TEST(Export, RandomSitesComeBackToTheByte) {
  const TemporaryFolder folder;
  const std::vector<std::string> crs{"EPSG:25831", "EPSG:4326",  "EPSG:3857",
                                     "EPSG:23031", "EPSG:27572", "map"};
  const std::vector<double> resolutions{1e-3, 1e-2, 1e-4, 1e-5, 5e-3};
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Random random(seed);
    const double resolution = resolutions[random.below(resolutions.size())];
    const bool has_place = random.below(5) != 0;
    const bool is_enu = random.below(4) == 0;
    test::RandomSiteOptions options;
    options.resolution_m = resolution;
    options.half_side_m = random.below(3) == 0 ? 4000.0 : 200.0;
    const Map site = test::random_site(random, options);
    const std::string text = format_map(site, {resolution});
    const std::string map = folder.file("m.txt", text);
    std::filesystem::remove(folder.path("m.georef.json"));
    if (has_place) {
      folder.file(
          "m.georef.json",
          sidecar(random.uniform(41, 44), random.uniform(1, 4), random.uniform(-180, 180),
                  is_enu ? FrameProjection::kEastNorthUp : FrameProjection::kTransverseMercator,
                  ""));
    }
    for (const auto& format : kFormats) {
      const bool is_bound = format == "kml" || !has_place;
      if (format == "kml" && !has_place) continue;
      const bool drops_empty = format == "dxf" || format == "fgb";
      const auto& name = crs[random.below(crs.size())];
      const auto more =
          is_bound ? std::vector<std::string>{} : std::vector<std::string>{"--crs", name};
      Map expected = site;
      if (drops_empty) {
        std::erase_if(expected.obstacles, [](const auto& o) { return o.segments.empty(); });
      }
      EXPECT_EQ(
          difference(round_trip(folder, map, format, more), format_map(expected, {resolution})), "")
          << "seed " << seed << " " << format << " " << name;
    }
  }
}

// Whatever the format can hold, numbers beyond all reason included, in metres of its own frame.
TEST(Export, AnyMapComesBackThroughFormatsWithoutLimits) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Random random(seed);
    const Map any = test::random_map(random);
    if (any.obstacles.empty()) continue;  // nothing to convert
    const std::string map = folder.file("m.txt", format_map(any));
    for (const std::string format : {"gpkg", "geojson"}) {
      EXPECT_EQ(difference(round_trip(folder, map, format), content(map)), "")
          << seed << " " << format;
    }
  }
}

TEST(Export, FineResolutionsKeepTheirDecimals) {
  const TemporaryFolder folder;
  Random random(7);
  test::RandomSiteOptions options;
  options.resolution_m = 1e-6;
  options.sound = true;
  const std::string text = format_map(test::random_site(random, options), {1e-6});
  const std::string map = folder.file("m.txt", text);
  folder.file("m.georef.json",
              sidecar(41.38, 2.11, -20.0, FrameProjection::kTransverseMercator, "EPSG:25831"));
  for (const std::string format : {"gpkg", "shp", "geojson", "fgb"}) {
    EXPECT_EQ(difference(round_trip(folder, map, format), text), "") << format;
  }
}

class ExportedEdits : public testing::Test {
 protected:
  void SetUp() override {
    const auto result = run({"export", project_file("samples/campus/campus.txt").string(), "-o",
                             folder_.path("x.gpkg")});
    ASSERT_EQ(result.status, 0) << result.err;
    RegisterOGRGeoPackage();
    before_ = read_map(content(project_file("samples/campus/campus.txt").string())).map;
  }

  void edit(const std::vector<std::string>& statements) {
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(folder_.path("x.gpkg").c_str(),
                                                         GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr,
                                                         nullptr, nullptr));
    for (const auto& statement : statements) {
      CPLErrorReset();
      dataset->ReleaseResultSet(dataset->ExecuteSQL(statement.c_str(), nullptr, nullptr));
      ASSERT_EQ(CPLGetLastErrorType(), CE_None) << statement << CPLGetLastErrorMsg();
    }
  }

  void with_layer(const std::string& name, const std::function<void(OGRLayer&)>& change) {
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(folder_.path("x.gpkg").c_str(),
                                                         GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr,
                                                         nullptr, nullptr));
    change(*dataset->GetLayerByName(name.c_str()));
  }

  Map converted() {
    const auto result = run({"convert", folder_.path("x.gpkg"), "-o", folder_.path("back.txt")});
    EXPECT_LE(result.status, 1) << result.err;
    return read_map(content(folder_.path("back.txt"))).map;
  }

  static Obstacle& obstacle(Map& map, std::int64_t id) {
    return *std::find_if(map.obstacles.begin(), map.obstacles.end(),
                         [&](const auto& o) { return o.id == id; });
  }

  TemporaryFolder folder_;
  Map before_;
};

TEST_F(ExportedEdits, MovedVertexIsAllThatChanges) {
  const Obstacle original = obstacle(before_, 3);
  with_layer("solids", [&](OGRLayer& layer) {
    layer.SetAttributeFilter("id = 3");
    const OGRFeatureUniquePtr feature(layer.GetNextFeature());
    auto* ring = feature->GetGeometryRef()->toPolygon()->getExteriorRing();
    ring->setPoint(2, ring->getX(2) + 0.3, ring->getY(2) + 0.4);
    ASSERT_EQ(layer.SetFeature(feature.get()), OGRERR_NONE);
  });
  Map after = converted();
  Obstacle& moved = obstacle(after, 3);
  EXPECT_NEAR(distance(moved.segments[2].a, original.segments[2].a), 0.5, 0.001);
  EXPECT_EQ(moved.segments[1].b, moved.segments[2].a);
  moved.segments[1].b = moved.segments[2].a = original.segments[2].a;
  EXPECT_EQ(after, before_);
}

TEST_F(ExportedEdits, FieldsCount) {
  edit({"UPDATE solids SET height = 9.5, name = 'Aula Magna', kind = 'hall' WHERE id = 3",
        "UPDATE walls SET in_out = 'indoor' WHERE part = 1", "DELETE FROM solids WHERE id = 4"});
  const Map after = converted();
  Map expected = before_;
  auto& hall = obstacle(expected, 3);
  for (auto& segment : hall.segments) segment.height_m = 9.5;
  hall.semantic = "hall,name=Aula Magna";
  for (auto& wall : expected.obstacles) {
    if (!is_open_chain(wall.shape_type)) continue;
    const Segment first = wall.segments.front();
    for (auto& segment : wall.segments) {
      const bool same = segment.height_m == first.height_m && segment.semantic == first.semantic;
      if (!same) break;
      segment.in_out = InOut::kIndoor;
    }
  }
  std::erase_if(expected.obstacles, [](const auto& o) { return o.id == 4; });
  EXPECT_EQ(after, expected);
}

TEST_F(ExportedEdits, WhatIsDrawnAnewGetsTheNextId) {
  with_layer("solids", [](OGRLayer& layer) {
    const OGRFeatureUniquePtr other(layer.GetFeature(1));
    OGREnvelope box;
    other->GetGeometryRef()->getEnvelope(&box);
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("kind", "kiosk");
    feature.SetField("height", 2.5);
    auto* polygon = new OGRPolygon;
    auto* ring = new OGRLinearRing;
    const double x = box.MinX - 3.0, y = box.MinY;
    for (const auto& [dx, dy] : {std::pair(0, 0), {0, 1}, {1, 1}, {1, 0}, {0, 0}}) {
      ring->addPoint(x + dx, y + dy);
    }
    polygon->addRingDirectly(ring);
    feature.SetGeometryDirectly(polygon);
    ASSERT_EQ(layer.CreateFeature(&feature), OGRERR_NONE);
  });
  Map after = converted();
  ASSERT_EQ(after.obstacles.size(), before_.obstacles.size() + 1);
  const Obstacle kiosk = after.obstacles.back();
  EXPECT_EQ(kiosk.id, before_.obstacles.back().id + 1);
  EXPECT_EQ(kiosk.semantic, Semantic("kiosk"));
  EXPECT_EQ(kiosk.segments.size(), 4U);
  after.obstacles.pop_back();
  EXPECT_EQ(after, before_);
}

TEST(Export, TwoExportsInOneMapKeepTheFirstsIds) {
  const TemporaryFolder folder;
  const std::string one =
      "border;0;9;9;0;#obstacle;1;2;1;wall;#1;1;2;1;2;1;brick;#obstacle;2;2;1;wall;#1;2;2;2;2;1;;#";
  const std::string two = "border;0;9;9;0;#obstacle;2;2;1;fence;#5;5;6;5;1;1;;#";
  ASSERT_EQ(run({"export", folder.file("a.txt", one), "-o", folder.path("a.gpkg")}).status, 0);
  ASSERT_EQ(run({"export", folder.file("b.txt", two), "-o", folder.path("b.gpkg")}).status, 0);
  const auto result = run({"convert", folder.path("a.gpkg"), folder.path("b.gpkg"), "-o",
                           folder.path("c.txt"), "--report", folder.path("c.json")});
  ASSERT_EQ(result.status, 0) << result.err;
  const Map map = read_map(content(folder.path("c.txt"))).map;
  ASSERT_EQ(map.obstacles.size(), 3U);
  EXPECT_EQ(map.obstacles[0].id, 1);
  EXPECT_EQ(map.obstacles[1].id, 2);
  EXPECT_EQ(map.obstacles[2].id, 3);
  EXPECT_NE(content(folder.path("c.json")).find("C260"), std::string::npos);
}

TEST(Export, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const std::string map = project_file("samples/fib_square/fib_square.txt").string();
  const auto refused = [&](std::vector<std::string> arguments, int status,
                           const std::string& words) {
    arguments.insert(arguments.begin(), "export");
    const auto result = run(arguments);
    EXPECT_EQ(result.status, status) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  };
  refused({map, "-o", folder.path("x.doc")}, 2, ".gpkg, .shp, .geojson");
  refused({map, "-o", folder.path("x.kml")}, 2, "no sidecar");
  refused({map, "-o", folder.path("x.gpkg"), "--crs", "EPSG:25831"}, 2, "no sidecar");
  refused({map, "-o", folder.path("none/x.gpkg")}, 4, "there is no folder");
  refused({folder.path("none.txt"), "-o", folder.path("x.gpkg")}, 3, "none.txt");
  refused({folder.file("b.txt", "border;0;1;1"), "-o", folder.path("x.gpkg")}, 3, "b.txt");
  refused({map, "-o", folder.path("x.gpkg"), "--laser-height", "1"}, 2, "occupancy");
  const std::string placed = project_file("samples/campus/campus.txt").string();
  refused({placed, "-o", folder.path("x.gpkg"), "--crs", "EPSG:1"}, 2, "--crs");
  folder.file("bad.txt", content(placed));
  folder.file("bad.georef.json", "{");
  refused({folder.path("bad.txt"), "-o", folder.path("x.gpkg")}, 3, "bad.georef.json");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("."))) {
    EXPECT_NE(entry.path().extension(), ".gpkg") << entry.path();
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
  }
}

TEST(Export, OverwritesWhatTheUserNamesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string map = project_file("samples/fib_square/fib_square.txt").string();
  folder.file("x.gpkg", "old");
  for (int i = 0; i < 2; ++i) {
    const auto result = run({"export", map, "-o", folder.path("x.gpkg")});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("no georeference"), std::string::npos);
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("."))) {
    files += entry.is_regular_file() ? 1 : 2;
  }
  EXPECT_EQ(files, 1U);
}

}  // namespace
}  // namespace mapwright
