#include "converter/exporters/picture/moving_picture.hpp"

#include <webp/encode.h>
#include <webp/mux.h>

namespace mapwright::converter {
namespace {

constexpr float kEffort = 50.0F;  // of 100: smaller files beyond it take several times as long
constexpr std::uint32_t kOpaque = 0xFF000000U;

struct EncoderDeleter {
  void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};

WebPConfig lossless() {
  WebPConfig config;
  WebPConfigInit(&config);
  config.lossless = 1;
  config.quality = kEffort;
  config.method = 2;
  return config;
}

}  // namespace

struct MovingPicture::Impl {
  int frame_ms = 0;
  int time_ms = 0;
  WebPConfig config = lossless();
  std::unique_ptr<WebPAnimEncoder, EncoderDeleter> encoder;
  std::string error;  ///< the first

  void fail(const char* why) {
    if (error.empty()) error = why;
  }

  void begin(int width, int height) {
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    encoder.reset(WebPAnimEncoderNew(width, height, &options));
    if (!encoder) fail("the WebP encoder cannot begin");
  }

  void encode(WebPPicture& picture) {
    if (WebPAnimEncoderAdd(encoder.get(), &picture, time_ms, &config) == 0) {
      fail(WebPAnimEncoderGetError(encoder.get()));
    }
    time_ms += frame_ms;
  }
};

MovingPicture::MovingPicture(int frame_ms) : impl_(std::make_unique<Impl>()) {
  impl_->frame_ms = frame_ms;
}

MovingPicture::~MovingPicture() = default;

void MovingPicture::add(const Pixels& pixels) {
  if (!impl_->encoder) impl_->begin(pixels.width, pixels.height);
  if (!impl_->error.empty()) return;
  WebPPicture picture;
  WebPPictureInit(&picture);
  picture.use_argb = 1;
  picture.width = pixels.width;
  picture.height = pixels.height;
  std::vector<std::uint32_t> colours = pixels.colours;
  for (auto& colour : colours) colour |= kOpaque;
  picture.argb = colours.data();  // still ours: the library frees what it has allocated
  picture.argb_stride = pixels.width;
  impl_->encode(picture);
  WebPPictureFree(&picture);
}

Result<std::string> MovingPicture::finish() {
  WebPData data;
  WebPDataInit(&data);
  std::string bytes;
  if (!impl_->encoder) impl_->fail("it has no frame");
  if (impl_->error.empty()) {
    if (WebPAnimEncoderAdd(impl_->encoder.get(), nullptr, impl_->time_ms, nullptr) == 0 ||
        WebPAnimEncoderAssemble(impl_->encoder.get(), &data) == 0) {
      impl_->fail(WebPAnimEncoderGetError(impl_->encoder.get()));
    } else {
      bytes.assign(reinterpret_cast<const char*>(data.bytes), data.size);
    }
  }
  WebPDataClear(&data);
  if (impl_->error.empty()) return bytes;
  return output_failure("picture: " + impl_->error);
}

}  // namespace mapwright::converter
