// From the fields of one record to its values, with a defect for every field that has none.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "mapcore/map.hpp"
#include "mapcore/text/defects.hpp"
#include "mapcore/text/fields.hpp"
#include "mapcore/text/map_builder.hpp"
#include "mapcore/text/semantic_cache.hpp"

namespace mapwright::text {

inline constexpr std::size_t kHeaderFields = 4;  ///< of border and obstacle, behind the keyword
inline constexpr std::size_t kSegmentFields = 7;

class RecordValues {
 public:
  RecordValues(Defects& defects, SemanticCache& semantics)
      : defects_(defects), semantics_(semantics) {}

  /// mx1, my1, mx4, my4; nothing if one of them is unreadable.
  std::optional<Border> border(const std::array<Field, kHeaderFields>& fields);

  /// id, ST, NS, semantic. What is unreadable stays empty.
  ObstacleHeader obstacle(std::size_t offset, const std::array<Field, kHeaderFields>& fields);

  /// ax, ay, bx, by, h, inOut, semantic; nothing if one of the numbers is unreadable. An unreadable
  /// inOut reads as outdoor.
  std::optional<Segment> segment(const Subject& subject,
                                 const std::array<Field, kSegmentFields>& fields);

 private:
  std::optional<double> number(const Subject& subject, std::string_view name, const Field& field);
  std::optional<std::int64_t> integer(const Subject& subject, std::string_view name,
                                      const Field& field, std::string_view consequence);
  void shape_type(ObstacleHeader& header, const Field& field);
  void declared_segments(ObstacleHeader& header, const Field& field);
  InOut in_out(const Subject& subject, const Field& field);
  Semantic semantic(const Subject& subject, const Field& field);

  Defects& defects_;
  SemanticCache& semantics_;
};

}  // namespace mapwright::text
