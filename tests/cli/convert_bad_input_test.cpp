// Bad input: each has its exit status and message, and leaves no map behind.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/cli/program_run.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright {
namespace {

using test::GisLayer;
using test::run;
using test::TemporaryFolder;

namespace fs = std::filesystem;

class BadInput : public testing::Test {
 protected:
  void refuse(const std::string& source, int status, const std::string& message,
              const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"convert", source, "-o", folder_.path("map.txt")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.status, status) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
    for (const auto& entry : fs::directory_iterator(folder_.path(""))) {
      EXPECT_EQ(entry.path().filename().string().find("map."), std::string::npos) << entry.path();
    }
  }

  std::string shapefile() {
    test::write_gis(folder_.path("walls.shp"), "ESRI Shapefile",
                    {{"walls",
                      "EPSG:25831",
                      {{"LINESTRING(430000 4580000,430010 4580001)", {{"height", "2"}}},
                       {"LINESTRING(430000 4580010,430010 4580011)", {{"height", "2"}}}},
                      wkbLineString}});
    return folder_.path("walls.shp");
  }

  static std::string content_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string geojson(const std::string& geometry) {
    return folder_.file(
        "site.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)" +
            geometry + "}]}");
  }

  TemporaryFolder folder_;
};

TEST_F(BadInput, MissingFile) {
  refuse(folder_.path("none.shp"), 3, "there is no such file");
}
TEST_F(BadInput, EmptyFile) {
  refuse(folder_.file("e.gpkg", ""), 3, "the file is empty");
}
TEST_F(BadInput, Pipe) {
  const auto pipe = folder_.path("site.geojson");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  refuse(pipe, 3, "site.geojson: is a pipe or a device: sources are files");
}
TEST_F(BadInput, EmptyFolder) {
  fs::create_directory(folder_.path("shapes"));
  refuse(folder_.path("shapes"), 3, "the folder is empty");
}
TEST_F(BadInput, NoGisFile) {
  refuse(folder_.file("a.gpkg", "hello"), 3, "is no GIS file");
}
TEST_F(BadInput, BinaryGarbage) {
  refuse(folder_.file("a.shp", std::string(300, '\xff')), 3, "is no shapefile");
}
TEST_F(BadInput, RemoteSource) {
  refuse("https://example.org/a.geojson", 2, "remote and virtual sources are refused");
  refuse("/vsicurl/https://example.org/a.geojson", 2, "remote and virtual sources are refused");
}

TEST_F(BadInput, ShapefileWithoutPrj) {
  const auto shp = shapefile();
  fs::remove(folder_.path("walls.prj"));
  refuse(shp, 3, "--source-crs");
  refuse(shp, 3, "--local");
  EXPECT_EQ(
      run({"convert", shp, "-o", folder_.path("map.txt"), "--source-crs", "EPSG:25831"}).status, 0);
}

TEST_F(BadInput, ShapefileWithoutDbf) {
  const auto shp = shapefile();
  fs::remove(folder_.path("walls.dbf"));
  refuse(shp, 3, "its .dbf file is missing, and with it the heights");
  const auto bare = run({"convert", shp, "--skip-broken", "-o", folder_.path("map.txt"), "--report",
                         folder_.path("r.json")});
  EXPECT_EQ(bare.status, 1) << bare.err;
  EXPECT_NE(bare.err.find("walls.shp: its .dbf file is missing: it is read as shapes without"),
            std::string::npos)
      << bare.err;
  EXPECT_NE(content_of(folder_.path("r.json")).find("C231"), std::string::npos);
}

