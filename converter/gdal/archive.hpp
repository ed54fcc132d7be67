// Sources packed into archives: zip files (.zip, .shz, .kmz), tar files, single gzipped files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "converter/isolation/isolated_reader.hpp"

namespace mapwright::converter {

/// True for a file that is an archive by its first bytes.
bool is_archive(const std::string& path);

/// Unpacks an archive into memory and opens every data set in it: their layers are the source's.
/// What else lies in it is named in a warning. Fails (kInput) for archives without data sets,
/// damaged ones, and those that unpack to more than memory should hold.
OpenedReader open_archive(const std::string& path, const std::vector<std::string>& drivers,
                          const DriverNotice& notice);

/// What an archive says it unpacks to, in bytes; the size of the file where it says nothing.
std::uint64_t unpacked_bytes(const std::string& path);

}  // namespace mapwright::converter
