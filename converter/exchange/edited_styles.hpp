// Heights, in/out and semantics of an exported obstacle's segments, as its fields have them now.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converter/pipeline/draft.hpp"

namespace mapwright::converter {

/// Value of a field by name.
using FieldText = std::function<std::optional<std::string>(std::string_view)>;

struct EditedStyles {
  std::vector<SegmentStyle> styles;  ///< a segment each
  bool height_is_missing = false;    ///< the default stands in
  bool altered = false;              ///< characters that the format reserves were replaced
};

/// Styles of `count` segments. The lists `heights`, `in_outs` and `seg_sems` count as long as the
/// field they belong to (height, in_out, segment_semantic) still says what follows from them: an
/// edited field counts for all segments. Segments beyond the runs take the last run's values.
EditedStyles edited_styles(const FieldText& field, std::size_t count, double default_height_m);

}  // namespace mapwright::converter