TEST_F(BadInput, MifWithoutMid) {
  const auto mif =
      folder_.file("walls.mif",
                   "Version 300\nCharset \"Neutral\"\nDelimiter \",\"\n"
                   "CoordSys Earth Projection 8, 115, \"m\", 3, 0, 0.9996, 500000, 0\n"
                   "Columns 1\n  height Float\nData\n\nLine 430000 4580000 430010 4580001\n");
  folder_.file("walls.mid", "2\n");
  EXPECT_EQ(run({"convert", mif, "-o", folder_.path("sound.txt")}).status, 0);
  fs::remove(folder_.path("walls.mid"));
  refuse(mif, 3, "its .mid file is missing, and with it the heights");
  EXPECT_EQ(run({"convert", mif, "--skip-broken", "-o", folder_.path("map.txt")}).status, 1);
}

// GDAL reads what is left as a table that never had shapes.
TEST_F(BadInput, TabWithoutItsParts) {
  RegisterOGRTAB();
  const auto tab = folder_.path("walls.tab");
  auto* maker = GetGDALDriverManager()->GetDriverByName("MapInfo File");
  ASSERT_NE(maker, nullptr);
  GDALDatasetUniquePtr table(maker->Create(tab.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  ASSERT_NE(table, nullptr);
  const std::string wall = "LINESTRING(430000 4580000,430010 4580001)";
  test::write_layer(*table, {"walls", "EPSG:25831", {{wall, {{"height", "2"}}}}, wkbLineString});
  table.reset();
  EXPECT_EQ(run({"convert", tab, "-o", folder_.path("sound.txt")}).status, 0);
  for (const std::string part : {"walls.id", "walls.dat", "walls.map"}) {
    fs::remove(folder_.path(part));
    refuse(tab, 3, "walls.tab: cannot be read: " + part + " is missing, which holds its ");
  }
}

// Counted in the header, passed over by GDAL.
TEST_F(BadInput, ShapefileWithADeletedRow) {
  const auto shp = shapefile();
  std::string dbf = content_of(folder_.path("walls.dbf"));
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(dbf[at]); };
  dbf[byte(8) + 256U * byte(9)] = '*';
  folder_.file("walls.dbf", dbf);
  refuse(shp, 3, "pack the file, as ogrinfo -sql \"REPACK walls\" does");
  const auto rest = run({"convert", shp, "--skip-broken", "-o", folder_.path("map.txt")});
  EXPECT_EQ(rest.status, 1) << rest.err;
}

TEST_F(BadInput, LossesOfOneKindAreOneLine) {
  const auto shp = shapefile();
  fs::remove(folder_.path("walls.dbf"));
  const auto bare = run({"convert", shp, "--skip-broken", "-o", folder_.path("map.txt")});
  EXPECT_EQ(bare.status, 1);
  const auto told = bare.err.find("layer walls, feature 0 and 1 more: the .dbf file");
  EXPECT_NE(told, std::string::npos) << bare.err;
  EXPECT_EQ(bare.err.find("C231]", bare.err.find("C231]") + 1), std::string::npos) << bare.err;
}

TEST_F(BadInput, LossesThatDifferAreTwentyLinesAndACount) {
  std::string rows = "WKT\n";
  for (int i = 0; i < 23; ++i) rows += "\"POLYGON((0 0," + std::to_string(i) + " 0\"\n";
  rows += "\"POLYGON((0 0,0 0\"\n";  // as the first
  const auto cut =
      run({"convert", folder_.file("site.csv", rows), "--local", "-o", folder_.path("map.txt")});
  EXPECT_EQ(cut.status, 3);
  EXPECT_NE(cut.err.find("feature 1 and 1 more: "), std::string::npos) << cut.err;
  EXPECT_NE(cut.err.find("… and 3 more; --report lists them all"), std::string::npos) << cut.err;
}

// Two bytes of each character of a text in ASCII, with its byte order mark or without.
std::string utf16(const std::string& text, bool has_mark, bool little_endian = true) {
  std::string wide;
  if (has_mark) wide = little_endian ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : text) wide += little_endian ? std::string{c, '\0'} : std::string{'\0', c};
  return wide;
}

