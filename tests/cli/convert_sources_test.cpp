// `mapwright convert` on sources that say things in ways of their own.
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::content;
using test::TemporaryFolder;

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

double area_m2(const Obstacle& obstacle) {
  double doubled = 0.0;
  for (const auto& s : obstacle.segments) doubled += s.a.x * s.b.y - s.a.y * s.b.x;
  return 0.5 * doubled;
}

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

TEST_F(Sources, StoreysOnTopOfEachOtherAreTold) {
  const auto said = [&](const std::string& p, const std::string& q, double east) {
    const auto square = [](double x) {
      const auto a = std::to_string(x), b = std::to_string(x + 4);
      return "POLYGON((" + a + " 0," + b + " 0," + b + " 4," + a + " 4," + a + " 0))";
    };
    const auto path = folder_.path("site.gpkg");
    std::filesystem::remove(path);
    test::write_gis(
        path, "GPKG",
        {{p, "", {{square(0), {}}}, wkbPolygon}, {q, "", {{square(east), {}}}, wkbPolygon}});
    const auto made = test::run({"convert", path, "--local", "-o", folder_.path("map.txt")});
    EXPECT_LE(made.status, 1) << made.err;
    return made.err.find("look like storeys") != std::string::npos;
  };
  EXPECT_TRUE(said("site_1_walls", "site_B1_walls", 1));
  EXPECT_TRUE(said("EG", "OG2", 1));
  EXPECT_FALSE(said("site_1_walls", "site_2_walls", 5)) << "tiles beside each other";
  EXPECT_FALSE(said("site_1_walls", "site_2_doors", 1));
  EXPECT_FALSE(said("walls_2019", "walls_2020", 1));
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

TEST_F(Sources, GeometriesBesideTheFirstAreTold) {
  const auto two =
      convert("a.csv", std::string("WKT,geom\n\"") + kSquare + "\",\"" + kSquare + "\"\n");
  EXPECT_EQ(two.status, 0) << two.err;
  EXPECT_NE(two.err.find("several geometries: the first is read, and not geom"), std::string::npos)
      << two.err;
}

TEST_F(Sources, ATableThatEndsWithinARowIsRefused) {
  const std::string sound = std::string("WKT,name,height\n\"") + kSquare + "\",hall,3\n";
  const std::string row = std::string("\"") + kSquare + "\",";
  for (const std::string cut : {"tow", "\"tower, no", "\"tower\""}) {
    const auto refused = convert("a.csv", sound + row + cut);
    EXPECT_EQ(refused.status, 3) << cut;
    EXPECT_NE(refused.err.find("feature 2: the file ends within its row [C229]"), std::string::npos)
        << refused.err;
  }
  EXPECT_EQ(convert("a.csv", sound + row + "\"to\"\"wer\",3").status, 0);
  EXPECT_EQ(convert("a.csv", sound + row + "tower\n").status, 0);  // nobody says that it was cut
}

// "3,5" without quotes is 3, and a 5 that no column is for.
TEST_F(Sources, RowsWithMoreValuesThanColumnsAreTold) {
  const std::string shape = std::string("\"") + kSquare + "\",";
  const auto made =
      convert("a.csv", "WKT,height\n" + shape + "3\n" + shape + "3,5\n\n" + shape + "3,\n");
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(feature(0)["outcome"], "written");
  EXPECT_EQ(feature(1)["outcome"], "changed");
  EXPECT_NE(feature(1)["reasons"][0]["message"].get<std::string>().find("more values than"),
            std::string::npos);
  EXPECT_EQ(feature(2)["outcome"], "written");
  EXPECT_EQ(convert("a.csv", std::string("WKT\n") + kSquare + "\n").status, 0);
  EXPECT_EQ(feature(0)["outcome"], "written");
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

// GDAL makes a feature without geometry of each, or leaves the part out that is none.
TEST_F(Sources, ShapesThatAreNoneByTheRulesOfGeoJsonAreLost) {
  const std::string ring = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
  const auto polygon = [](const std::string& rings) {
    return R"({"type":"Polygon","coordinates":)" + rings + "}";
  };
  const auto of_type = [](const std::string& type, const std::string& coordinates) {
    return R"({"type":")" + type + R"(","coordinates":)" + coordinates + "}";
  };
  const auto converted = [&](const std::string& shape) {
    const auto feature = [](const std::string& geometry) {
      return R"({"type":"Feature","properties":{"name":"Eixample – façana"},"geometry":)" +
             geometry + "}";
    };
    return convert("a.geojson", R"({"type":"FeatureCollection","features":[)" +
                                    feature(polygon("[" + ring + "]")) + "," + feature(shape) +
                                    "]}");
  };
  for (const std::string& shape : {
           polygon("[[0,0],[4,0]]"),
           polygon("[" + ring + ",null]"),
           polygon("[" + ring + ",[1,1]]"),
           polygon("[[[0,0],[4,0],[],[0,4],[0,0]]]"),
           polygon("[[[0,0],[4],[4,4],[0,0]]]"),
           of_type("Polygone", "[" + ring + "]"),
           of_type("MultiPolygon", "[" + ring + "]"),
           of_type("MultiPolygon", "[[" + ring + "],null]"),
           of_type("LineString", "[[0,0],null,[4,0]]"),
           of_type("MultiLineString", "[[[0,0],[4,0]],[4,0]]"),
           std::string(R"({"rings":[]})"),
           std::string(R"("POLYGON EMPTY")"),
           R"({"type":"GeometryCollection","geometries":[)" + polygon("[" + ring + "]") + ",null]}",
           R"({"type":"GeometryCollection","geometries":[)" + polygon("[" + ring + "]") +
               R"(,{"type":"Pole","coordinates":[1,1]}]})",
       }) {
    const auto refused = converted(shape);
    EXPECT_EQ(refused.status, 3) << shape << refused.err;
    EXPECT_EQ(feature(1)["reasons"][0]["code"], "C229") << shape;
    EXPECT_EQ(feature(0)["outcome"], "written");
  }
  for (const std::string& shape : {
           std::string("null"),
           polygon("[]"),
           polygon("[[]]"),
           of_type("polygon", "[" + ring + "]"),
           of_type("MultiPolygon", "[[" + ring + ",[[1,1],[2,1],[2,2],[1,1]]]]"),
           R"({"type":"GeometryCollection","geometries":[)" + polygon("[" + ring + "]") + "]}",
           of_type("Point", "[1,2,3]"),
       }) {
    EXPECT_EQ(converted(shape).status, 0) << shape;
  }
}

TEST_F(Sources, ADocumentThatIsOneBrokenShapeIsLost) {
  const auto refused = convert("a.geojson", R"({"type":"Polygon","coordinates":[[0,0],[4,0]]})");
  EXPECT_EQ(refused.status, 3) << refused.err;
  EXPECT_EQ(convert("a.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]]]})")
                .status,
            0);
}

// A house with a gabled roof, its faces wound as they like, and a surface of triangles.
TEST_F(Sources, SurfacesInSpaceBecomeTheGroundTheyCover) {
  const std::string house =
      "POLYHEDRALSURFACE Z(((0 0 0,8 0 0,8 6 0,0 6 0,0 0 0)),((0 0 0,8 0 0,8 0 3,0 0 3,0 0 0)),"
      "((8 0 0,8 6 0,8 6 3,8 3 5,8 0 3,8 0 0)),((0 6 0,8 6 0,8 6 3,0 6 3,0 6 0)),"
      "((0 0 0,0 6 0,0 6 3,0 3 5,0 0 3,0 0 0)),((0 0 3,8 0 3,8 3 5,0 3 5,0 0 3)),"
      "((0 6 3,8 6 3,8 3 5,0 3 5,0 6 3)))";
  const std::string terrace = "TIN(((20 0,24 0,24 4,20 0)),((20 0,24 4,20 4,20 0)))";
  ASSERT_EQ(convert("a.csv", "id,WKT\n1,\"" + house + "\"\n2,\"" + terrace + "\"\n").status, 0);
  ASSERT_EQ(map().obstacles.size(), 2U);
  EXPECT_NEAR(area_m2(map().obstacles[0]), 48.0, 1e-9);
  EXPECT_NEAR(area_m2(map().obstacles[1]), 16.0, 1e-9);
  EXPECT_EQ(feature(0)["outcome"], "written");
}

// Neither ground nor air is under these faces.
TEST_F(Sources, SurfacesWithoutAFaceAreLost) {
  for (const std::string faces : {"Z(((0 0 0,4 0 1,8 0 2,0 0 0)))", "(((0 0,8 1,8 1,0 0)))"}) {
    const auto refused =
        convert("a.csv", "id,WKT\n1,\"POLYHEDRALSURFACE " + faces + "\"\n2,\"" + kSquare + "\"\n");
    EXPECT_EQ(refused.status, 3) << refused.err;
    EXPECT_EQ(feature(0)["reasons"][0]["code"], "C229") << faces;
  }
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

// GDAL notes beside a gzipped file how long it is when unpacked.
TEST_F(Sources, NothingIsLeftBesideGzippedFiles) {
  const auto pack = [&](const std::string& name, const std::string& bytes) {
    auto* out = VSIFOpenL(("/vsigzip/" + folder_.path(name)).c_str(), "wb");
    ASSERT_NE(out, nullptr);
    VSIFWriteL(bytes.data(), 1, bytes.size(), out);
    VSIFCloseL(out);
  };
  pack("site.csv.gz", std::string("id,WKT\n1,\"") + kSquare + "\"\n");
  pack("site.osm.gz",
       R"(<osm version="0.6"><node id="1" lat="41" lon="2"/><node id="2" lat="41" lon="2.0001"/>)"
       R"(<way id="1"><nd ref="1"/><nd ref="2"/><tag k="barrier" v="wall"/></way></osm>)");
  for (const std::string name : {"site.csv.gz", "site.osm.gz"}) {
    std::vector<std::string> arguments{"convert", folder_.path(name), "-o",
                                       folder_.path("map.txt")};
    if (name == "site.csv.gz") arguments.push_back("--local");
    std::filesystem::remove(folder_.path("map.georef.json"));
    const auto result = test::run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path(name + ".properties"))) << name;
  }
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
TEST_F(Sources, FieldsThatRulesAskForAndNoLayerHasAreTold) {
  const auto rules = folder_.file("rules.yaml", R"(mapwright_rules: 1
rules:
  - name: halls
    layer: hal*
    kind: solid
    where: { storey: absent }
    height: [hieght, top, 2.5]
    base_height: [base, { field: height, default: 0 }]
    semantic: "hall,{nmae},{Height}"
  - name: roofs
    layer: roofs
    kind: solid
    height: eaves
)");
  const std::string table = std::string("WKT,height\n\"") + kSquare + "\",0.5\n";
  const auto said = convert("halls.csv", table, {"--rules", rules}).err;
  EXPECT_NE(
      said.find("rules.yaml:3: rule 'halls' takes its height from 'hieght', 'top', which no "),
      std::string::npos)
      << said;
  EXPECT_NE(said.find("takes its semantic from 'nmae', which no layer"), std::string::npos) << said;
  for (const std::string sound : {"base", "storey", "eaves", "Height'"}) {
    EXPECT_EQ(said.find(sound), std::string::npos) << said;
  }
  const auto explained = convert("halls.csv", table, {"--rules", rules, "--explain-rules"});
  EXPECT_NE(explained.out.find("from 'hieght', 'top'"), std::string::npos) << explained.out;
}

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
