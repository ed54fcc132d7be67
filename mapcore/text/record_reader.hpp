// Reads any record, well-formed or damaged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mapcore/text/defects.hpp"
#include "mapcore/text/fields.hpp"
#include "mapcore/text/map_builder.hpp"
#include "mapcore/text/record_values.hpp"
#include "mapcore/text/semantic_cache.hpp"

namespace mapwright::text {

/// Reads what stands between two '#': one record, or several whose '#' got lost. Reports every
/// defect and hands on what can be understood (docs/format.md, "What the reader recovers").
class RecordReader {
 public:
  /// `is_cut`: the text goes on with bytes that are no text; what they cut off is not reported.
  RecordReader(std::string_view text, bool is_cut, MapBuilder& builder, Defects& defects,
               SemanticCache& semantics)
      : text_(text),
        is_cut_(is_cut),
        builder_(builder),
        defects_(defects),
        values_(defects, semantics) {}

  /// Reads from `at` to the next '#'; returns the offset behind it.
  std::size_t read(std::size_t at);

 private:
  enum class Kind : std::uint8_t { kBorder, kObstacle, kSegment };

  /// Fields that belong together: from where a record begins to the next keyword or '#'.
  struct Run {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t closed_fields = 0;
    Field tail;            ///< what stands behind the last ';', mostly nothing
    bool has_end = false;  ///< a '#' or a keyword follows, not the end of the text
  };

  /// How a run begins, keyword and stray text passed.
  struct Opening {
    Kind kind = Kind::kSegment;
    std::size_t offset = 0;  ///< of the keyword, or of the first field of a segment
    std::size_t fields = 0;  ///< where the values begin
    std::size_t count = 0;   ///< closed fields from there on
    Field tail;              ///< of the run, without the keyword
  };

  Run run_at(std::size_t at, std::size_t end, bool has_end) const;
  void read_run(const Run& run);

  Opening opening_of(const Run& run);
  Opening keyword_opening(const Run& run, const Field& first, Kind kind, std::string_view word);
  std::optional<Opening> misspelt_opening(const Run& run, const Field& first);
  Opening segment_opening(const Run& run, const Field& first);

  bool are_records(const Opening& opening, std::size_t end, std::size_t fields) const;
  std::size_t read_sequence(const Opening& opening, std::size_t end, std::size_t fields);
  void read_record(Kind kind, std::size_t offset, FieldWalker& walker);
  void read_with_semantic(const Opening& opening, std::size_t end, const Field& semantic);

  void read_miscounted(const Run& run, const Opening& opening);
  bool read_without_semantic(const Run& run, const Opening& opening, std::size_t fields);
  bool read_with_split_semantic(const Run& run, const Opening& opening, std::size_t fields);
  void read_unfinished(const Run& run, const Opening& opening);
  void leave_out(const Opening& opening);

  bool is_closed(const Run& run) const;
  void report_missing_end(std::size_t at);
  void report_stray(const Field& field);
  void report_count(const Opening& opening, std::size_t fields, std::string_view consequence);
  Subject subject(Kind kind) const;

  std::string_view text_;
  bool is_cut_;
  MapBuilder& builder_;
  Defects& defects_;
  RecordValues values_;
};

}  // namespace mapwright::text
