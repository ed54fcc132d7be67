#include <malloc.h>
#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/support/files.hpp"

namespace {

// What one step frees, the next one takes: maps come and go as a whole, and handing their pages
// back to the system in between costs a tenth of a conversion.
void keep_freed_memory() {
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 64 << 20);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  std::ios::sync_with_stdio(false);
  mapwright::cli::remove_temporary_files_on_interrupt();
  mapwright::cli::Console console(std::cout, std::cerr, isatty(STDERR_FILENO) == 1);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto status = mapwright::cli::run_program(arguments, console);
  // An answer that did not arrive is no success, whatever it was.
  if (!std::cout.flush()) {
    console.error("standard output: cannot be written");
    return static_cast<int>(mapwright::cli::ExitStatus::kOutput);
  }
  return static_cast<int>(status);
}