TEST_F(BadInput, TextInUtf16IsCalledThat) {
  const std::string table = "id,WKT\n1,\"POLYGON((0 0,4 0,4 4,0 4,0 0))\"\n";
  const std::string advice = "save it as UTF-8 (iconv -f ";
  refuse(folder_.file("a.csv", utf16(table, true)), 3, "its text is UTF-16: " + advice + "UTF-16 ");
  refuse(folder_.file("a.csv", utf16(table, true, false)), 3, "its text is UTF-16: ");
  refuse(folder_.file("a.csv", utf16(table, false)), 3, advice + "UTF-16LE -t UTF-8)");
  refuse(folder_.file("a.csv", utf16(table, false, false)), 3, advice + "UTF-16BE -t UTF-8)");
  const std::string drawing = R"({"type":"FeatureCollection","features":[]})";
  refuse(folder_.file("a.geojson", utf16(drawing, true)), 3, "its text is UTF-16: ");
  refuse(folder_.file("a.dxf", utf16("  0\r\nSECTION\r\n  2\r\nHEADER\r\n", true)), 3,
         "its text is UTF-16: ");
  const auto segments = folder_.file("lines.csv", utf16("ax,ay,bx,by\n0,0,4,0\n", true));
  const auto imported = run({"import", segments, "-o", folder_.path("map.txt")});
  EXPECT_EQ(imported.status, 3);
  EXPECT_NE(imported.err.find("lines.csv: the file is UTF-16; save it as UTF-8"), std::string::npos)
      << imported.err;
}

// Who says all in rules loses nothing.
TEST_F(BadInput, ShapefileWithoutDbfAndRulesWithoutFields) {
  const auto shp = shapefile();
  fs::remove(folder_.path("walls.dbf"));
  const auto rules = folder_.file("plain.yaml",
                                  "mapwright_rules: 1\nrules:\n  - name: walls\n    kind: wall\n"
                                  "    height: 2.5\n    semantic: \"wall,{layer}\"\n");
  const auto plain = run({"convert", shp, "--rules", rules, "-o", folder_.path("map.txt")});
  EXPECT_EQ(plain.status, 0) << plain.err;
  const auto fields = folder_.file(
      "fields.yaml",
      "mapwright_rules: 1\nrules:\n  - name: walls\n    kind: wall\n    height: [height, 2.5]\n");
  EXPECT_EQ(run({"convert", shp, "--rules", fields, "-o", folder_.path("other.txt")}).status, 3);
}

TEST_F(BadInput, ShapefileWithoutShx) {
  const auto shp = shapefile();
  const std::string map = folder_.path("map.txt"), whole = folder_.path("whole.txt");
  ASSERT_EQ(run({"convert", shp, "-o", whole}).status, 0);
  fs::remove(folder_.path("walls.shx"));
  const auto made = run({"convert", shp, "-o", map, "--report", folder_.path("r.json")});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("walls.shp: its .shx file is missing: a new index was made"),
            std::string::npos)
      << made.err;
  EXPECT_NE(content_of(folder_.path("r.json")).find("a new index was made"), std::string::npos);
  EXPECT_EQ(content_of(map), content_of(whole));
  EXPECT_FALSE(fs::exists(folder_.path("walls.shx")));
}

TEST_F(BadInput, FolderWithAShapefileWithoutShx) {
  shapefile();
  fs::create_directory(folder_.path("site"));
  for (const char* part : {"shp", "dbf", "prj"}) {
    fs::copy(folder_.path(std::string("walls.") + part),
             folder_.path(std::string("site/walls.") + part));
  }
  fs::create_symlink("nowhere", folder_.path("site/zzz.shx"));
  const auto made = run({"convert", folder_.path("site"), "-o", folder_.path("map.txt")});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("site/walls.shp: its .shx file is missing"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_.path("site/walls.shx")));
}

