#include "navcore/logs/carmen_log.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "mapcore/text/characters.hpp"

namespace mapwright::navcore {
namespace {

constexpr std::size_t kMostBeams = 100'000;

/// What is wrong with a line; caught by read_carmen_log.
struct LineMistake {
  std::string message;
};

/// The fields of one line, from left to right.
class Fields {
 public:
  explicit Fields(std::string_view line) : rest_(line) {}

  std::string_view word(std::string_view what) {
    rest_ = text::trimmed(rest_);
    if (rest_.empty()) throw LineMistake{"the line ends before " + std::string(what)};
    const std::string_view field = rest_.substr(0, rest_.find_first_of(" \t"));
    rest_.remove_prefix(field.size());
    return field;
  }

  double number(std::string_view what) {
    const std::string_view field = word(what);
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size()) {
      throw LineMistake{std::string(what) + ": " + text::quoted(field) + " is not a number"};
    }
    return value;
  }

  double finite_number(std::string_view what) {
    const double value = number(what);
    if (std::isfinite(value)) return value;
    throw LineMistake{std::string(what) + " is not finite"};
  }

  std::size_t count(std::string_view what) {
    const double value = number(what);
    if (value >= 0.0 && value <= double{kMostBeams} && value == std::floor(value)) {
      return static_cast<std::size_t>(value);
    }
    throw LineMistake{std::string(what) + " is no whole number from 0 to 100000"};
  }

  Pose pose(std::string_view what) {
    const double x = finite_number(what);
    const double y = finite_number(what);
    return {x, y, Angle::from_radians(finite_number(what))};
  }

  void skip(std::size_t fields, std::string_view what) {
    for (std::size_t i = 0; i < fields; ++i) word(what);
  }

  /// How many are left.
  std::size_t left() const {
    std::size_t count = 0;
    for (Fields rest = *this; !text::trimmed(rest.rest_).empty(); ++count) rest.word("a field");
    return count;
  }

 private:
  std::string_view rest_;
};

std::vector<double> read_ranges(Fields& fields, std::size_t count, std::optional<double> limit_m) {
  std::vector<double> ranges(count);
  for (double& range : ranges) {
    range = fields.number("the last of its ranges");
    if (is_no_return(range, limit_m)) range = std::numeric_limits<double>::infinity();
  }
  return ranges;
}

void require_beams(std::size_t count) {
  if (count < 2) throw LineMistake{"a scan of fewer than 2 beams"};
}

// A scan with a wrong number of ranges would take some of them for the pose, or the other way
// round. What follows the time, the host and the logger's time, may be missing as a whole.
void require_flaser_fields(const Fields& after_count, std::size_t beams) {
  constexpr std::size_t kUpToTime = 7, kAll = 9;
  const std::size_t left = after_count.left();
  if (left == beams + kAll || left <= beams + kUpToTime) return;  // too short a line says where
  throw LineMistake{std::to_string(beams) + " ranges and what follows them are " +
                    std::to_string(beams + kAll) + " fields, but here are " + std::to_string(left) +
                    "; is the number of ranges wrong?"};
}

// CARMEN's laser module: 180 and 360 beams leave the last one of half a turn out.
RecordedFan flaser_fan(std::size_t beams) {
  const std::size_t steps = beams % 2 == 0 ? beams : beams - 1;
  return {beams, Angle::from_degrees(-90.0),
          Angle::from_degrees(180.0 / static_cast<double>(steps))};
}

RecordedScan read_flaser(Fields& fields) {
  RecordedScan scan;
  const std::size_t beams = fields.count("the number of ranges");
  require_beams(beams);
  require_flaser_fields(fields, beams);
  scan.fan = flaser_fan(beams);
  scan.ranges = read_ranges(fields, beams, std::nullopt);
  fields.pose("the laser's pose");
  scan.odometry = fields.pose("the odometry");
  scan.time_s = fields.finite_number("the time");
  return scan;
}

RecordedScan read_robotlaser(Fields& fields) {
  RecordedScan scan;
  fields.word("the laser's type");
  const Angle first = Angle::from_radians(fields.finite_number("the start angle"));
  fields.finite_number("the field of view");
  const Angle step = Angle::from_radians(fields.finite_number("the angular resolution"));
  if (!(step.radians() > 0.0)) throw LineMistake{"the angular resolution is not above 0"};
  const double limit_m = fields.finite_number("the maximum range");
  fields.skip(2, "the number of ranges");
  const std::size_t beams = fields.count("the number of ranges");
  require_beams(beams);
  scan.fan = {beams, first, step};
  scan.ranges = read_ranges(fields, beams, limit_m);
  fields.skip(fields.count("the number of remissions"), "the last of its remissions");
  const Pose laser = fields.pose("the laser's pose");
  scan.odometry = fields.pose("the robot's pose");
  // A laser that looks another way than the robot turns the fan; its offset is left out.
  scan.fan.first = scan.fan.first + (laser.theta - scan.odometry.theta).wrapped();
  fields.skip(5, "the time");
  scan.time_s = fields.finite_number("the time");
  return scan;
}

bool is_message_name(std::string_view word) {
  if (word.empty() || !(word.front() >= 'A' && word.front() <= 'Z')) return false;
  return word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == word.npos;
}

std::optional<RecordedScan> read_line(std::string_view line) {
  line = text::trimmed(line);
  if (line.empty() || line.front() == '#') return std::nullopt;
  Fields fields(line);
  const std::string_view message = fields.word("a message");
  if (message == "FLASER") return read_flaser(fields);
  if (message == "ROBOTLASER1") return read_robotlaser(fields);
  if (is_message_name(message)) return std::nullopt;
  throw LineMistake{text::quoted(message) + " is no CARMEN message"};
}

tl::unexpected<Failure> failure_at(std::string_view name, std::size_t line,
                                   const std::string& what) {
  return input_failure(std::string(name) + ":" + std::to_string(line) + ": " + what);
}

}  // namespace

Result<std::vector<RecordedScan>> read_carmen_log(std::string_view text, std::string_view name) {
  if (text.starts_with(text::kByteOrderMark)) text.remove_prefix(text::kByteOrderMark.size());
  std::vector<RecordedScan> scans;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    try {
      if (auto scan = read_line(text.substr(0, end))) {
        scan->line = number;
        scans.push_back(*std::move(scan));
      }
    } catch (const LineMistake& mistake) {
      return failure_at(name, number, mistake.message);
    }
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  if (scans.empty()) {
    return input_failure(std::string(name) + ": holds no scan (no FLASER, no ROBOTLASER1)");
  }
  return scans;
}

}  // namespace mapwright::navcore
