// The scripts of docs/recipes/slurm, run as Slurm runs them, without Slurm.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/cli/map_folder.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
namespace fs = std::filesystem;

class SlurmRecipe : public testing::Test {
 protected:
  SlurmRecipe() { fs::create_directories(out_); }

  // Exit status of a script; `environment` stands before it, as in a shell.
  int script(const std::string& name, const std::string& arguments,
             const std::string& environment = "") const {
    const std::string path = project_file("docs/recipes/slurm/" + name).string();
    const std::string command = "MAPWRIGHT='" + program_ + "' " + environment + " '" + path + "' " +
                                arguments + " >'" + folder_.path("log") + "' 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int task(int part, const std::string& more = "--trials 0 --plans 2") const {
    return script("part.sh", "'" + maps_ + "' '" + out_ + "' 3 " + more,
                  "SLURM_ARRAY_TASK_ID=" + std::to_string(part));
  }
  std::string log() const { return text_of(folder_.path("log")); }

  TemporaryFolder folder_;
  std::string program_ = MAPWRIGHT_PROGRAM;
  std::string maps_ = make_map_folder(folder_, 9);
  std::string out_ = folder_.path("out");
};

TEST_F(SlurmRecipe, TasksAndMergeGiveTheReportOfOneRun) {
  for (int part = 1; part <= 3; ++part) EXPECT_EQ(task(part), 0) << log();
  EXPECT_EQ(script("merge.sh", "'" + out_ + "' 3"), 1) << log();
  EXPECT_EQ(text_of(out_ + "/report.txt"),
            run({"check", maps_, "--trials", "0", "--plans", "2"}).out);
  EXPECT_NE(text_of(out_ + "/report.json").find("mapwright.check/1"), std::string::npos);
}

TEST_F(SlurmRecipe, ATaskThatIsRequeuedGoesOn) {
  EXPECT_EQ(task(1), 0);
  const std::string part = out_ + "/part-1-of-3.json";
  const std::string first = text_of(part);
  fs::remove(part);
  EXPECT_EQ(task(1), 0);
  EXPECT_NE(log().find("are done already"), std::string::npos) << log();
  EXPECT_EQ(text_of(part), first);
}

TEST_F(SlurmRecipe, MistakesStopIt) {
  EXPECT_EQ(task(1, "--no-such-option"), 2) << log();
  EXPECT_EQ(task(4), 2) << log();
  EXPECT_EQ(script("part.sh", "'" + maps_ + "' '" + out_ + "' 3"), 1) << log();
  EXPECT_EQ(task(1), 0);
  EXPECT_EQ(script("merge.sh", "'" + out_ + "' 3"), 3) << log();  // parts 2 and 3 are not there
}

}  // namespace
}  // namespace mapwright
