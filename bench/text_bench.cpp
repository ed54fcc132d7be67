// Reading and writing map text beside what the standard library offers.
//
// Usage: text_bench [SEGMENTS]   (default 1,300,000: some 80 MB)
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/timing.hpp"
#include "mapcore/text/decimal_format.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::bench {
namespace {

/// The peer most programs would write: stream extraction field by field.
class StreamReader {
 public:
  explicit StreamReader(const std::string& text) : in_(text) {}

  Map read() {
    Map map;
    std::string keyword;
    while (std::getline(in_ >> std::ws, keyword, ';')) {
      if (keyword == "border") {
        map.border = {number(), number(), number(), number()};
        end();
      } else {
        map.obstacles.push_back(obstacle());
      }
    }
    return map;
  }

 private:
  double number() {
    double value = 0.0;
    char semicolon = 0;
    in_ >> value >> semicolon;
    return value;
  }

  Semantic semantic() {
    std::string text;
    std::getline(in_, text, ';');
    return text;
  }

  void end() {
    char hash = 0;
    in_ >> hash;
  }

  Obstacle obstacle() {
    Obstacle result;
    result.id = static_cast<std::int64_t>(number());
    result.shape_type = static_cast<ShapeType>(static_cast<int>(number()));
    result.segments.resize(static_cast<std::size_t>(number()));
    result.semantic = semantic();
    end();
    for (auto& segment : result.segments) {
      segment.a = {number(), number()};
      segment.b = {number(), number()};
      segment.height_m = number();
      segment.in_out = number() == 0.0 ? InOut::kIndoor : InOut::kOutdoor;
      segment.semantic = semantic();
      end();
    }
    return result;
  }

  std::istringstream in_;
};

/// The peer of somebody who found streams slow: fields by getline, numbers by std::stod.
class LineReader {
 public:
  explicit LineReader(const std::string& text) : in_(text) {}

  Map read() {
    Map map;
    while (std::getline(in_ >> std::ws, field_, ';')) {
      if (field_ == "border") {
        map.border = {number(), number(), number(), number()};
        end();
      } else {
        map.obstacles.push_back(obstacle());
      }
    }
    return map;
  }

 private:
  double number() {
    std::getline(in_, field_, ';');
    return std::stod(field_);
  }

  Semantic semantic() {
    std::getline(in_, field_, ';');
    return field_;
  }

  void end() { std::getline(in_, field_, '#'); }

  Obstacle obstacle() {
    Obstacle result;
    result.id = static_cast<std::int64_t>(number());
    result.shape_type = static_cast<ShapeType>(static_cast<int>(number()));
    result.segments.resize(static_cast<std::size_t>(number()));
    result.semantic = semantic();
    end();
    for (auto& segment : result.segments) {
      segment.a = {number(), number()};
      segment.b = {number(), number()};
      segment.height_m = number();
      segment.in_out = number() == 0.0 ? InOut::kIndoor : InOut::kOutdoor;
      segment.semantic = semantic();
      end();
    }
    return result;
  }

  std::istringstream in_;
  std::string field_;
};

std::string write_with_stream(const Map& map) {
  std::ostringstream out;
  out << std::setprecision(10);
  const Border& border = map.border;
  out << "border;\n" << border.left << ';' << border.top << ";\n";
  out << border.right << ';' << border.bottom << ";\n#\n";
  for (const auto& obstacle : map.obstacles) {
    out << "obstacle;\n" << obstacle.id << ';' << static_cast<int>(obstacle.shape_type) << ';';
    out << obstacle.segments.size() << ';' << obstacle.semantic.view() << ";\n#\n";
    for (const auto& segment : obstacle.segments) {
      out << segment.a.x << ';' << segment.a.y << ";\n" << segment.b.x << ';' << segment.b.y;
      out << ";\n" << segment.height_m << ';' << static_cast<int>(segment.in_out) << ';';
      out << segment.semantic.view() << ";\n#\n";
    }
  }
  return std::move(out).str();
}

void report(const std::string& what, double megabytes, double seconds, double baseline_seconds) {
  std::cout << "  " << std::left << std::setw(26) << what << std::right << std::fixed
            << std::setprecision(0) << std::setw(6) << megabytes / seconds << " MB/s"
            << std::setprecision(1) << std::setw(8) << baseline_seconds / seconds << " x\n";
}

[[noreturn]] void disagree(const std::string& who) {
  std::cerr << who << " gives another answer than ours: nothing to compare\n";
  std::exit(1);
}

// Reading alone: neither copying the text nor throwing the map away.
template <class Prepare, class Read>
double reading_seconds(Prepare&& prepare, Read&& read) {
  constexpr int kRuns = 5;
  std::optional<decltype(read(prepare()))> result;
  const auto reset_and_prepare = [&] {
    result.reset();
    return prepare();
  };
  return median_seconds(kRuns, reset_and_prepare,
                        [&](auto input) { result.emplace(read(std::move(input))); });
}

void bench_reading(const std::string& text) {
  const double megabytes = static_cast<double>(text.size()) / 1e6;
  const Map expected = read_map(text).map;
  if (!(StreamReader(text).read() == expected)) disagree("the stream reader");
  if (!(LineReader(text).read() == expected)) disagree("the line reader");
  const double stream = reading_seconds([&] { return StreamReader(text); },
                                        [](StreamReader reader) { return reader.read(); });
  const double line = reading_seconds([&] { return LineReader(text); },
                                      [](LineReader reader) { return reader.read(); });
  const double ours = reading_seconds([&] { return text; },
                                      [](std::string copy) { return read_map(std::move(copy)); });
  std::cout << "read " << std::fixed << std::setprecision(1) << megabytes << " MB\n";
  report("std::istream >>", megabytes, stream, stream);
  report("std::getline, std::stod", megabytes, line, stream);
  report("read_map", megabytes, ours, stream);
}

void bench_writing(const Map& map) {
  constexpr int kRuns = 5;
  const std::string text = format_map(map);
  if (write_with_stream(map) != text) disagree("the stream writer");
  const double megabytes = static_cast<double>(text.size()) / 1e6;
  const double stream = median_seconds(3, [&] { write_with_stream(map); });
  const double ours = median_seconds(kRuns, [&] { format_map(map); });
  std::cout << "write the same\n";
  report("std::ostream <<", megabytes, stream, stream);
  report("format_map", megabytes, ours, stream);
}

void bench_numbers(const Map& map) {
  std::vector<double> numbers;
  for (const auto& obstacle : map.obstacles) {
    for (const auto& segment : obstacle.segments) {
      numbers.insert(numbers.end(), {segment.a.x, segment.a.y, segment.b.x, segment.b.y});
    }
  }
  const text::DecimalFormat format(0.001);
  char buffer[text::DecimalFormat::kMaxCharacters];
  std::size_t characters = 0;
  const double seconds = median_seconds(5, [&] {
    for (const double number : numbers) {
      characters += static_cast<std::size_t>(format.write(buffer, number) - buffer);
    }
  });
  std::cout << "numbers alone: " << std::setprecision(0)
            << static_cast<double>(numbers.size()) / seconds / 1e6 << " million/s (" << characters
            << " characters)\n";
}

int run(std::size_t segments) {
  std::cout << machine_description();
  const double side_m = 100.0 * std::sqrt(static_cast<double>(segments) / 520.0);
  const Map map = generate_campus({side_m, segments, 1});
  bench_reading(format_map(map));
  bench_writing(map);
  bench_numbers(map);
  return 0;
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  return mapwright::bench::run(argc > 1 ? std::stoul(argv[1]) : 1'300'000);
}
