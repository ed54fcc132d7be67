#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/support/files.hpp"
#include "cli/support/heap.hpp"

int main(int argc, char** argv) {
  mapwright::cli::keep_freed_memory();
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
