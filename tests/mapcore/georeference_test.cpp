#include "mapcore/georeference.hpp"

#include <gtest/gtest.h>

#include <string>

namespace mapwright {
namespace {

Georeference campus() {
  Georeference georeference;
  georeference.origin_latitude_deg = 41.389012345678901;
  georeference.origin_longitude_deg = 2.1134;
  georeference.origin_height_m = 121.5;
  georeference.heading_deg = -20.0;
  georeference.projection = FrameProjection::kEastNorthUp;
  georeference.wkt2 = "PROJCRS[\"local\",BASEGEOGCRS[\"WGS 84\"]]";
  georeference.sources = {{"../gis/campus.gpkg", "obstacles", "EPSG:25831"}, {"b.dxf", "", ""}};
  return georeference;
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

std::string failure_of(const std::string& json) {
  const auto result = parse_georeference(json);
  EXPECT_FALSE(result.has_value());
  return result ? "" : result.error().message;
}

TEST(Georeference, ReadsWhatItWrote) {
  const std::string json = format_georeference(campus());
  const auto read = parse_georeference(json);
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(*read, campus());
  EXPECT_EQ(format_georeference(*read), json);
  EXPECT_EQ(json.find("{\n  \"schema\": \"mapwright.georef/1\""), 0U);
  EXPECT_EQ(json.back(), '\n');
}

TEST(Georeference, MayLackSourcesAndWkt) {
  const auto read = parse_georeference(
      R"({"schema":"mapwright.georef/1","origin":{"latitude":1,"longitude":2,"height":3},
          "heading_deg":4,"projection":"tmerc","made_by":"somebody"})");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->origin_longitude_deg, 2.0);
  EXPECT_TRUE(read->wkt2.empty());
  EXPECT_TRUE(read->sources.empty());
}

TEST(Georeference, SaysWhatIsWrong) {
  const std::string json = format_georeference(campus());
  EXPECT_EQ(failure_of(with(json, "41.3890123456789", "91")),
            "georeference: \"origin.latitude\" is 91, beyond ±90.0");
  EXPECT_EQ(failure_of(with(json, "2.1134", "\"2.1134\"")),
            "georeference: \"origin.longitude\" must be a number, it is \"2.1134\"");
  EXPECT_EQ(failure_of(with(json, "heading_deg", "heading")),
            "georeference: \"heading_deg\" is missing");
  EXPECT_EQ(failure_of(with(json, "\"enu\"", "\"utm\"")),
            "georeference: \"projection\" is \"utm\"; \"tmerc\" and \"enu\" are known");
  EXPECT_EQ(failure_of(with(json, "georef/1", "georef/2")),
            "georeference: \"schema\" is \"mapwright.georef/2\", this program reads "
            "\"mapwright.georef/1\"");
  EXPECT_EQ(failure_of(with(json, "\"EPSG:25831\"", "25831")),
            "georeference: \"sources[0].crs\" must be a string, it is 25831");
  EXPECT_EQ(failure_of(with(json, "\"b.dxf\"", "null")),
            "georeference: \"sources[1].path\" must be a string, it is null");
  EXPECT_EQ(failure_of("[]"), "georeference: the document must be an object");
  EXPECT_EQ(failure_of("{").find("georeference: not JSON: "), 0U);
  EXPECT_EQ(failure_of("").find("georeference: not JSON: "), 0U);
  EXPECT_EQ(failure_of("{\"schema\":\"\xFF\"}").find("georeference: not JSON: "), 0U);
}

TEST(Georeference, NumbersBeyondDoublesAreNoNumbers) {
  EXPECT_FALSE(
      parse_georeference(with(format_georeference(campus()), "121.5", "1e999")).has_value());
}

TEST(Georeference, SidecarStandsBesideTheMap) {
  EXPECT_EQ(sidecar_path("site/campus.txt"), "site/campus.georef.json");
  EXPECT_EQ(sidecar_path("campus"), "campus.georef.json");
  EXPECT_EQ(sidecar_path("a.txt/campus.map"), "a.txt/campus.map.georef.json");
}

}  // namespace
}  // namespace mapwright
