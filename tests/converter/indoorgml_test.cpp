// IndoorGML documents as layers of features.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "converter/indoorgml/indoorgml_reader.hpp"
#include "tests/cli/program_run.hpp"

namespace mapwright::converter {
namespace {

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

struct Room {
  double x1, y1, x2, y2;
};

std::string face(const std::vector<std::array<double, 3>>& corners) {
  std::string text = "<gml:surfaceMember><gml:Polygon><gml:exterior><gml:LinearRing>";
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const auto& c = corners[i % corners.size()];
    text += "<gml:pos>" + number(c[0]) + " " + number(c[1]) + " " + number(c[2]) + "</gml:pos>";
  }
  return text + "</gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember>";
}

// A box, its faces looking outwards.
std::string solid(const Room& r, double low, double high) {
  const auto ring = [&](double z) {
    return std::vector<std::array<double, 3>>{
        {r.x1, r.y1, z}, {r.x2, r.y1, z}, {r.x2, r.y2, z}, {r.x1, r.y2, z}};
  };
  const auto foot = ring(low), top = ring(high);
  std::string faces = face({foot[3], foot[2], foot[1], foot[0]}) + face(top);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    faces += face({foot[i], foot[j], top[j], top[i]});
  }
  return "<cellSpaceGeometry><Geometry3D><gml:Solid><gml:exterior><gml:Shell>" + faces +
         "</gml:Shell></gml:exterior></gml:Solid></Geometry3D></cellSpaceGeometry>";
}

std::string flat(const Room& r) {
  return "<cellSpaceGeometry><Geometry2D><gml:Polygon><gml:exterior><gml:LinearRing><gml:posList>" +
         number(r.x1) + " " + number(r.y1) + " " + number(r.x2) + " " + number(r.y1) + " " +
         number(r.x2) + " " + number(r.y2) + " " + number(r.x1) + " " + number(r.y2) + " " +
         number(r.x1) + " " + number(r.y1) +
         "</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></Geometry2D>"
         "</cellSpaceGeometry>";
}

std::string cell(const std::string& id, const std::string& content,
                 const std::string& type = "CellSpace") {
  return "<cellSpaceMember><" + type + " gml:id='" + id + "'><gml:name>" + id + "</gml:name>" +
         content + "</" + type + "></cellSpaceMember>";
}

std::string boundary(const std::string& id, const std::string& content, const std::string& pos,
                     const std::string& type = "CellSpaceBoundary") {
  return "<cellSpaceBoundaryMember><" + type + " gml:id='" + id + "'>" + content +
         "<cellSpaceBoundaryGeometry><geometry2D><gml:LineString><gml:posList>" + pos +
         "</gml:posList></gml:LineString></geometry2D></cellSpaceBoundaryGeometry></" + type +
         "></cellSpaceBoundaryMember>";
}

std::string document(const std::string& space, const std::string& graph = "") {
  return "<?xml version='1.0'?><IndoorFeatures xmlns='http://www.opengis.net/indoorgml/1.0/core' "
         "xmlns:gml='http://www.opengis.net/gml/3.2' xmlns:xlink='http://www.w3.org/1999/xlink'>"
         "<primalSpaceFeatures><PrimalSpaceFeatures>" +
         space + "</PrimalSpaceFeatures></primalSpaceFeatures><multiLayeredGraph>" + graph +
         "</multiLayeredGraph></IndoorFeatures>";
}

double length(const SourceGeometry& geometry) {
  double total = 0.0;
  for (const auto& path : geometry.paths) {
    for (std::uint32_t i = path.first + 1; i < path.first + path.count; ++i) {
      total += std::hypot(geometry.xs[i] - geometry.xs[i - 1], geometry.ys[i] - geometry.ys[i - 1]);
    }
  }
  return total;
}

class IndoorGml : public testing::Test {
 protected:
  std::string file(const std::string& content) { return folder_.file("a.gml", content); }

  OpenedReader open(const std::string& content) {
    const auto path = file(content);
    EXPECT_TRUE(is_indoorgml(path));
    return open_indoorgml(path);
  }

