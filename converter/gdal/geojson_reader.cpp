#include "converter/gdal/geojson_reader.hpp"

#include <utility>

#include "converter/gdal/geojson_shapes.hpp"
#include "converter/source/wrapped_reader.hpp"

namespace mapwright::converter {
namespace {

class GeoJsonReader : public WrappedReader {
 public:
  GeoJsonReader(std::unique_ptr<SourceReader> reader, std::string path)
      : WrappedReader(std::move(reader)), path_(std::move(path)) {}

  // GDAL hands out the features in the order of the document.
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    const auto broken = broken_shapes(path_);
    std::size_t place = 0;
    return behind().read(layer, options, [&](SourceFeature& feature) {
      const auto found = broken.find(place++);
      if (found != broken.end() && feature.broken.empty()) feature.broken = found->second;
      visit(feature);
    });
  }

 private:
  std::string path_;
};

}  // namespace

std::unique_ptr<SourceReader> with_checked_shapes(std::unique_ptr<SourceReader> reader,
                                                  std::string path) {
  return std::make_unique<GeoJsonReader>(std::move(reader), std::move(path));
}

}  // namespace mapwright::converter
