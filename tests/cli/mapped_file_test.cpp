// Large files are mapped, not read: the same bytes, found again after they were let go.
#include "cli/support/mapped_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "tests/cli/program_run.hpp"

namespace mapwright::cli {
namespace {

using test::TemporaryFolder;

constexpr std::size_t kLarge = std::size_t{9} << 20U;

std::string text_of(std::size_t bytes) {
  std::string text(bytes, ' ');
  for (std::size_t i = 0; i < bytes; ++i) text[i] = static_cast<char>('a' + i * i % 23);
  return text;
}

TEST(MappedFile, HoldsTheBytesAndANulBehindThem) {
  const TemporaryFolder folder;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  for (const std::size_t bytes : {kLarge, kLarge + 1, kLarge + page - 1}) {
    const std::string text = text_of(bytes);
    const auto mapped = map_large_file(folder.file("map.txt", text));
    ASSERT_TRUE(mapped.has_value());
    EXPECT_TRUE(mapped->view() == text);
    EXPECT_EQ(mapped->view().data()[bytes], '\0');
  }
}

TEST(MappedFile, HasBytesThatWereLetGo) {
  const TemporaryFolder folder;
  const std::string text = text_of(kLarge);
  const auto mapped = map_large_file(folder.file("map.txt", text));
  for (std::size_t at = 0; at < kLarge; at += 1U << 20U) mapped->release(at, at + (1U << 20U));
  EXPECT_TRUE(mapped->view() == text);
}

TEST(MappedFile, IsNoSmallFileFolderOrMissingFile) {
  const TemporaryFolder folder;
  EXPECT_FALSE(map_large_file(folder.file("map.txt", "border;0;1;1;0;#")).has_value());
  EXPECT_FALSE(map_large_file(folder.path("")).has_value());
  EXPECT_FALSE(map_large_file(folder.path("none.txt")).has_value());
  EXPECT_FALSE(map_large_file("-").has_value());
}

// Looks at the end of a file that somebody has cut short.
void look_at_cut_file() {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", text_of(kLarge));
  const auto mapped = map_large_file(path);
  if (::truncate(path.c_str(), 100) != 0) ::_exit(9);
  const auto found = std::count(mapped->view().begin(), mapped->view().end(), 'a');
  ::_exit(found > 0 ? 7 : 8);
}

TEST(MappedFileDeathTest, EndsTheProgramWhenItIsCutShort) {
  EXPECT_EXIT(look_at_cut_file(), testing::ExitedWithCode(3), "a file became shorter");
}

TEST(MappedFile, IsValidatedAsASmallOne) {
  std::string text = "border;-9;999;999;-9;#\n";
  for (int id = 1; text.size() < (2U << 20U); ++id) {
    const std::string x = std::to_string(2 * (id % 400)), y = std::to_string(1 + id / 400);
    text += "obstacle;" + std::to_string(id) + ";2;1;wall;#\n" + x + ";" + y + ";" + x + ".5;" + y +
            ";3;1;;#\n";
  }
  const std::size_t lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  text += "obstacle;0;2;1;wall;#\n-8;8;-8;8;3;1;;#\n";
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", text);
  const auto result = test::run({"validate", path});
  EXPECT_EQ(result.status, 1);
  const std::string place = path + ":" + std::to_string(lines + 2) + ":1: error: ";
  EXPECT_NE(result.out.find(place), std::string::npos) << result.out.substr(0, 500);
  EXPECT_NE(result.out.find("  -8;8;-8;8;3;1;;#\n"), std::string::npos);
}

}  // namespace
}  // namespace mapwright::cli
