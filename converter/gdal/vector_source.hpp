// The one door through which GIS files come in.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

struct OpenOptions {
  std::vector<std::string> extra_drivers;  ///< allowed besides default_drivers()
};

/// A file or folder of vector layers, opened for reading only: it is never changed, and nothing is
/// left beside it. What reads it runs in a process of its own, so that a file that makes a driver
/// crash, hang or eat all memory is an input that cannot be read, and no more.
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

  /// Extent of a layer in its own coordinates; nothing where it has none. May read the whole layer,
  /// and fails (kInput) where that ends badly.
  Result<std::optional<Box>> extent(std::size_t layer);

  /// Hands each feature of a layer to `visit`, in the source's order; the feature is reused. Stops
  /// with a failure (kInput) where the layer cannot be read to its end, and with kUsage where
  /// `where` does not fit the layer. Returns the number of features.
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit);

 private:
  struct Impl;
  explicit VectorSource(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
