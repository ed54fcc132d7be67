#include "converter/gdal/geojson_reader.hpp"

#include <utility>

#include "converter/gdal/geojson_shapes.hpp"

namespace mapwright::converter {
namespace {

class GeoJsonReader : public SourceReader {
 public:
  GeoJsonReader(std::unique_ptr<SourceReader> reader, std::string path)
      : reader_(std::move(reader)), path_(std::move(path)) {}

  const std::string& driver() const override { return reader_->driver(); }
  const std::vector<LayerInfo>& layers() const override { return reader_->layers(); }
  std::vector<std::string> take_warnings() override { return reader_->take_warnings(); }
  Result<std::optional<Box>> extent(std::size_t layer) override { return reader_->extent(layer); }

  // GDAL hands out the features in the order of the document.
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    const auto broken = broken_shapes(path_);
    std::size_t place = 0;
    return reader_->read(layer, options, [&](SourceFeature& feature) {
      const auto found = broken.find(place++);
      if (found != broken.end() && feature.broken.empty()) feature.broken = found->second;
      visit(feature);
    });
  }

 private:
  std::unique_ptr<SourceReader> reader_;
  std::string path_;
};

}  // namespace

std::unique_ptr<SourceReader> with_checked_shapes(std::unique_ptr<SourceReader> reader,
                                                  std::string path) {
  return std::make_unique<GeoJsonReader>(std::move(reader), std::move(path));
}

}  // namespace mapwright::converter
