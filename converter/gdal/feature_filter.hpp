// SQL conditions for readers that are not GDAL's.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "converter/source/feature.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// A condition in the SQL that GDAL understands, on features whose values are all texts.
class FeatureFilter {
 public:
  /// Fails (kUsage) with the reason where the condition does not fit the fields. An empty one holds
  /// for everything.
  static Result<FeatureFilter> create(const std::vector<std::string>& fields,
                                      const std::string& where);
  FeatureFilter(FeatureFilter&&) noexcept;
  FeatureFilter& operator=(FeatureFilter&&) noexcept;
  ~FeatureFilter();

  bool holds(const SourceFeature& feature) const;

 private:
  struct Impl;
  explicit FeatureFilter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
