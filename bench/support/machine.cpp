#include "bench/support/machine.hpp"

#include <fstream>
#include <thread>

namespace mapwright::bench {
namespace {

// Linux names the processor here; elsewhere it stays unnamed.
std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const auto colon = line.find(": ");
    if (colon != line.npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string compiler_name() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown compiler";
#endif
}

}  // namespace

std::string machine_description() {
  return "processor: " + processor_name() + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " cores\n" +
         "compiler: " + compiler_name() +
         ", " MAPWRIGHT_BUILD_TYPE ", " MAPWRIGHT_COMPILER_FLAGS "\n";
}

}  // namespace mapwright::bench
