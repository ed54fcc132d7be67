#include "cli/support/log_files.hpp"

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/number_table.hpp"
#include "navcore/logs/carmen_log.hpp"

namespace mapwright::cli {
namespace {

const std::vector<std::string> kOdometryColumns{"scan", "t", "odom_x", "odom_y", "odom_theta"};
const std::vector<std::string> kReferenceColumns{"ref_x", "ref_y", "ref_theta"};

// Nobody drives for so long; a small file that grows beyond it was made to fill the memory.
constexpr std::size_t kMostBytes = std::size_t{4} << 30U;

std::string unzipped(const std::string& bytes, const std::string& path) {
  namespace io = boost::iostreams;
  std::string text;
  try {
    io::filtering_istream in;
    in.push(io::gzip_decompressor());
    in.push(io::array_source(bytes.data(), bytes.size()));
    in.exceptions(std::ios::badbit);
    std::string piece(std::size_t{1} << 20U, '\0');
    while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
      text.append(piece, 0, static_cast<std::size_t>(in.gcount()));
      if (text.size() > kMostBytes) {
        throw Error(ExitStatus::kInput, path + ": unzips to more than 4 GB");
      }
    }
  } catch (const std::ios_base::failure&) {
    throw Error(ExitStatus::kInput,
                path + ": is cut short or damaged: it is not gzip data to its end");
  }
  return text;
}

Pose pose_at(const std::vector<double>& row, std::size_t first) {
  return {row[first], row[first + 1], Angle::from_radians(row[first + 2])};
}

}  // namespace

std::vector<navcore::RecordedScan> read_log_file(const std::string& path) {
  const std::string name(display_path(path));
  std::string text = read_file(path);
  if (text.starts_with("\x1F\x8B")) text = unzipped(text, name);
  return value_or_throw(navcore::read_carmen_log(text, name));
}

std::vector<OdometryRow> read_odometry_file(const std::string& path, std::size_t scans) {
  const std::string name(display_path(path));
  const NumberTable table = read_number_table(path, kOdometryColumns, kReferenceColumns);
  if (table.rows.size() != scans) {
    throw Error(ExitStatus::kInput, name + ": has " + std::to_string(table.rows.size()) +
                                        " rows, but the log has " + std::to_string(scans) +
                                        " scans: one row a scan is needed");
  }
  std::vector<OdometryRow> result;
  for (std::size_t i = 0; i < scans; ++i) {
    const auto& row = table.rows[i];
    if (row[0] != static_cast<double>(i)) {
      throw Error(ExitStatus::kInput, name + ":" + std::to_string(table.lines[i]) +
                                          ": the column scan must count 0, 1, 2, ...; expected " +
                                          std::to_string(i));
    }
    result.push_back({row[1], pose_at(row, 2), std::nullopt});
    if (table.has_optional) result.back().reference = pose_at(row, 5);
  }
  return result;
}

}  // namespace mapwright::cli
