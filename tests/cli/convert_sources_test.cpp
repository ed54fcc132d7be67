// `mapwright convert` on sources that say things in ways of their own.
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Sources : public testing::Test {
 protected:
  test::ProgramRun convert(const std::string& name, const std::string& text,
                           std::vector<std::string> more = {}) {
    std::filesystem::remove(folder_.path("map.txt"));
    std::vector<std::string> arguments{
        "convert",  folder_.file(name, text), "--local", "-o", folder_.path("map.txt"),
        "--report", folder_.path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }
  Map map() const { return read_map(content(folder_.path("map.txt"))).map; }
  json feature(std::size_t i) const {
    return json::parse(content(folder_.path("r.json")))["features"][i];
  }

  TemporaryFolder folder_;
};

constexpr const char* kSquare = "POLYGON((0 0,4 0,4 4,0 4,0 0))";

TEST_F(Sources, TablesNameTheirColumnOfShapesInManyWays) {
  const std::string row = std::string("1,\"") + kSquare + "\"\n";
  for (const std::string column : {"WKT", "wkt", "geom", "geometry", "the_geom", "wkt_geom"}) {
    ASSERT_EQ(convert("a.csv", "id," + column + "\n" + row).status, 0) << column;
    EXPECT_EQ(map().obstacles.size(), 1U) << column;
  }
  ASSERT_EQ(convert("a.csv", std::string("id,geom\n1,\"SRID=25831;") + kSquare + "\"\n").status, 0);
  EXPECT_EQ(map().obstacles.size(), 1U);
  const auto none = convert("a.csv", "id,town\n1,Dresden\n");
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("no column of it holds shapes"), std::string::npos) << none.err;
}

TEST_F(Sources, ViewsBesideTheirTablesAreTold) {
  const auto path = folder_.path("site.gpkg");
  test::write_gis(path, "GPKG",
                  {{"walls",
                    "EPSG:25831",
                    {{"LINESTRING(430000 4580000,430010 4580001)", {{"height", "2"}}},
                     {"LINESTRING(430000 4580010,430010 4580011)", {{"height", "3"}}}},
                    wkbLineString}});
  {
    const GDALDatasetUniquePtr site(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    for (const char* sql :
         {"CREATE VIEW tall AS SELECT * FROM walls WHERE height > 2",
          "INSERT INTO gpkg_contents(table_name, identifier, data_type, srs_id) "
          "VALUES('tall', 'tall', 'features', 25831)",
          "INSERT INTO gpkg_geometry_columns VALUES('tall', 'geom', 'LINESTRING', 25831, 0, 0)"}) {
      site->ReleaseResultSet(site->ExecuteSQL(sql, nullptr, nullptr));
    }
  }
  const auto map = folder_.path("map.txt");
  const auto both = test::run({"convert", path, "-o", map});
  EXPECT_NE(both.err.find("layer tall is a view"), std::string::npos) << both.err;
  const auto one = test::run({"convert", path, "--layer", "tall", "-o", map});
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.err.find("is a view"), std::string::npos) << one.err;
}

// Nothing in such a file separates columns, so that it does not look like a table.
TEST_F(Sources, TablesMayBeASingleColumnOfShapes) {
  const std::string quoted = "\"" + std::string(kSquare) + "\"";
  for (const std::string& text :
       {"WKT\n" + quoted + "\n\"LINESTRING(10 0,12 3)\"\n",
        "\xef\xbb\xbf\"geom\"\r\n" + quoted + "\r\n\"LINESTRING(10 0,12 3)\"\r\n",
        "wkt_geom\n" + std::string(kSquare) + "\nLINESTRING(10 0,12 3)"}) {
    const auto done = convert("a.csv", text);
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(map().obstacles.size(), 2U) << text;
  }
  EXPECT_EQ(convert("a.csv", "WKT\n\"POLYGON((0 0,4 0,4\n").status, 3);
  EXPECT_EQ(convert("a.csv", "town\nDresden\n").status, 3);
}

TEST_F(Sources, ATableThatWasCutShortIsRefused) {
  const std::string whole = std::string("id,WKT\n1,\"") + kSquare + "\"\n2,\"" + kSquare + "\"\n";
  const auto cut = convert("a.csv", whole.substr(0, whole.size() - 12));
  EXPECT_EQ(cut.status, 3);
  EXPECT_NE(cut.err.find("its WKT cannot be read"), std::string::npos) << cut.err;
  EXPECT_NE(cut.err.find("C229"), std::string::npos);
  ASSERT_EQ(convert("a.csv", whole.substr(0, whole.size() - 12), {"--skip-broken"}).status, 1);
  EXPECT_EQ(feature(1)["outcome"], "dropped");
  // A column that merely says what shapes are like is no column of shapes.
  EXPECT_EQ(convert("a.csv", std::string("WKT,geometry\n\"") + kSquare + "\",round\n").status, 0);
}

