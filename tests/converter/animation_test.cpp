// Pictures that move.
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <memory>

#include "converter/exporters/picture.hpp"
#include "tests/converter/png_image.hpp"

namespace mapwright::converter {
namespace {

struct Frame {
  test::PngImage image;
  int until_ms = 0;
};

// What a viewer shows, frame after frame.
std::vector<Frame> frames_of(const std::string& bytes) {
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
      WebPAnimDecoderNew(&data, nullptr), &WebPAnimDecoderDelete);
  std::vector<Frame> frames;
  if (!decoder) return frames;
  WebPAnimInfo info;
  WebPAnimDecoderGetInfo(decoder.get(), &info);
  const int width = static_cast<int>(info.canvas_width);
  const int height = static_cast<int>(info.canvas_height);
  std::uint8_t* rgba = nullptr;
  int until_ms = 0;
  while (WebPAnimDecoderGetNext(decoder.get(), &rgba, &until_ms) != 0) {
    std::vector<std::uint32_t> pixels;
    for (std::size_t i = 0; i < 4UL * info.canvas_width * info.canvas_height; i += 4) {
      pixels.push_back(std::uint32_t{rgba[i]} << 16U | std::uint32_t{rgba[i + 1]} << 8U |
                       rgba[i + 2]);
    }
    frames.push_back({{width, height, std::move(pixels)}, until_ms});
  }
  return frames;
}

// A site with a robot that drives from one side to the other.
const Map kSite{{0.0, 20.0, 20.0, 0.0}, {}};

Overlay robot_at(double x) {
  const OverlayPose robot{{x, 10.0, Angle()}, 4.0, Colour::from_hex(0xB0005A)};
  Overlay overlay;
  overlay.items = {robot};
  overlay.legend = {{robot, "robot"}};
  return overlay;
}

PictureOptions small() {
  PictureOptions options;
  options.width_px = 300;
  return options;
}

TEST(Animation, ShowsEachFrameToThePixel) {
  const std::vector<Overlay> overlays{robot_at(2.0), robot_at(10.0), robot_at(18.0)};
  const auto bytes = draw_animation(kSite, overlays, small(), 150);
  ASSERT_TRUE(bytes);
  const auto frames = frames_of(*bytes);
  ASSERT_EQ(frames.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(frames[i].until_ms, 150 * static_cast<int>(i + 1));
    const auto png = draw_picture(kSite, overlays[i], small(), PictureFormat::kPng);
    ASSERT_TRUE(png);
    EXPECT_EQ(frames[i].image.height(), test::PngImage(*png).height());
    EXPECT_EQ(frames[i].image.difference(test::PngImage(*png)).count(), 0) << "frame " << i;
  }
  EXPECT_GT(frames[0].image.difference(frames[1].image).count(), 50);
  EXPECT_EQ(draw_animation(kSite, overlays, small(), 150).value(), *bytes);
}

TEST(Animation, HasOneLegendForAllFrames) {
  const std::vector<Overlay> overlays{{}, robot_at(10.0)};
  const auto frames = frames_of(draw_animation(kSite, overlays, small(), 100).value_or(""));
  ASSERT_EQ(frames.size(), 2U);
  // Only the map differs: nothing in the lower part, where the legend is.
  const auto changed = frames[0].image.difference(frames[1].image);
  EXPECT_GT(changed.count(), 20);
  EXPECT_LT(changed.max_y(), frames[0].image.width());
}

TEST(Animation, StillPicturesAreWebpToo) {
  const auto bytes = draw_picture(kSite, robot_at(5.0), small(), PictureFormat::kWebp);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(frames_of(*bytes).size(), 1U);
}

TEST(Animation, RefusesWhatNoFileHolds) {
  EXPECT_FALSE(draw_animation(kSite, {}, small(), 100));
  PictureOptions options = small();
  options.width_px = 20000;
  const auto wide = draw_animation(kSite, std::vector<Overlay>{robot_at(1.0)}, options, 100);
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.error().message.find("16383"), std::string::npos) << wide.error().message;
}

}  // namespace
}  // namespace mapwright::converter
