// `mapwright convert` on KML and GML documents: what GDAL passes over is told.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::content;
using test::TemporaryFolder;

class Documents : public testing::Test {
 protected:
  test::ProgramRun convert(const std::string& name, const std::string& text,
                           std::vector<std::string> more = {}) {
    std::filesystem::remove(folder_.path("map.txt"));
    std::vector<std::string> arguments{"convert",  folder_.file(name, text),
                                       "-o",       folder_.path("map.txt"),
                                       "--report", folder_.path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }
  json ledger() const { return json::parse(content(folder_.path("r.json"))); }
  std::size_t obstacles() const {
    return read_map(content(folder_.path("map.txt"))).map.obstacles.size();
  }

  TemporaryFolder folder_;
};

std::string placemark(const std::string& name, const std::string& shape) {
  return "<Placemark><name>" + name + "</name>" + shape + "</Placemark>";
}

std::string kml(const std::string& content) {
  return "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
         "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document><Folder><name>site</name>" +
         placemark("wall",
                   "<LineString><coordinates>2.1,41.3 2.1001,41.3</coordinates>"
                   "</LineString>") +
         content + "</Folder></Document></kml>";
}

constexpr const char* kModel =
    "<Model><Location><longitude>2.1</longitude><latitude>41.3</latitude></Location>"
    "<Link><href>tower.dae</href></Link></Model>";
constexpr const char* kLink =
    "<NetworkLink><name>more</name><Link><href>more.kml</href></Link></NetworkLink>";
constexpr const char* kGroundOverlay =
    "<GroundOverlay><name>photo</name><Icon><href>a.png</href></Icon><LatLonBox><north>41.31"
    "</north><south>41.29</south><east>2.11</east><west>2.09</west></LatLonBox></GroundOverlay>";

TEST_F(Documents, LinksAndModelsOfKmlAreLost) {
  const auto lost = [&](const std::string& element, const std::string& why) {
    const auto refused = convert("a.kml", kml(element));
    EXPECT_EQ(refused.status, 3) << refused.err;
    EXPECT_NE(refused.err.find(why), std::string::npos) << refused.err;
    EXPECT_EQ(ledger()["totals"],
              json::parse(R"({"features":2,"written":1,"changed":0,"dropped":1})"));
    EXPECT_EQ(convert("a.kml", kml(element), {"--skip-broken"}).status, 1);
    EXPECT_EQ(obstacles(), 1U);
  };
  lost(kLink, "layer site, feature 2: what its NetworkLink leads to (more.kml) is not fetched");
  lost(placemark("tower", kModel), "layer site, feature 2: its 3D model is another file");
}

TEST_F(Documents, LinksOfFoldersWithoutFeaturesAreLostToo) {
  const std::string empty = "<Folder><name>elsewhere</name>" + std::string(kLink) + "</Folder>";
  EXPECT_EQ(convert("a.kml", kml(empty)).status, 3);
}

// GDAL makes a polygon of the first kind, which would be a house as large as the picture.
TEST_F(Documents, PicturesOfKmlAreNoObstacles) {
  const auto made =
      convert("a.kml", kml(std::string(kGroundOverlay) +
                           placemark("gate",
                                     "<LineString><coordinates>2.1,41.301 2.1001,41.301"
                                     "</coordinates></LineString>") +
                           "<ScreenOverlay><name>legend</name></ScreenOverlay>" +
                           "<PhotoOverlay><name>view</name></PhotoOverlay>" +
                           "<PhotoOverlay><name>view</name></PhotoOverlay>"));
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("passed over, for it stands for nothing solid: 2 PhotoOverlay, "
                          "1 ScreenOverlay"),
            std::string::npos)
      << made.err;
  EXPECT_EQ(obstacles(), 2U);
  const auto picture = ledger()["features"][1];
  EXPECT_EQ(picture["outcome"], "dropped");
  EXPECT_EQ(picture["reasons"][0]["message"],
            "no obstacle can stand for a GroundOverlay, which is a picture");
}

TEST_F(Documents, TracksOfKmlAreLines) {
  const std::string track =
      "<gx:Track><when>2010-05-28T02:02:09Z</when><when>2010-05-28T02:02:10Z</when>"
      "<gx:coord>2.1 41.302 0</gx:coord><gx:coord>2.1001 41.302 0</gx:coord></gx:Track>";
  ASSERT_EQ(convert("a.kml", kml(placemark("walk", track))).status, 0);
  EXPECT_EQ(obstacles(), 2U);
}

std::string line(const std::string& property, const std::string& crs, int north) {
  const auto y = std::to_string(4580000 + north);
  return "<r:" + property + "><gml:LineString srsName=\"" + crs + "\"><gml:posList>430000 " + y +
         " 430010 " + y + "</gml:posList></gml:LineString></r:" + property + ">";
}

std::string gml(const std::vector<std::string>& walls) {
  std::string text = "<r:c xmlns:r=\"urn:r\" xmlns:gml=\"http://www.opengis.net/gml/3.2\">";
  for (const auto& wall : walls) {
    text +=
        "<gml:featureMember><r:wall><gml:boundedBy><gml:Envelope srsName=\"EPSG:25831\"/>"
        "</gml:boundedBy>" +
        wall + "</r:wall></gml:featureMember>";
  }
  return text + "</r:c>";
}

TEST_F(Documents, GeometriesOfGmlBesideTheOneReadAreLost) {
  const auto one = line("axis", "EPSG:25831", 0);
  EXPECT_EQ(convert("a.gml", gml({one, one})).status, 0);
  const auto two = gml({one, line("footprint", "EPSG:25831", 20) + line("axis", "EPSG:25831", 30)});
  const auto refused = convert("a.gml", two);
  EXPECT_EQ(refused.status, 3) << refused.err;
  EXPECT_NE(refused.err.find("it has 2 geometries (footprint, axis), of which only the last"),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(ledger()["features"][0]["outcome"], "written");
  EXPECT_EQ(ledger()["features"][1]["reasons"][0]["code"], "C229");
  EXPECT_EQ(ledger()["features"][1]["outcome"], "changed");
  EXPECT_EQ(convert("a.gml", two, {"--skip-broken"}).status, 1);
  EXPECT_NE(content(folder_.path("map.txt")).find("obstacle;\n2;"), std::string::npos)
      << "the last geometry is in the map";
}

TEST_F(Documents, SeveralReferenceSystemsOfGmlAreNamed) {
  const auto refused =
      convert("a.gml", gml({line("axis", "EPSG:25831", 0), line("axis", "EPSG:25830", 0)}));
  EXPECT_EQ(refused.status, 3) << refused.err;
  EXPECT_NE(refused.err.find("states several coordinate reference systems (EPSG:25830, "
                             "EPSG:25831), and a layer is read in one"),
            std::string::npos)
      << refused.err;
}

}  // namespace
}  // namespace mapwright
