// A map file and what validation finds in it.
#pragma once

#include <string>
#include <vector>

#include "mapcore/progress.hpp"
#include "mapcore/text/document.hpp"
#include "validators/validator.hpp"

namespace mapwright::cli {

struct ValidatedMap {
  MapDocument document;           ///< without its obstacles and places where `is_read` is false
  std::vector<Finding> findings;  ///< of its text and of the checks
  bool is_read = true;            ///< false: nothing was found, and one look was enough to tell
};

/// Finds all that is wrong in a text, and makes a map of it only where that is needed: where
/// something may be wrong, or (`needs_sources`) where obstacles name the features they come from.
/// `progress` counts KiB looked at, then KiB read, then checks.
ValidatedMap validated_text(MapText text, const validators::ValidationOptions& options,
                            const Progress& progress, bool needs_sources = false);

/// The same for a file, or for standard input ("-"). Throws Error (kInput) where it cannot be read.
ValidatedMap validated_file(const std::string& path, const validators::ValidationOptions& options,
                            const Progress& progress, bool needs_sources = false);

}  // namespace mapwright::cli
