// Private to the exporters of findings: findings as rows of tables.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "converter/exporters/findings.hpp"

namespace mapwright::converter {

enum class FindingPart : std::uint8_t { kPoints, kLines, kAreas };

/// In which coordinates findings are written.
enum class FindingFrame : std::uint8_t { kMetres, kMapFrame, kWgs84 };

/// The frame that suits all maps; `only_wgs84`: the format has no other georeferenced one.
FindingFrame frame_of(const std::vector<MapFindings>& maps, bool only_wgs84);

/// One kind of a finding's geometry. Points: paths of one point each. Areas: rings,
/// counter-clockwise, the first point repeated at the end.
struct FindingRow {
  std::size_t number = 0;  ///< of the finding, from 1, over all maps
  const MapFindings* map = nullptr;
  const Finding* finding = nullptr;
  FindingPart part = FindingPart::kPoints;
  std::vector<std::vector<Point>> paths;  ///< empty: has no place
};

/// The rows of all maps: of each finding one of kPoints, and one of kLines and kAreas where it has
/// such.
std::vector<FindingRow> finding_rows(const std::vector<MapFindings>& maps, FindingFrame frame);

using FindingValue = std::variant<std::monostate, std::int64_t, double, std::string>;

struct FindingColumn {
  std::string_view name;
  enum class Type : std::uint8_t { kInteger, kReal, kText } type;
};

/// The columns, and a row's values for them.
inline constexpr std::array<FindingColumn, 13> kFindingColumns{
    {{"finding", FindingColumn::Type::kInteger},
     {"map", FindingColumn::Type::kText},
     {"code", FindingColumn::Type::kText},
     {"name", FindingColumn::Type::kText},
     {"severity", FindingColumn::Type::kText},
     {"message", FindingColumn::Type::kText},
     {"line", FindingColumn::Type::kInteger},
     {"column", FindingColumn::Type::kInteger},
     {"x", FindingColumn::Type::kReal},
     {"y", FindingColumn::Type::kReal},
     {"obstacle", FindingColumn::Type::kInteger},
     {"segment", FindingColumn::Type::kInteger},
     {"source", FindingColumn::Type::kText}}};
std::array<FindingValue, kFindingColumns.size()> values_of(const FindingRow& row);

}  // namespace mapwright::converter
