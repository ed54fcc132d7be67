#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "mapcore/georeference.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"

namespace mapwright {
namespace {

namespace fs = std::filesystem;
using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

constexpr const char* kScan =
    R"({"schema":"mapwright.scan/1","scans":[{"pose":{"x":2,"y":2,"theta_deg":0},"ranges":[2,15]}],
        "angles_deg":[-90,90],"laser_height":0.5,"max_range":15})";
constexpr const char* kPlan =
    R"({"schema":"mapwright.plan/1","planner":"rrt","queries":[{"start":[1,1],"goal":[9,9],
        "solved":true,"path":[[1,1],[9,9]],"raw_path":[[1,1],[5,2],[9,9]],"tree":[[1,1,5,2]]}]})";
constexpr const char* kLocalization =
    R"({"schema":"mapwright.localize/1","iterations":[
        {"n":1,"particles":2,"particle_set":[[1,1,0,0.5],[2,2,90,0.5]],
         "estimate":{"x":1,"y":1,"theta_deg":0},"true_pose":{"x":2,"y":2,"theta_deg":90}},
        {"n":2,"particles":1,"particle_set":[[2,2,90,1.0]],
         "estimate":{"x":2,"y":2,"theta_deg":90},"true_pose":{"x":2,"y":2,"theta_deg":90}}]})";
constexpr const char* kFindings =
    R"({"schema":"mapwright.validate/1","maps":[{"path":"m","verdict":"fail","findings":[
        {"code":"G104","severity":"error","x":3,"y":3},{"code":"F101","severity":"error"}]}]})";

class RenderVerb : public testing::Test {
 protected:
  ProgramRun render(std::vector<std::string> options) const {
    options.insert(options.begin(), {"render", map_});
    return run(options);
  }
  std::string picture(std::vector<std::string> options) const {
    const std::string path = folder_.path("picture.svg");
    options.insert(options.end(), {"-o", path});
    const ProgramRun result = render(options);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "");
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string overlay(const std::string& json) const {
    return picture({"--overlay", folder_.file("answer.json", json)});
  }

  TemporaryFolder folder_;
  std::string map_ =
      folder_.file("map.txt",
                   "border;0;10;10;0;#obstacle;1;2;1;wall;#4;1;4;9;2;1;;#obstacle;2;1;4;box;#"
                   "6;4;8;4;2;1;;#8;4;8;6;2;1;;#8;6;6;6;2;1;;#6;6;6;4;2;1;;#");
};

TEST_F(RenderVerb, DrawsEveryFormat) {
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    const auto result = render({"-o", folder_.path(name)});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "wrote " + folder_.path(name) + "\n");
    EXPECT_GT(fs::file_size(folder_.path(name)), 1000U);
  }
}

TEST_F(RenderVerb, EachOptionChangesThePicture) {
  const std::string plain = picture({});
  EXPECT_EQ(picture({"--ticks", "--labels", "heights", "--width", "1600"}), plain);
  const std::vector<std::vector<std::string>> options = {
      {"--no-ticks"},         {"--labels", "none"}, {"--labels", "ids"}, {"--title", "Site"},
      {"--bbox", "0,0,5,10"}, {"--width", "900"},   {"--circles"},       {"--scan", "2,2,0"}};
  for (const auto& option : options) {
    EXPECT_NE(picture(option), plain) << testing::PrintToString(option);
  }
}

TEST_F(RenderVerb, DrawsAnswersOfOtherVerbs) {
  const std::string plain = picture({});
  for (const char* json : {kScan, kPlan, kLocalization, kFindings}) {
    EXPECT_NE(overlay(json), plain) << json;
  }
}

// What the other verbs really answer, so that neither side can drift from the other.
TEST_F(RenderVerb, DrawsWhatTheOtherVerbsAnswer) {
  const std::string plain = picture({});
  const std::vector<std::vector<std::string>> verbs = {
      {"plan", "--start", "1,1", "--goal", "9,9", "--planner", "rrt", "--with-tree"},
      {"plan", "--start", "1,1", "--goal", "9,9", "--planner", "balanced-rrt"},
      {"plan", "--start", "1,1", "--goal", "9,9", "--planner", "exact", "--radius", "0.3"},
      {"plan", "--start", "1,1", "--goal", "7,5"},
      {"scan", "--pose", "2,2,0"},
      {"localize", "--pose", "2,2,0", "--iterations", "1", "--with-particles"}};
  for (auto arguments : verbs) {
    arguments.insert(arguments.begin() + 1, map_);
    arguments.insert(arguments.end(), {"--format", "json"});
    EXPECT_NE(overlay(run(arguments).out), plain) << testing::PrintToString(arguments);
  }
}

