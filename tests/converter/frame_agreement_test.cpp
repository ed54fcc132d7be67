// The sidecar says twice where the map lies: both must mean the same place.
#include "converter/frame/frame_agreement.hpp"

#include <gtest/gtest.h>

#include "converter/frame/frame_wkt.hpp"
#include "mapcore/random.hpp"

namespace mapwright::converter {
namespace {

constexpr std::uint64_t kMutants = 40;

Georeference sound(Random& random) {
  Georeference g;
  g.origin_latitude_deg = random.uniform(-75.0, 75.0);
  g.origin_longitude_deg = random.uniform(-179.0, 179.0);
  g.origin_height_m = random.uniform(0.0, 1000.0);
  g.heading_deg = random.below(4) == 0 ? 0.0 : random.uniform(-180.0, 180.0);
  if (random.below(2) == 0) g.projection = FrameProjection::kEastNorthUp;
  g.wkt2 = frame_wkt2(g);
  return g;
}

TEST(FrameAgreement, HoldsForWhatConvertWrites) {
  for (std::uint64_t seed = 1; seed <= kMutants; ++seed) {
    Random random(seed);
    const auto finding = frame_mismatch(sound(random));
    EXPECT_FALSE(finding.has_value()) << seed << ": " << finding->message;
  }
}

TEST(FrameAgreement, IsBrokenByAnyCorrectionByHand) {
  for (std::uint64_t seed = 1; seed <= kMutants; ++seed) {
    Random random(seed);
    Georeference g = sound(random);
    switch (seed % 4) {
      case 0:
        g.heading_deg += random.uniform(0.001, 5.0);
        break;
      case 1:
        g.origin_latitude_deg += random.uniform(1e-6, 1e-3);
        break;
      case 2:
        g.origin_longitude_deg -= random.uniform(1e-6, 1e-3);
        break;
      default:
        g.wkt2.replace(g.wkt2.find("4326"), 4, "4258").resize(g.wkt2.size() / 2);
    }
    const auto finding = frame_mismatch(g);
    ASSERT_TRUE(finding.has_value()) << seed;
    EXPECT_EQ(finding->code, FindingCode::C241);
  }
}

TEST(FrameAgreement, IsNotAskedForWithoutWkt) {
  Random random(1);
  Georeference g = sound(random);
  g.wkt2.clear();
  EXPECT_FALSE(frame_mismatch(g).has_value());
}

TEST(FrameAgreement, SaysHowFarApartTheFramesAre) {
  Georeference g;
  g.origin_latitude_deg = 41.389;
  g.origin_longitude_deg = 2.1134;
  g.wkt2 = frame_wkt2(g);
  g.heading_deg = 90.0;
  const auto finding = frame_mismatch(g);
  ASSERT_TRUE(finding.has_value());
  EXPECT_NE(finding->message.find("2000.00 m apart"), std::string::npos) << finding->message;
}

}  // namespace
}  // namespace mapwright::converter
