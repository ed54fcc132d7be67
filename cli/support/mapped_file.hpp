// Large files without a copy of their bytes.
#pragma once

#include <optional>
#include <string>

#include "mapcore/text/map_text.hpp"

namespace mapwright::cli {

/// The text of a large file, mapped into memory: pages come when they are looked at, and go again
/// when they are released. Nothing for what is better read: small files, pipes, devices, folders,
/// and whatever cannot be mapped.
///
/// Where somebody cuts the file short meanwhile, the process ends with exit status 3.
std::optional<MapText> map_large_file(const std::string& path);

}  // namespace mapwright::cli
