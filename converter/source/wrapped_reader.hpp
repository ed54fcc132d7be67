// A reader that stands in front of another.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// Says of a source what the reader behind says of it, but for what a derived class knows better:
/// layers, extents, features, and warnings that come before the other's.
class WrappedReader : public SourceReader {
 public:
  explicit WrappedReader(std::unique_ptr<SourceReader> behind)
      : behind_(std::move(behind)), layers_(behind_->layers()) {}

  const std::string& driver() const override { return behind_->driver(); }
  const std::vector<LayerInfo>& layers() const override { return layers_; }
  std::vector<std::string> take_warnings() override {
    auto warnings = std::exchange(warnings_, {});
    for (auto& warning : behind_->take_warnings()) warnings.push_back(std::move(warning));
    return warnings;
  }
  Result<std::optional<Box>> extent(std::size_t layer) override { return behind_->extent(layer); }

 protected:
  SourceReader& behind() const { return *behind_; }

  /// At first those of the reader behind.
  std::vector<LayerInfo>& own_layers() { return layers_; }

  void warn(std::string warning) { warnings_.push_back(std::move(warning)); }

 private:
  std::unique_ptr<SourceReader> behind_;
  std::vector<LayerInfo> layers_;
  std::vector<std::string> warnings_;
};

}  // namespace mapwright::converter
