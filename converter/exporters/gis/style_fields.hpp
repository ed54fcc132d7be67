// Private to this folder: heights, in/out and semantics of segments as fields.
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "converter/source/feature.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

using NamedValue = std::pair<std::string_view, FieldValue>;

/// True if height, in/out and semantic string are the same.
bool same_style(const Segment& p, const Segment& q);

/// height (the greatest), in_out and segment_semantic (of the first segment); where segments differ
/// also runs (how many segments in a row are alike) and, of what differs, heights, in_outs and
/// seg_sems: a value a run, with ';' between them.
std::vector<NamedValue> style_fields(std::span<const Segment> segments);

}  // namespace mapwright::converter
