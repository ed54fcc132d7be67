// Which GIS features each obstacle of a converted map was made of.
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "converter/ledger/ledger.hpp"
#include "mapcore/finding.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// The ledger of a conversion, by obstacle.
class ObstacleSources {
 public:
  /// What the ledger knows of the obstacles that `findings` are about.
  ObstacleSources(const Ledger& ledger, const std::vector<Finding>& findings);

  /// From the file that `convert --report` writes. Fails (kInput) for other texts.
  static Result<ObstacleSources> parse(std::string_view json);

  /// The features of an obstacle in the order of the ledger; none where it knows of none.
  const std::vector<GisFeature>& of(std::int64_t obstacle) const;

  /// Gives each finding about an obstacle its features.
  void name_features(std::vector<Finding>& findings) const;

 private:
  ObstacleSources() = default;

  std::unordered_map<std::int64_t, std::vector<GisFeature>> features_;
};

}  // namespace mapwright::converter
