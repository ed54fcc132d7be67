// What many maps come to: verdicts and the most frequent findings.
#pragma once

#include <cstddef>
#include <map>
#include <ostream>
#include <string_view>

#include "mapcore/finding.hpp"
#include "validators/report/report.hpp"

namespace mapwright::cli {

class SummaryTable {
 public:
  void add(const validators::MapReport& report);

  std::size_t maps() const { return maps_; }

  /// Verdicts with their maps, then up to ten codes by how many findings they have.
  void write(std::ostream& out) const;

 private:
  struct CodeCount {
    std::size_t findings = 0;
    std::size_t maps = 0;
  };

  std::size_t maps_ = 0;
  std::map<std::string_view, std::size_t> verdicts_;
  std::map<FindingCode, CodeCount> codes_;
};

}  // namespace mapwright::cli
