#include "converter/source/document_reader.hpp"

#include <utility>

#include "converter/gdal/feature_filter.hpp"

namespace mapwright::converter {

std::vector<std::string> DocumentReader::take_warnings() {
  return std::exchange(warnings_, {});
}

Result<std::optional<Box>> DocumentReader::extent(std::size_t layer) {
  Box box = kEmptyBox;
  each(layer, nullptr, [&](const SourceFeature& feature) {
    const auto& geometry = feature.geometry;
    for (std::size_t i = 0; i < geometry.xs.size(); ++i) box.add({geometry.xs[i], geometry.ys[i]});
  });
  return box.is_empty() ? std::nullopt : std::optional(box);
}

Result<std::size_t> DocumentReader::read(std::size_t layer, const ReadOptions& options,
                                         const FeatureVisitor& visit) {
  const LayerInfo& info = layers_[layer];
  const auto filter = FeatureFilter::create(info.fields, options.where);
  if (!filter) {
    return usage_failure("--where: '" + options.where + "' does not fit layer " + info.name + ": " +
                         filter.error().message);
  }
  std::size_t count = 0;
  each(layer, &options, [&](SourceFeature& feature) {
    feature.selected = filter->holds(feature);
    visit(feature);
    ++count;
  });
  return count;
}

}  // namespace mapwright::converter
