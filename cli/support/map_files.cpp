#include "cli/support/map_files.hpp"

#include "cli/support/files.hpp"
#include "mapcore/text/reader.hpp"

namespace mapwright::cli {

MapDocument read_map_file(const std::string& path) { return read_map(read_file(path)); }

}  // namespace mapwright::cli
