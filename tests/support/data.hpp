// Where tests find files.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace mapwright::test {

/// A file of the project, by its path from the project's root.
inline std::filesystem::path project_file(const std::string& relative) {
  return std::filesystem::path(MAPWRIGHT_SOURCE_DIR) / relative;
}

/// Folder of the real data (environment variable MAPWRIGHT_TEST_DATA, or ../shared/data beside the
/// project); it may be absent.
inline std::filesystem::path real_data_folder() {
  if (const char* folder = std::getenv("MAPWRIGHT_TEST_DATA")) return folder;
  return std::filesystem::path(MAPWRIGHT_SOURCE_DIR).parent_path() / "shared" / "data";
}

inline std::filesystem::path real_data(const std::string& relative) {
  return real_data_folder() / relative;
}

}  // namespace mapwright::test

/// Skips the running test where the real data is absent.
#define MAPWRIGHT_REQUIRE_REAL_DATA(relative)                                              \
  if (!std::filesystem::exists(mapwright::test::real_data(relative)))                      \
  GTEST_SKIP() << "needs real data " << mapwright::test::real_data(relative).string()      \
               << " (set MAPWRIGHT_TEST_DATA to its folder)"
