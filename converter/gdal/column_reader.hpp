// Private to this folder: features of a layer by way of GDAL's batches of columns.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "converter/source/feature_row.hpp"

class OGRLayer;

namespace mapwright::converter {

/// Reads a GeoPackage's layer in Arrow's columns, which GDAL fills straight from the table: a third
/// of the time that making a feature and a geometry of every row takes.
///
/// It hands over what GDAL's features would hold, or gives up: on errors, on rows without geometry
/// and on geometries that are more than points, lines and polygons. What comes then is read as
/// features, with the messages that belong to it (docs/decisions/0092).
class ColumnReader {
 public:
  /// Null where the layer, or a field that is read, is none that columns hold unchanged. Fields
  /// that GDAL is told to ignore are not read.
  static std::unique_ptr<ColumnReader> open(OGRLayer& layer);
  ~ColumnReader();

  /// The next feature; null at the end or where it gives up.
  const FeatureRow* next();
  bool gave_up() const;

 private:
  struct Impl;
  explicit ColumnReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