  // By layer and gml:id.
  std::map<std::string, std::map<std::string, SourceFeature>> read(const std::string& content) {
    auto reader = open(content);
    EXPECT_TRUE(reader) << (reader ? "" : reader.error().message);
    std::map<std::string, std::map<std::string, SourceFeature>> all;
    if (!reader) return all;
    for (std::size_t i = 0; i < (*reader)->layers().size(); ++i) {
      auto& features = all[(*reader)->layers()[i].name];
      const auto count = (*reader)->read(i, {}, [&](SourceFeature& feature) {
        features[std::get<std::string>(feature.values[0])] = feature;
      });
      EXPECT_EQ(count.value_or(0), features.size());
    }
    return all;
  }

  test::TemporaryFolder folder_;
};

constexpr Room kWest{0, 0, 4, 3}, kEast{4, 0, 10, 3};

TEST_F(IndoorGml, SharedWallsComeOnceWithGapsForOpenings) {
  auto all = read(document(cell("W", flat(kWest)) + cell("E", flat(kEast)) +
                           boundary("door", "<duality xlink:href='#t'/>", "4 1 4 2") +
                           boundary("wall", "", "4 0 4 1")));
  ASSERT_EQ(all.size(), 1U);
  auto& features = all["IndoorGML"];
  EXPECT_DOUBLE_EQ(length(features["W"].geometry), 14.0 - 1.0);
  EXPECT_DOUBLE_EQ(length(features["E"].geometry), 18.0 - 3.0);
  EXPECT_EQ(std::get<std::string>(features["door"].values[8]), "opening");
  EXPECT_TRUE(features["wall"].geometry.paths.empty());
  EXPECT_FALSE(features["wall"].geometry.unsupported.empty());
}

TEST_F(IndoorGml, RoomsLieOnTheRightOfTheirWalls) {
  auto features = read(document(cell("W", solid(kWest, 0, 3))))["IndoorGML"];
  const auto& g = features["W"].geometry;
  ASSERT_EQ(g.paths.size(), 1U);
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < g.xs.size(); ++i) {
    area += 0.5 * (g.xs[i] * g.ys[i + 1] - g.xs[i + 1] * g.ys[i]);
  }
  EXPECT_DOUBLE_EQ(area, -12.0);
  EXPECT_DOUBLE_EQ(std::get<double>(features["W"].values[9]), 3.0);
}

// Doors that are cells in the wall, told by their kind, or by a transition and their size.
TEST_F(IndoorGml, DoorsInTheWallAreOpen) {
  const Room east{4.2, 0, 10, 3}, door{4, 1, 4.2, 2};
  const std::string rooms = cell("W", flat(kWest)) + cell("E", flat(east));
  const std::string graph =
      "<transitionMember><Transition gml:id='t'><connects xlink:href='#D'/><connects "
      "xlink:href='#W'/></Transition></transitionMember>";
  auto closed = read(document(rooms + cell("D", flat(door))))["IndoorGML"];
  EXPECT_DOUBLE_EQ(length(closed["W"].geometry), 14.0);
  auto navi = read(document(rooms + cell("D", flat(door), "ConnectionSpace")))["IndoorGML"];
  EXPECT_NEAR(length(navi["W"].geometry), 13.0, 1e-9);
  EXPECT_NEAR(length(navi["E"].geometry), 2 * 5.8 + 6.0 - 1.0, 1e-9);
  EXPECT_NEAR(length(navi["D"].geometry), 0.4, 1e-9);
  auto joined = read(document(rooms + cell("D", flat(door)), graph))["IndoorGML"];
  EXPECT_NEAR(length(joined["W"].geometry), 13.0, 1e-9);
  EXPECT_DOUBLE_EQ(length(joined["E"].geometry), 2 * 5.8 + 6.0);
}

// A door is drawn once, on one face of its wall, within it, or beside it.
TEST_F(IndoorGml, DoorsOpenBothFacesOfAThickWall) {
  const auto rooms = cell("W", solid(kWest, 0, 3)) + cell("E", solid({4.2, 0, 10, 3}, 0, 3));
  for (const std::string at : {"4", "4.1", "4.2", "4.5", "3.7"}) {
    auto all = read(
        document(rooms + boundary("door", "<duality xlink:href='#t'/>", at + " 1 " + at + " 2")));
    auto& features = all["IndoorGML"];
    const double walls = length(features["W"].geometry) + length(features["E"].geometry);
    EXPECT_NEAR(walls, (14 - 1) + (17.6 - 1) + 2 * 0.2, 1e-9) << at;  // two jambs
    ASSERT_EQ(features["door"].warnings.size(), 1U) << at;
    EXPECT_NE(features["door"].warnings[0].find("beside a face of its wall"), std::string::npos);
  }
}

