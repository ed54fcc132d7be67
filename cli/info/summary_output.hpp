// The two forms of `info`'s answer.
#pragma once

#include <optional>
#include <ostream>
#include <string_view>

#include "cli/info/map_summary.hpp"

namespace mapwright::cli {

/// For people: a line a subject.
void write_summary_text(std::ostream& out, std::string_view path, const MapSummary& summary,
                        const std::optional<Georeference>& georeference);

/// "schema": "mapwright.info/1"; keys as docs/cli.md has them.
void write_summary_json(std::ostream& out, std::string_view path, const MapSummary& summary,
                        const std::optional<Georeference>& georeference);

}  // namespace mapwright::cli
