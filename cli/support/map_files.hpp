// Maps and their sidecars, read by the rules of docs/cli.md.
#pragma once

#include <string>

#include "mapcore/text/document.hpp"

namespace mapwright::cli {

/// Reads a map from a file or from standard input ("-"). Throws Error (kInput) where the file cannot
/// be read; defects of its text are findings of the document.
MapDocument read_map_file(const std::string& path);

}  // namespace mapwright::cli