TEST_F(IndoorGml, DoorsOpenNoWallBeyondTheirOwn) {
  // Rooms 0.7 m apart are not two faces of one wall; a corridor's other wall is not the door's.
  auto apart =
      read(document(cell("W", solid(kWest, 0, 3)) + cell("E", solid({4.7, 0, 10, 3}, 0, 3)) +
                    boundary("door", "<duality xlink:href='#t'/>", "4 1 4 2")))["IndoorGML"];
  EXPECT_NEAR(length(apart["W"].geometry), 13, 1e-9);
  EXPECT_NEAR(length(apart["E"].geometry), 16.6, 1e-9);
  auto shaft =
      read(document(cell("W", solid(kWest, 0, 3)) + cell("S", solid({4.1, 0, 4.5, 3}, 0, 3)) +
                    cell("E", solid({4.6, 0, 10, 3}, 0, 3)) +
                    boundary("door", "<duality xlink:href='#t'/>", "4 1 4 2")))["IndoorGML"];
  EXPECT_NEAR(length(shaft["E"].geometry), 2 * (5.4 + 3), 1e-9);
  EXPECT_NEAR(length(shaft["S"].geometry), 2 * (0.4 + 3) - 1 + 2 * 0.1, 1e-9);
}

TEST_F(IndoorGml, DoorsAtNoWallAreTold) {
  const auto content = document(cell("W", solid(kWest, 0, 3)) +
                                boundary("lost", "<duality xlink:href='#t'/>", "2 1 2 2"));
  auto reader = open(content);
  ASSERT_TRUE(reader);
  const auto warnings = (*reader)->take_warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("1 door lies at no wall and open"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("lost"), std::string::npos);
  auto features = read(content)["IndoorGML"];
  EXPECT_NEAR(length(features["W"].geometry), 14, 1e-9);
  ASSERT_EQ(features["lost"].warnings.size(), 1U);
  EXPECT_NE(features["lost"].warnings[0].find("at no wall"), std::string::npos);
}

TEST_F(IndoorGml, WindowsAreNoWayThrough) {
  const Room window{4, 1, 4.2, 2};
  const std::string graph =
      "<transitionMember><Transition gml:id='t'><connects xlink:href='#D'/><connects "
      "xlink:href='#W'/></Transition></transitionMember>";
  auto all =
      read(document(cell("W", solid(kWest, 0, 3)) + cell("D", solid(window, 0.8, 2)), graph));
  auto& features = all["IndoorGML"];
  EXPECT_DOUBLE_EQ(length(features["W"].geometry), 14.0);
  EXPECT_DOUBLE_EQ(std::get<double>(features["D"].values[10]), 0.8);
}

TEST_F(IndoorGml, StoreysAreToldByNameOrHeight) {
  const std::string first = "<gml:description>storey=\"1\":indoor=\"room\":</gml:description>";
  const std::string second = "<gml:description>level=2;</gml:description>";
  auto named = read(document(cell("W", first + flat(kWest)) + cell("E", second + flat(kWest))));
  EXPECT_EQ(named["IndoorGML storey 1"].count("W"), 1U);
  EXPECT_EQ(named["IndoorGML storey 2"].count("E"), 1U);
  auto high = read(document(cell("E", solid(kEast, 3, 6)) + cell("W", solid(kWest, 0, 3)) +
                            cell("N", solid({0, 3, 4, 6}, 0.4, 3))));
  EXPECT_EQ(high["IndoorGML storey 0.00 m"].size(), 2U);
  EXPECT_EQ(high["IndoorGML storey 3.00 m"].count("E"), 1U);
}

