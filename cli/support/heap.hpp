// How the program asks the system for memory.
#pragma once

#include <cstddef>

namespace mapwright::cli {

/// Keeps what has been freed for what comes next: maps come and go as a whole, and handing their
/// pages back to the system in between costs a tenth of a conversion. Call first of all.
void keep_freed_memory();

/// Prepares the heap for `bytes` more, in huge pages where the system has them: asking for them
/// page by page costs as much as reading a map. Takes no memory by itself; without effect where
/// less than that is free to take.
void expect_memory(std::size_t bytes);

/// The same for a map whose text has so many bytes.
void expect_map_of(std::size_t text_bytes);

}  // namespace mapwright::cli
