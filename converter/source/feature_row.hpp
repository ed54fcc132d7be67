// A feature as a row of columns: where its parts lie, before anything is made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "converter/source/feature.hpp"
#include "converter/source/wkb.hpp"

namespace mapwright::converter {

/// A FieldValue whose text lies elsewhere.
using RowValue = std::variant<std::monostate, std::int64_t, double, std::string_view>;

/// Lasts until the next one is asked for.
struct FeatureRow {
  std::int64_t fid = 0;
  std::vector<std::uint32_t> fields;  ///< those that are read, ascending: positions in the layer
  std::vector<RowValue> values;       ///< of these
  WkbPaths geometry;
};

/// Takes features one after another.
class FeatureSink {
 public:
  FeatureSink() = default;
  FeatureSink(const FeatureSink&) = delete;
  FeatureSink& operator=(const FeatureSink&) = delete;
  virtual ~FeatureSink() = default;

  virtual void add(SourceFeature& feature) = 0;
  virtual void add(const FeatureRow& row) = 0;
};

}  // namespace mapwright::converter
