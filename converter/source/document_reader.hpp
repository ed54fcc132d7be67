// A source that was read as a whole when it was opened.
#pragma once

#include <string>
#include <vector>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// What readers of our own (OSM, IndoorGML) have in common: the document is in memory, and layers
/// are made of it when they are asked for.
class DocumentReader : public SourceReader {
 public:
  const std::string& driver() const final { return driver_; }
  const std::vector<LayerInfo>& layers() const final { return layers_; }
  std::vector<std::string> take_warnings() final;
  Result<std::optional<Box>> extent(std::size_t layer) final;
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) final;

 protected:
  explicit DocumentReader(std::string driver) : driver_(std::move(driver)) {}

  void add_layer(LayerInfo layer) { layers_.push_back(std::move(layer)); }
  void warn(std::string warning) { warnings_.push_back(std::move(warning)); }

  /// Hands each feature of a layer to `visit`; the feature may be reused. Null: nobody looks at
  /// values of fields.
  virtual void each(std::size_t layer, const ReadOptions* options, const FeatureVisitor& visit) = 0;

 private:
  std::string driver_;
  std::vector<LayerInfo> layers_;
  std::vector<std::string> warnings_;
};

}  // namespace mapwright::converter