TEST_F(Sources, CollectionsAreTakenApart) {
  const std::string collection =
      std::string("GEOMETRYCOLLECTION(POINT(9 9),LINESTRING(10 0,12 3),") + kSquare +
      ",GEOMETRYCOLLECTION(LINESTRING(20 0,22 3)))";
  ASSERT_EQ(convert("a.csv", "id,WKT\n1,\"" + collection + "\"\n").status, 0);
  ASSERT_EQ(map().obstacles.size(), 3U);
  EXPECT_EQ(feature(0)["outcome"], "changed");
  EXPECT_EQ(feature(0)["obstacles"].size(), 3U);
  EXPECT_EQ(feature(0)["reasons"][0]["code"], "C208");
  ASSERT_EQ(convert("a.csv", std::string("id,WKT\n1,\"GEOMETRYCOLLECTION(") + kSquare +
                                 ",LINESTRING(10 0,12 3))\"\n")
                .status,
            0);
  EXPECT_EQ(feature(0)["outcome"], "written");
  EXPECT_EQ(convert("a.csv", "id,WKT\n1,\"GEOMETRYCOLLECTION(POINT(1 1))\"\n").status, 1);
  EXPECT_EQ(feature(0)["outcome"], "dropped");
}

std::string drawing(const std::string& layer) {
  return "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1032\n9\n$DWGCODEPAGE\n3\nANSI_"
         "1252\n0\nENDSEC\n0\n"
         "SECTION\n2\nENTITIES\n0\nLINE\n8\n" +
         layer + "\n10\n0\n20\n0\n11\n5\n21\n0\n0\nENDSEC\n0\nEOF\n";
}

TEST_F(Sources, ArchivesOfMacsHoldMoreThanTheFiles) {
  const std::string zip = folder_.path("site.zip");
  const auto pack = [&](const std::string& name, const std::string& bytes) {
    auto* out = VSIFOpenL(("/vsizip/" + zip + "/" + name).c_str(), "wb");
    ASSERT_NE(out, nullptr);
    VSIFWriteL(bytes.data(), 1, bytes.size(), out);
    VSIFCloseL(out);
  };
  pack("site.csv", std::string("id,WKT\n1,\"") + kSquare + "\"\n");
  pack("__MACOSX/._site.csv", std::string("\0\5\26\7\0", 5));
  const auto result = test::run({"convert", zip, "--local", "-o", folder_.path("map.txt")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err.find("MACOSX"), std::string::npos) << result.err;
}

TEST_F(Sources, DrawingsAreReadInTheEncodingTheyAreIn) {
  for (const std::string& bytes : {std::string("Pla\xc3\xa7"
                                               "a"),
                                   std::string("Pla\xe7"
                                               "a")}) {
    ASSERT_EQ(convert("a.dxf", drawing(bytes)).status, 0);
    EXPECT_NE(content(folder_.path("r.json")).find("Plaça"), std::string::npos);
  }
  ASSERT_EQ(convert("a.dxf", drawing("壁")).status, 0);
  EXPECT_NE(content(folder_.path("r.json")).find("壁"), std::string::npos);
}

// Exports that forget the member 'crs' are in degrees by the standard.
TEST_F(Sources, MetresThatAreSaidToBeDegreesAreGuessed) {
  const auto path = folder_.file("utm.geojson", R"({"type":"FeatureCollection","features":[{"type":
    "Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[430000,4582000],
    [430012,4582000],[430012,4582008],[430000,4582008],[430000,4582000]]]}}]})");
  const auto result = test::run({"convert", path, "-o", folder_.path("map.txt")});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("UTM"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("--override-crs EPSG:326ZZ"), std::string::npos) << result.err;
}

TEST_F(Sources, AGmlDocumentThatIsNoXmlIsNotAnEmptyOne) {
  const auto result = convert("a.gml",
                              "<gml:FeatureCollection xmlns:gml=\"http://www.opengis.net/gml\">"
                              "<gml:featureMember><a fid=\"1\"><b></c></a></gml:featureMember>"
                              "</gml:FeatureCollection>");
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("cannot be read"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace mapwright
