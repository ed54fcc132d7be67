// A rule set bound to one layer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "converter/gdal/vector_source.hpp"
#include "converter/rules/meaning.hpp"

namespace mapwright::converter {

/// Finds the rule of each feature of a layer and reads the fields it names. Borrows the rule set,
/// which must outlive it.
class LayerRules {
 public:
  LayerRules(const RuleSet& rules, const LayerInfo& layer);
  LayerRules(LayerRules&&) noexcept;
  LayerRules& operator=(LayerRules&&) noexcept;
  ~LayerRules();

  /// The meaning of a feature by the first rule that fits; `meaning` is overwritten. Uses memory of
  /// its own, so not from several threads at once.
  void interpret(const SourceFeature& feature, GeometryKind geometry, Meaning& meaning) const;

  /// Fields of the layer that some rule reads; none, which means all, where obstacles that `export`
  /// wrote may be among the features.
  std::vector<std::string> fields() const;

  /// One line a rule that can match: why it matches the layer and which fields it reads
  /// (`--explain-rules`).
  std::vector<std::string> explain() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::converter