TEST_F(IndoorGml, FloorsAreFoundWhateverTheWindingAndTheLinks) {
  std::string inside_out = solid(kWest, 0, 3);
  auto plain = read(document(cell("W", inside_out)))["IndoorGML"];
  const std::string open = "<gml:Polygon>", named = "<gml:Polygon gml:id='f'>";
  inside_out.replace(inside_out.find(open), open.size(), named);
  const auto end = inside_out.find("</gml:Shell>");
  const auto from = inside_out.find("<gml:surfaceMember>");
  const auto until = inside_out.find("</gml:surfaceMember>") + 20;
  const std::string floor = inside_out.substr(from + 19, until - from - 39);
  ASSERT_GT(end, until);
  std::string linked = inside_out.substr(0, from) +
                       "<gml:surfaceMember><gml:OrientableSurface orientation='-'><gml:baseSurface "
                       "xlink:href='#f'/></gml:OrientableSurface></gml:surfaceMember>" +
                       inside_out.substr(until);
  auto all = read(document(cell("W", linked) + cell("X", "<shape>" + floor + "</shape>")));
  EXPECT_EQ(all["IndoorGML"]["W"].broken, "");
  EXPECT_DOUBLE_EQ(length(all["IndoorGML"]["W"].geometry), length(plain["W"].geometry));
}

TEST_F(IndoorGml, WhatCannotBeEnteredIsAPolygon) {
  auto all =
      read(document(cell("W", flat(kWest)) + cell("B", flat({1, 1, 2, 2}), "NonNavigableSpace")));
  const auto& g = all["IndoorGML"]["B"].geometry;
  ASSERT_EQ(g.paths.size(), 1U);
  EXPECT_EQ(g.paths[0].role, PathRole::kOuterRing);
}

TEST_F(IndoorGml, AxesGoByTheAuthorityWhereTheNameAsksForIt) {
  const auto box = [&](const std::string& srs) {
    std::string text = document(cell("W", flat({41, 2, 41.0001, 2.0002})));
    text.replace(text.find("<gml:Polygon>"), 13, "<gml:Polygon srsName='" + srs + "'>");
    auto reader = open(text);
    EXPECT_EQ((*reader)->layers()[0].crs.code, "EPSG:4326");
    return (*reader)->extent(0)->value();
  };
  EXPECT_DOUBLE_EQ(box("urn:ogc:def:crs:EPSG::4326").min_x, 2.0);
  EXPECT_DOUBLE_EQ(box("EPSG:4326").min_x, 41.0);
}

TEST_F(IndoorGml, HostileDocumentsEndSoon) {
  const auto message = [&](const std::string& content) {
    const auto reader = open(content);
    return reader ? std::string() : reader.error().message;
  };
  EXPECT_NE(message(document("")).find("no cell"), std::string::npos);
  EXPECT_NE(message(document(cell("W", flat(kWest))).substr(0, 500)).find("damaged"),
            std::string::npos);
  // Links that refer to themselves, and twice to what refers twice to …
  const std::string self = "<cellSpaceGeometry gml:id='g'><x xlink:href='#g'/></cellSpaceGeometry>";
  EXPECT_NE(message(document(cell("W", self))).find("without end"), std::string::npos);
  std::string bomb;
  for (int i = 0; i < 25; ++i) {
    const auto n = std::to_string(i), next = std::to_string(i + 1);
    bomb += "<g" + n + " gml:id='g" + n + "'><x xlink:href='#g" + next + "'/><x xlink:href='#g" +
            next + "'/></g" + n + ">";
  }
  bomb +=
      "<gml:Polygon gml:id='g25'><gml:exterior><gml:LinearRing><gml:posList>0 0 1 0 1 1 0 "
      "0</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon>"
      "<cellSpaceGeometry><x xlink:href='#g0'/></cellSpaceGeometry>";
  EXPECT_NE(message(document(cell("W", bomb))).find("without end"), std::string::npos);
  // Deep nesting is no reason to fall over.
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  EXPECT_EQ(message(document(cell("W", flat(kWest)) + deep)), "");
}

TEST_F(IndoorGml, StoreysOnTopOfEachOtherAreRefusedUntilOneIsPicked) {
  const auto path = file(document(cell("W", solid(kWest, 0, 3)) + cell("E", solid(kWest, 3, 6))));
  const std::string map = folder_.path("m.txt");
  const auto refused = test::run({"convert", path, "-o", map, "--local"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--layer 'IndoorGML storey 3.00 m'"), std::string::npos)
      << refused.err;
  const auto picked =
      test::run({"convert", path, "-o", map, "--local", "--layer", "IndoorGML storey 3.00 m"});
  EXPECT_EQ(picked.status, 0) << picked.err;
}

}  // namespace
}  // namespace mapwright::converter
