#include <gtest/gtest.h>

#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/support/random_map.hpp"

namespace mapwright {
namespace {

constexpr std::size_t kMaps = 10'000;

// The layout of the report's appendix: a field list a line, '#' on a line of its own.
constexpr const char* kColumn =
    "border;\n-4;58;\n58;-4;\n#\n"
    "obstacle;\n1;1;4;column,A5;\n#\n"
    "4.53;12.1;\n7.29;12.1;\n5;1;wall,orange,brick;\n#\n"
    "7.29;12.1;\n7.29;13.86;\n5;1;wall,orange,brick;\n#\n"
    "7.29;13.86;\n4.53;13.86;\n5;1;wall,orange,brick;\n#\n"
    "4.53;13.86;\n4.53;12.1;\n5;0;wall,orange,brick;\n#\n";

Map column() {
  const Point a{4.53, 12.1}, b{7.29, 12.1}, c{7.29, 13.86}, d{4.53, 13.86};
  const auto out = InOut::kOutdoor;
  const Semantic brick("wall,orange,brick");
  return {{-4, 58, 58, -4},
          {{1,
            ShapeType::kClosedPolygon,
            "column,A5",
            {{a, b, 5, out, brick},
             {b, c, 5, out, brick},
             {c, d, 5, out, brick},
             {d, a, 5, InOut::kIndoor, brick}}}}};
}

TEST(RoundTrip, LayoutIsTheReports) {
  EXPECT_EQ(format_map(column()), kColumn);
  const MapDocument document = read_map(kColumn);
  EXPECT_EQ(document.map, column());
  EXPECT_TRUE(document.findings.empty());
}

TEST(RoundTrip, GivesTheQuantizedMapWithoutFindings) {
  Random random(1);
  for (std::size_t i = 0; i < kMaps; ++i) {
    const Map map = test::random_map(random);
    const MapDocument document = read_map(format_map(map));
    ASSERT_EQ(document.map, quantized(map)) << "map " << i << ":\n" << document.text.view();
    ASSERT_TRUE(document.findings.empty()) << "map " << i << ": " << document.findings[0].message;
  }
}

TEST(RoundTrip, WritingTwiceChangesNothing) {
  Random random(2);
  for (std::size_t i = 0; i < kMaps; ++i) {
    const std::string once = format_map(test::random_map(random));
    ASSERT_EQ(format_map(read_map(once).map), once) << "map " << i;
  }
}

TEST(RoundTrip, HoldsAtEveryResolution) {
  Random random(3);
  for (const double resolution_m : {1e-9, 1e-6, 0.005, 0.01, 0.25, 0.5, 1.0, 7.0, 1000.0}) {
    for (int i = 0; i < 300; ++i) {
      const Map map = test::random_map(random);
      const MapDocument document = read_map(format_map(map, {resolution_m}));
      ASSERT_EQ(document.map, quantized(map, {resolution_m})) << resolution_m << '\n'
                                                              << document.text.view();
      ASSERT_EQ(format_map(document.map, {resolution_m}), document.text.view()) << resolution_m;
    }
  }
}

}  // namespace
}  // namespace mapwright
