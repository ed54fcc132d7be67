// What became of every feature.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "converter/store/long_list.hpp"
#include "converter/store/small_list.hpp"
#include "mapcore/finding.hpp"

namespace mapwright::converter {

/// `kChanged`: geometry or attributes are not what the source had. Becoming several obstacles,
/// being turned to the map's orientation and being rounded to its resolution are still `kWritten`.
enum class Outcome : std::uint8_t { kWritten, kChanged, kDropped };

std::string_view to_string(Outcome outcome);

/// How much a repair changed, where that was measured.
struct Measures {
  std::optional<double> hausdorff_m;     ///< between the drawing before and after
  std::optional<double> area_change_m2;  ///< after minus before
};

struct LedgerReason {
  FindingCode code;
  std::string message;
  Measures measures = {};
};

/// The account of a feature. Most are one obstacle and need no reason, and there are as many as the
/// sources have features: these take 32 bytes and nothing besides.
struct LedgerFeature {
  std::int64_t fid = 0;
  OneOrMore obstacles;  ///< ids
  NoneOrMore<LedgerReason> reasons;
  std::uint32_t source = 0;  ///< position in Ledger::sources
  Outcome outcome = Outcome::kWritten;
};

/// A layer of a source.
struct LedgerSource {
  std::string path, layer;
  std::string crs;  ///< empty for plain local metres
  std::size_t features = 0;
  std::vector<std::string> warnings;
};

struct LedgerTotals {
  std::size_t features = 0, written = 0, changed = 0, dropped = 0;
};

class Ledger {
 public:
  std::vector<LedgerSource> sources;
  LongList<LedgerFeature, kLastingBlock> features;

  /// Opens the account of a feature; returns its position.
  std::size_t open(std::size_t source, std::int64_t fid);

  /// A reason that alters nothing: the feature stays as it is.
  void remark(std::size_t feature, FindingCode code, std::string message);
  /// The feature is not what the source had.
  void change(std::size_t feature, FindingCode code, std::string message, Measures measures = {});
  /// Nothing of the feature is in the map.
  void drop(std::size_t feature, FindingCode code, std::string message);

  LedgerTotals totals() const;

  /// Positions of the features that have reasons, in order: nearly always a few of all.
  std::vector<std::uint32_t> explained() const;

 private:
  void add_reason(std::size_t feature, LedgerReason reason);

  std::vector<std::uint32_t> explained_;  // in no order, some more than once
};

/// True if every feature is accounted for once: the layers' counts, the outcomes and the accounts
/// agree, nothing dropped has obstacles, nothing written or changed lacks them, and nothing changed
/// or dropped lacks a reason.
bool balances(const Ledger& ledger);

/// The report of `convert --report`: JSON with "schema": "mapwright.convert/1" (docs/cli.md).
/// Written feature by feature, so that it is nowhere whole.
void write_ledger(const Ledger& ledger, std::ostream& out);

}  // namespace mapwright::converter
