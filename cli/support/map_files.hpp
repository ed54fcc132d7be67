// Maps and their sidecars, read by the rules of docs/cli.md.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mapcore/georeference.hpp"
#include "mapcore/result.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright::cli {

/// The text of a map, from a file or from standard input ("-"); large files are mapped. Throws
/// Error (kInput) where the file cannot be read.
MapText read_map_text(const std::string& path);

/// Reads a map from a file or from standard input ("-"). Throws Error (kInput) where the file
/// cannot be read; defects of its text are findings of the document.
MapDocument read_map_file(const std::string& path);

/// Keeps a document, or what else is large, until the process ends, which then gives back its
/// memory at once: millions of pieces one by one would cost a tenth of the time it took to read
/// them.
void keep_to_the_end(std::shared_ptr<const void> kept);

/// The georeference beside a map; nothing where there is no sidecar, or the map is standard input.
/// Failure: the sidecar makes no sense. Throws Error (kInput) where it cannot be read.
Result<std::optional<Georeference>> read_sidecar(const std::string& map_path);

/// The same for verbs whose answer a robot relies on: defects of the text of severity error
/// (records that could not be understood and are missing from the map) are an Error (kInput) that
/// names the first.
MapDocument read_sound_map_file(const std::string& path);

/// The sidecar of a map that is written somewhere else: paths of sources are relative to it.
Georeference moved(Georeference georeference, const std::string& from_map,
                   const std::string& to_map);

}  // namespace mapwright::cli
