// How fast a map file is validated (seconds of processor time), how much memory that takes, and how
// both grow: table over five sizes, of sound maps and of maps that must be read as a whole because
// something is found in them.
//
// Each size runs in a process of its own, so that its peak memory is its own.
// Usage: validate_bench [SEGMENTS]   (one size only; default 31,250 to 10,000,000)
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "cli/support/heap.hpp"
#include "cli/support/validated_map.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::bench {
namespace {

// Of this process, the system's share included.
double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// Above the laser, so that nothing is found, or as they are: benches are lower.
void write_campus(std::size_t segments, bool is_sound, const std::string& path) {
  const double side_m = 100.0 * std::sqrt(static_cast<double>(segments) / 520.0);
  Map map = generate_campus({side_m, segments, 1});
  for (auto& obstacle : map.obstacles) {
    if (!is_sound || obstacle.shape_type == ShapeType::kRamp ||
        obstacle.shape_type == ShapeType::kStairs) {
      continue;
    }
    for (auto& segment : obstacle.segments) segment.height_m = std::max(segment.height_m, 1.0);
  }
  std::ofstream out(path, std::ios::binary);
  write_map(map, out);
}

void measure(std::size_t segments, const std::string& path) {
  cli::keep_freed_memory();
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  const auto count = static_cast<double>(segments);
  const double start_s = cpu_seconds();
  const auto validated = cli::validated_file(path, {}, {});
  const double total_s = cpu_seconds() - start_s;
  std::cout << std::setw(10) << segments << std::fixed << std::setprecision(1) << std::setw(9)
            << megabytes << std::setw(8) << (validated.is_read ? "yes" : "no")
            << std::setprecision(3) << std::setw(9) << total_s << std::setprecision(1)
            << std::setw(9) << megabytes / total_s << std::setprecision(0) << std::setw(12)
            << 1e9 * total_s / count << std::setw(17) << peak_memory_bytes() / count
            << std::setprecision(2) << std::setw(14) << peak_memory_bytes() / (1e6 * megabytes)
            << std::setw(10) << validated.findings.size() << std::endl;
}

// In a child, since peak memory never falls.
template <class Work>
void do_apart(const Work& work) {
  std::cout.flush();
  if (fork() == 0) {
    work();
    _exit(0);
  }
  wait(nullptr);
}

void measure_apart(std::size_t segments, bool is_sound) {
  const std::string path = std::filesystem::temp_directory_path() /
                           ("validate_bench." + std::to_string(getpid()) + ".txt");
  do_apart([&] { write_campus(segments, is_sound, path); });
  do_apart([&] { measure(segments, path); });
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  using namespace mapwright::bench;
  std::cout
      << machine_description() << '\n'
      << "  segments       MB    read        s     MB/s  ns/segment  bytes/segment  memory/file"
         "  findings\n";
  std::vector<std::size_t> sizes{31'250, 125'000, 500'000, 2'000'000, 10'000'000};
  if (argc > 1) sizes = {std::strtoull(argv[1], nullptr, 10)};
  for (const bool is_sound : {true, false}) {
    for (const std::size_t segments : sizes) measure_apart(segments, is_sound);
  }
  return 0;
}
