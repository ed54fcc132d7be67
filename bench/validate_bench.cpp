// How fast a map is validated (seconds of processor time), and how the cost grows: table over four
// sizes.
//
// Each size runs in a process of its own, so that its peak memory is its own.
// Usage: validate_bench [SEGMENTS]   (one size only; default 31,250 to 2,000,000)
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "validators/validator.hpp"

namespace mapwright::bench {
namespace {

// Of this one thread: what an idle core would take.
double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// The generated map would count as memory: it is written by a child process.
std::string campus_text(std::size_t segments) {
  std::array<int, 2> pipe_ends{};
  if (pipe(pipe_ends.data()) != 0) std::exit(1);
  if (fork() == 0) {
    const double side_m = 100.0 * std::sqrt(static_cast<double>(segments) / 520.0);
    const std::string text = format_map(generate_campus({side_m, segments, 1}));
    for (std::size_t at = 0; at < text.size();) {
      const auto written = write(pipe_ends[1], text.data() + at, text.size() - at);
      if (written <= 0) _exit(1);
      at += static_cast<std::size_t>(written);
    }
    _exit(0);
  }
  close(pipe_ends[1]);
  std::string text;
  text.reserve(64 * segments);
  std::array<char, 1U << 16U> buffer;
  for (ssize_t got = 0; (got = read(pipe_ends[0], buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  close(pipe_ends[0]);
  wait(nullptr);
  text.shrink_to_fit();
  return text;
}

void measure(std::size_t segments) {
  std::string text = campus_text(segments);
  const double megabytes = static_cast<double>(text.size()) / 1e6;
  const double start_s = cpu_seconds();
  const MapDocument document = read_map(std::move(text));
  const double read_s = cpu_seconds() - start_s;
  const auto findings = validators::validate(document);
  const double total_s = cpu_seconds() - start_s;
  std::cout << std::setw(10) << segments << std::fixed << std::setprecision(1) << std::setw(9)
            << megabytes << std::setprecision(3) << std::setw(9) << read_s << std::setw(9)
            << total_s << std::setprecision(1) << std::setw(9) << megabytes / total_s
            << std::setprecision(0) << std::setw(12)
            << 1e9 * total_s / static_cast<double>(segments) << std::setprecision(2)
            << std::setw(14) << 1.048576 * peak_memory_mb() / megabytes << std::setw(10)
            << findings.size() << std::endl;
}

// In a child, since peak memory never falls.
void measure_apart(std::size_t segments) {
  std::cout.flush();
  if (fork() == 0) {
    measure(segments);
    _exit(0);
  }
  wait(nullptr);
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  using namespace mapwright::bench;
  std::cout
      << machine_description() << '\n'
      << "  segments       MB   read s  total s     MB/s  ns/segment  memory/file  findings\n";
  if (argc > 1) {
    measure_apart(std::strtoull(argv[1], nullptr, 10));
    return 0;
  }
  for (const std::size_t segments : {31'250, 125'000, 500'000, 2'000'000}) measure_apart(segments);
  return 0;
}