TEST_F(RenderVerb, ChoosesTheIteration) {
  const std::string answer = folder_.file("answer.json", kLocalization);
  const std::string last = picture({"--overlay", answer});
  EXPECT_EQ(picture({"--overlay", answer, "--iteration", "2"}), last);
  EXPECT_NE(picture({"--overlay", answer, "--iteration", "1"}), last);
  EXPECT_EQ(render({"-o", folder_.path("x.svg"), "--overlay", answer, "--iteration", "3"}).status,
            2);
}

TEST_F(RenderVerb, DrawsAllIterationsIntoFilesOfTheirOwn) {
  const std::string answer = folder_.file("answer.json", kLocalization);
  const auto result =
      render({"-o", folder_.path("frame.png"), "--overlay", answer, "--iteration", "all"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder_.path("frame-01.png")));
  EXPECT_TRUE(fs::exists(folder_.path("frame-02.png")));
  EXPECT_FALSE(fs::exists(folder_.path("frame.png")));
}

TEST_F(RenderVerb, PointsNorthWhereASidecarTells) {
  const std::string plain = picture({});
  Georeference georeference;
  georeference.heading_deg = -20.0;
  folder_.file("map.georef.json", format_georeference(georeference));
  EXPECT_NE(picture({}), plain);
  folder_.file("map.georef.json", "{}");
  EXPECT_EQ(render({"-o", folder_.path("x.svg")}).status, 3);
}

TEST_F(RenderVerb, DrawsWhatIsReadableOfADamagedMap) {
  map_ = folder_.file("map.txt",
                      "border;0;10;10;0;#obstacle;1;2;2;wall;#4;1;4;9;2;1;;#x;1;4;9;2;1;;#");
  const auto result = render({"-o", folder_.path("x.svg")});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("warning: " + map_), std::string::npos) << result.err;
}

TEST_F(RenderVerb, RefusesWrongUsage) {
  const std::string svg = folder_.path("x.svg");
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"-o", folder_.path("x.jpg")},
      {"-o", svg, "--bbox", "5,0,5,10"},
      {"-o", svg, "--bbox", "1,2,3"},
      {"-o", svg, "--width", "100"},
      {"-o", svg, "--width", "wide"},
      {"-o", svg, "--labels", "colours"},
      {"-o", svg, "--ticks", "--no-ticks"},
      {"-o", svg, "--iteration", "0"},
      {"-o", svg, "--iteration", "1.5"},
      {"-o", svg, "--iteration", "all"},
      {"-o", svg, "--scan", "1,2"},
      {"-o", svg, "--scan", "7,5,0"},
      {"-o", svg, "--scan", "2,2,0", "--rays", "0"}};
  for (const auto& options : wrong) {
    const auto result = render(options);
    EXPECT_EQ(result.status, 2) << testing::PrintToString(options);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err, "");
  }
  EXPECT_FALSE(fs::exists(svg));
}

TEST_F(RenderVerb, RefusesUnreadableInputs) {
  const std::string svg = folder_.path("x.svg");
  const auto with_answer = [&](const std::string& text) {
    return render({"-o", svg, "--overlay", folder_.file("answer.json", text)});
  };
  for (const char* text : {"", "no json", "[1,2]", R"({"schema":"mapwright.info/1"})",
                           R"({"schema":"mapwright.plan/1"})",
                           R"({"schema":"mapwright.scan/1","scans":[{}],"angles_deg":[]})",
                           R"({"schema":"mapwright.localize/1","iterations":[{"n":1}]})"}) {
    const auto result = with_answer(text);
    EXPECT_EQ(result.status, 3) << text;
    EXPECT_NE(result.err.find("answer.json"), std::string::npos) << result.err;
  }
  map_ = folder_.file("map.txt", "");
  EXPECT_EQ(render({"-o", svg}).status, 3);
  map_ = folder_.path("none.txt");
  EXPECT_EQ(render({"-o", svg}).status, 3);
  EXPECT_FALSE(fs::exists(svg));
}

}  // namespace
}  // namespace mapwright
