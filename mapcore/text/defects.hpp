// The defects a reader collects, and how it words them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/decimal.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright::text {

/// What a record describes, as far as it is known.
struct Subject {
  enum class Kind : std::uint8_t { kBorder, kObstacle, kSegment };
  Kind kind = Kind::kSegment;
  std::optional<std::int64_t> obstacle;  ///< id
  std::optional<std::size_t> segment;    ///< 1-based

  /// "segment 3 of obstacle 26".
  std::string name() const;
};

/// Defects with their places as byte offsets, in any order.
class Defects {
 public:
  /// A message about the file.
  void add(FindingCode code, std::size_t offset, std::string message);

  /// A message about a record: "<subject>: <message>".
  void add(FindingCode code, std::size_t offset, const Subject& subject, std::string_view message);

  /// Gives the last message a proven repair: `replacement` instead of the bytes from `begin` up to
  /// `end`.
  void fix(std::size_t begin, std::size_t end, std::string replacement);

  /// Gives the last message a shape on the map.
  void show(DefectGeometry geometry);

  /// All of them with line and column, in the order of the text.
  std::vector<Finding> findings(std::string_view text, const TextIndex& index) &&;

 private:
  struct OffsetEdit {
    std::size_t begin, end;
    std::string replacement;
  };
  struct Defect {
    std::size_t offset;
    Finding finding;
    std::optional<OffsetEdit> fix;
  };
  std::vector<Defect> defects_;
};

/// The code and the words for a field that should be a number but reads as `status` (not kOk).
struct NumberComplaint {
  FindingCode code;
  std::string message;
  std::optional<std::string> meant = {};  ///< the number, where nothing else can be meant
};
NumberComplaint number_complaint(std::string_view field_name, std::string_view text,
                                 NumberStatus status);
NumberComplaint integer_complaint(std::string_view field_name, std::string_view text,
                                  NumberStatus status);

}  // namespace mapwright::text