// A record that says that it is longer than the file hides those behind it.
TEST_F(BadInput, ShapefileWithoutShxAndDamagedRecords) {
  const auto shp = shapefile();
  fs::remove(folder_.path("walls.shx"));
  std::fstream file(shp, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(104);  // the first record's length
  file.write("\x00\x10\x00\x00", 4);
  file.close();
  refuse(shp, 3, "walls.shp: its .shx file is missing, and it cannot be made anew");
}

TEST_F(BadInput, DamagedIndexIsSaidToBeDispensable) {
  const auto shp = shapefile();
  fs::resize_file(folder_.path("walls.shx"), 104);
  refuse(shp, 3, "take this index away");
  fs::remove(folder_.path("walls.shx"));
  EXPECT_EQ(run({"convert", shp, "-o", folder_.path("map.txt")}).status, 0);
}

TEST_F(BadInput, TruncatedShapefile) {
  const auto shp = shapefile();
  fs::resize_file(shp, fs::file_size(shp) - 40);
  refuse(shp, 3, "is cut short");
}

TEST_F(BadInput, TruncatedDbf) {
  const auto shp = shapefile();
  fs::resize_file(folder_.path("walls.dbf"), fs::file_size(folder_.path("walls.dbf")) - 20);
  refuse(shp, 3, "walls.dbf: is cut short");
}

TEST_F(BadInput, TruncatedGeoJson) {
  refuse(folder_.file("a.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature")"),
         3, "a.geojson: cannot be read: ");
}

TEST_F(BadInput, GeoPackageWithoutCrs) {
  test::write_gis(folder_.path("a.gpkg"), "GPKG",
                  {{"walls", "", {{"LINESTRING(0 0,4 0)", {}}}, wkbLineString}});
  refuse(folder_.path("a.gpkg"), 3, "states no coordinate reference system");
}

TEST_F(BadInput, LayerOfPoints) {
  refuse(geojson(R"({"type":"Point","coordinates":[2.1,41.4]})"), 1,
         "nothing in the sources becomes an obstacle");
}

TEST_F(BadInput, LatitudeBeyondThePole) {
  refuse(geojson(R"({"type":"LineString","coordinates":[[41.4,120.1],[41.5,120.2]]})"), 3,
         "--swap-axes");
  refuse(geojson(R"({"type":"LineString","coordinates":[[430000,4580000],[430001,4580000]]})"), 3,
         "are no longitudes and latitudes");
}

// Rectangles turned by 20 degrees, with latitude first.
TEST_F(BadInput, ExchangedAxesAreFoundByTheirAngles) {
  std::string features;
  for (int i = 0; i < 30; ++i) {
    std::string ring;
    for (const auto& [x, y] :
         std::vector<std::pair<double, double>>{{0, 0}, {20, 0}, {20, 10}, {0, 10}, {0, 0}}) {
      const double e = 40.0 * i + 0.9397 * x - 0.3420 * y;
      const double n = 0.3420 * x + 0.9397 * y;
      ring += (ring.empty() ? "[" : ",[") + std::to_string(41.38 + n / 111070.0) + "," +
              std::to_string(2.11 + e / 83600.0) + "]";
    }
    features +=
        (i == 0 ? "" : ",") +
        (R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" +
         ring + "]]}}");
  }
  const auto path = folder_.file("swapped.geojson",
                                 R"({"type":"FeatureCollection","features":[)" + features + "]}");
  refuse(path, 3, "longitude and latitude look exchanged");
  EXPECT_EQ(run({"convert", path, "-o", folder_.path("map.txt"), "--swap-axes"}).status, 0);
}

TEST_F(BadInput, NotANumber) {
  test::write_gis(folder_.path("a.gpkg"), "GPKG",
                  {{"walls",
                    "EPSG:25831",
                    {{"LINESTRING(430000 4580000,430010 4580001)", {}, 1},
                     {"LINESTRING(430000 4580010,430010 4580011)", {}}},
                    wkbLineString}});
  refuse(folder_.path("a.gpkg"), 3, "[C205]");
  const auto skipped =
      run({"convert", folder_.path("a.gpkg"), "-o", folder_.path("map.txt"), "--skip-broken"});
  EXPECT_EQ(skipped.status, 1) << skipped.err;
  EXPECT_TRUE(fs::exists(folder_.path("map.txt")));
}

TEST_F(BadInput, FarFromTheOrigin) {
  refuse(shapefile(), 3, "[C220]", {"--origin", "-41.4,2.1"});
}

TEST_F(BadInput, OutputFolderMissing) {
  const auto shp = shapefile();
  const auto result = run({"convert", shp, "-o", folder_.path("no/such/map.txt")});
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_NE(result.err.find("there is no folder"), std::string::npos);
}

TEST_F(BadInput, OutputFolderReadOnly) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const auto shp = shapefile();
  fs::create_directory(folder_.path("closed"));
  ::chmod(folder_.path("closed").c_str(), 0555);
  EXPECT_EQ(run({"convert", shp, "-o", folder_.path("closed/map.txt")}).status, 4);
}

