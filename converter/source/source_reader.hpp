// What every reader of a source offers, whatever format and library are behind it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "converter/gdal/crs.hpp"
#include "converter/source/feature.hpp"
#include "converter/source/feature_row.hpp"
#include "mapcore/point.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

struct LayerInfo {
  std::string name;
  std::vector<std::string> fields;
  GeometryKind geometry =
      GeometryKind::kMixed;  ///< declared; kMixed where the layer leaves it open
  Crs crs;
  std::string several_crs;              ///< names, where its features are not in one CRS
  std::int64_t declared_features = -1;  ///< negative where only reading tells
  double metres_per_local_unit = 1.0;   ///< of coordinates without CRS
  bool lacks_attributes = false;        ///< they are gone, not merely none
  bool is_view = false;                 ///< shows what other tables hold
  std::string storey;                   ///< of a building, where the source has several: its name
  bool chains_lines = false;  ///< a drawing: its lines are loose and their direction means nothing
};

struct ReadOptions {
  std::string where;                ///< SQL condition; features it does not hold for are unselected
  double sagitta_m = 0.01;          ///< arcs become chords that stay nearer than this
  std::vector<std::string> fields;  ///< only these are read, unless empty
  bool keep_broken = false;         ///< errors of single features become warnings of theirs
};

using FeatureVisitor = std::function<void(SourceFeature&)>;

class SourceReader {
 public:
  SourceReader() = default;
  SourceReader(const SourceReader&) = delete;
  SourceReader& operator=(const SourceReader&) = delete;
  virtual ~SourceReader() = default;

  /// GDAL's name of the format: "ESRI Shapefile", "OSM" …
  virtual const std::string& driver() const = 0;
  virtual const std::vector<LayerInfo>& layers() const = 0;

  /// What went unsaid or was said by the driver while opening and reading, since the last call.
  virtual std::vector<std::string> take_warnings() = 0;

  /// Extent of a layer in its own coordinates; nothing where it has none. May read the whole layer,
  /// and fails (kInput) where that ends badly.
  virtual Result<std::optional<Box>> extent(std::size_t layer) = 0;

  /// Hands each feature of a layer to `visit`, in the source's order; the feature is reused. Fails
  /// (kInput) where the layer cannot be read to its end, and with kUsage where `where` does not fit
  /// the layer. Returns the number of features.
  virtual Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                                   const FeatureVisitor& visit) = 0;

  /// The same for a sink, which takes features as rows, too, where the source has such.
  virtual Result<std::size_t> read_into(std::size_t layer, const ReadOptions& options,
                                        FeatureSink& sink);
};

using OpenedReader = Result<std::unique_ptr<SourceReader>>;

}  // namespace mapwright::converter
