// A folder of small maps of all fates.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright::test {

/// 10 m × 10 m with a box in the middle: fit.
inline std::string fit_map_text(double shift_m = 0.0) {
  return format_map(map10({box(1, 4 + shift_m, 4, 6 + shift_m, 6)}));
}

/// All of it one box, so that the robot can stand nowhere: not fit, and quick to check whatever the
/// numbers of plans and trials.
inline std::string full_map_text() {
  return format_map(map10({box(1, 0, 0, 10, 10)}));
}

inline std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// `count` maps m00.txt … in `folder`/maps: fit ones, full ones, ones with defects that findings
/// quote (one not in UTF-8), one of them no map at all.
inline std::string make_map_folder(const TemporaryFolder& folder, int count) {
  std::filesystem::create_directories(folder.path("maps"));
  for (int i = 0; i < count; ++i) {
    std::string text = fit_map_text(0.1 * i);
    if (i % 5 == 1) text = full_map_text();
    if (i % 5 == 2) text.insert(text.find("building"), "\xE9t\xE9;;oops,");
    if (i % 5 == 3) text.replace(text.find("4.") + 1, 1, ",");
    if (i == 4) text = "no map";
    folder.file("maps/m" + std::to_string(i / 10) + std::to_string(i % 10) + ".txt", text);
  }
  return folder.path("maps");
}

}  // namespace mapwright::test
