// The one door through which GIS files come in. No type of GDAL leaves this folder.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "converter/gdal/crs.hpp"
#include "converter/source/feature.hpp"
#include "mapcore/point.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

struct LayerInfo {
  std::string name;
  std::vector<std::string> fields;
  GeometryKind geometry =
      GeometryKind::kMixed;  ///< declared; kMixed where the layer leaves it open
  Crs crs;
  std::int64_t declared_features = -1;  ///< negative where only reading tells
};

struct OpenOptions {
  std::vector<std::string> extra_drivers;  ///< allowed besides default_drivers()
};

struct ReadOptions {
  std::string where;                ///< SQL condition; features it does not hold for are unselected
  double sagitta_m = 0.01;          ///< arcs become chords that stay nearer than this
  std::vector<std::string> fields;  ///< only these are read, unless empty
  bool keep_broken = false;         ///< errors of single features become warnings of theirs
};

/// A file or folder of vector layers, opened for reading only: it is never changed, and nothing is
/// left beside it.
class VectorSource {
 public:
  /// Fails with kInput for what cannot be read, kUsage for what is not asked for properly (remote
  /// or virtual paths, unknown drivers). The message names the path.
  static Result<VectorSource> open(const std::string& path, const OpenOptions& options);
  VectorSource(VectorSource&&) noexcept;
  VectorSource& operator=(VectorSource&&) noexcept;
  ~VectorSource();

  const std::string& path() const;
  const std::string& driver() const;
  const std::vector<LayerInfo>& layers() const;

  /// What went unsaid or was said by the driver while opening and reading, for the ledger.
  const std::vector<std::string>& warnings() const;

  /// Extent of a layer in its own coordinates; nothing where it has none. May read the whole layer.
  std::optional<Box> extent(std::size_t layer);

  /// Hands each feature of a layer to `visit`, in the source's order; the feature is reused. Stops
  /// with a failure (kInput) where the layer cannot be read to its end, and with kUsage where
  /// `where` does not fit the layer. Returns the number of features.
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const std::function<void(SourceFeature&)>& visit);

 private:
  struct Impl;
  explicit VectorSource(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
