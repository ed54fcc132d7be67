// Readers of sources in processes of their own: a crash, a hang or a greed for memory of a format's
// driver is then an input that cannot be read, with a message that names file and driver.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// Told by an opening reader which driver is at work, so that a crash can be laid at its door.
using DriverNotice = std::function<void(const std::string& driver)>;

/// Opens the source; runs in the process that reads it.
using ReaderOpener = std::function<OpenedReader(const DriverNotice& notice)>;

/// Opens a source in a process of its own and reads it from there. `path` is for messages;
/// `source_bytes` is what there is to read, unpacked: time and memory allowed grow with it. The
/// reader's order, values and messages are those of the opener's.
OpenedReader open_isolated(const std::string& path, std::uint64_t source_bytes,
                           const ReaderOpener& open);

}  // namespace mapwright::converter