TEST_F(BadInput, SidecarOfAnotherMapUnderTheName) {
  folder_.file("map.georef.json", "{}");
  test::write_gis(folder_.path("a.gpkg"), "GPKG",
                  {{"walls", "", {{"LINESTRING(0 0,4 0)", {}}}, wkbLineString}});
  const auto result =
      run({"convert", folder_.path("a.gpkg"), "--local", "-o", folder_.path("map.txt")});
  EXPECT_EQ(result.status, 4) << result.err;
  EXPECT_FALSE(fs::exists(folder_.path("map.txt")));
}

TEST_F(BadInput, OptionsThatMakeNoSense) {
  const auto shp = shapefile();
  refuse(shp, 2, "no source has a layer 'roofs'", {"--layer", "roofs"});
  refuse(shp, 2, "exclude each other", {"--local", "--source-crs", "EPSG:25831"});
  refuse(shp, 2, "is no coordinate reference system", {"--source-crs", "EPSG:1"});
  refuse(shp, 2, "is beyond ±90", {"--origin", "425800,4582230"});
  refuse(shp, 2, "does not fit layer", {"--where", "no_such_field = 1"});
  refuse(shp, 2, "GDAL has no driver", {"--allow-driver", "Nonsense"});
  refuse(shp, 3, "cannot be read", {"--rules", folder_.path("none.yaml")});
  refuse(shp, 3, "r.yaml:1:1: error:", {"--rules", folder_.file("r.yaml", "- kind\n")});
  EXPECT_EQ(run({"convert", shp}).status, 2);
}

std::string kml(const std::string& coordinates) {
  return "<?xml version=\"1.0\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n"
         "<Placemark><name>abc</name><Polygon><outerBoundaryIs><LinearRing><coordinates>\n" +
         coordinates + "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>" +
         "</Document></kml>\n";
}

// GDAL takes words for 0: the map of a yard became one of hundreds of kilometres.
TEST_F(BadInput, WordsAmongCoordinatesOfXml) {
  const std::string sound = "2.1,41.3 +2.1001,41.3,0 2.10e0,41.3001 2.1,41.3";
  const auto read =
      run({"convert", folder_.file("a.kml", kml(sound)), "-o", folder_.path("a.txt")});
  EXPECT_EQ(read.status, 0) << read.err;
  refuse(folder_.file("b.kml", kml("2.1,41.3\n2.1001,abc 2.1,41.3001 2.1,41.3")), 3,
         "b.kml: cannot be read: line 5: \"abc\" stands among coordinates and is no number");
  const std::string gml =
      "<r:c xmlns:r=\"urn:r\" xmlns:gml=\"http://www.opengis.net/gml/3.2\">\n<gml:featureMember>"
      "<r:wall gml:id=\"w\"><r:g><gml:LineString srsName=\"EPSG:25831\"><gml:posList>430000 "
      "4580000 "
      "430010 45800o0</gml:posList></gml:LineString></r:g></r:wall></gml:featureMember></r:c>";
  refuse(folder_.file("a.gml", gml), 3, "line 2: \"45800o0\" stands among coordinates");
}

}  // namespace
}  // namespace mapwright
