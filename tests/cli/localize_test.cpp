// The verb localize.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/cli/program_run.hpp"

namespace mapwright {
namespace {

using Json = nlohmann::json;
using test::run;

void add_block(std::ostream& out, int id, double left, double bottom, double right, double top) {
  out << "obstacle;\n" << id << ";1;4;block;\n#\n";
  const double corners[5][2] = {
      {left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}};
  for (int i = 0; i < 4; ++i) {
    out << corners[i][0] << ';' << corners[i][1] << ";\n"
        << corners[i + 1][0] << ';' << corners[i + 1][1] << ";\n3;1;wall;\n#\n";
  }
}

// A yard of 24 m × 20 m with blocks of different sizes.
std::string yard() {
  std::ostringstream out;
  out << "border;\n0;20;\n24;0;\n#\n";
  add_block(out, 1, 3, 3, 7, 5);
  add_block(out, 2, 12, 2, 13, 8);
  add_block(out, 3, 17, 13, 22, 17);
  add_block(out, 4, 5, 12, 6.5, 17);
  add_block(out, 5, 18, 4, 19, 5);
  return out.str();
}

class Localize : public testing::Test {
 protected:
  test::ProgramRun localize(std::vector<std::string> options) {
    std::vector<std::string> arguments{"localize", map_, "--particles", "1000"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }

  test::TemporaryFolder folder_;
  std::string map_ = folder_.file("map.txt", yard());
};

TEST_F(Localize, AnswersInJson) {
  const auto result = localize(
      {"--pose", "10,10,45", "--iterations", "6", "--first-particles", "6000", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err << result.out;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["schema"], "mapwright.localize/1");
  EXPECT_EQ(json["converged"], true);
  ASSERT_EQ(json["iterations"].size(), 6U);
  EXPECT_EQ(json["iterations"][0]["n"], 1);
  EXPECT_EQ(json["iterations"][0]["particles"], 6000);
  EXPECT_GE(json["iterations"][1]["particles"], 990) << "each place has some";
  for (const auto& iteration : json["iterations"]) {
    EXPECT_GT(iteration["effective_particles"].get<double>(), 0.0);
    EXPECT_TRUE(iteration["spread_m"].is_number());
    EXPECT_TRUE(iteration["position_error_m"].is_number());
    EXPECT_TRUE(iteration["estimate"]["theta_deg"].is_number());
    EXPECT_TRUE(iteration["true_pose"]["x"].is_number());
  }
  EXPECT_EQ(json["iterations"][0]["true_pose"],
            Json({{"x", 10.0}, {"y", 10.0}, {"theta_deg", 45.0}}));
  const Json last = json["iterations"][5];
  EXPECT_EQ(json["estimate"], last["estimate"]);
  EXPECT_LT(last["position_error_m"].get<double>(), 0.5);
}

TEST_F(Localize, GivesParticlesAndScansWhenAsked) {
  const auto result =
      localize({"--pose", "10,10,45", "--iterations", "2", "--rays", "31", "--first-particles",
                "2000", "--format", "json", "--with-particles"});
  const Json json = Json::parse(result.out);
  for (const auto& iteration : json["iterations"]) {
    EXPECT_EQ(iteration["scan"].size(), 31U);
    ASSERT_GE(iteration["particle_set"].size(), 800U);
    double weight = 0.0;
    for (const auto& particle : iteration["particle_set"]) {
      ASSERT_EQ(particle.size(), 4U);
      weight += particle[3].get<double>();
    }
    EXPECT_NEAR(weight, 1.0, 1e-9);
  }
  EXPECT_EQ(json["iterations"][0]["particles"], 2000);
}

TEST_F(Localize, SaysSoWhenItDoesNotConverge) {
  // One scan of one ray tells nobody where he is.
  const auto result =
      localize({"--pose", "10,10,45", "--iterations", "1", "--rays", "1", "--format", "json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(Json::parse(result.out)["converged"], false);
}

TEST_F(Localize, Tracks) {
  const auto result = localize({"--pose", "10,10,45", "--initial-pose", "10.3,9.8,43",
                                "--iterations", "10", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_GE(json["iterations"][0]["particles"], 1000);
  EXPECT_LT(json["iterations"][9]["position_error_m"].get<double>(), 0.3);
}

TEST_F(Localize, SummarisesTrials) {
  const std::vector<std::string> options{"--trials",          "6",    "--iterations", "4",
                                         "--first-particles", "5000", "--format",     "json"};
  const auto result = localize(options);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["trials"], 6);
  ASSERT_EQ(json["runs"].size(), 6U);
  std::size_t converged = 0;
  for (const auto& one : json["runs"]) {
    converged += one["converged"].get<bool>();
    EXPECT_EQ(one["truth_evidence"].is_null(), !one["right_from"].is_null());
  }
  EXPECT_EQ(json["converged"], converged);
  EXPECT_GE(converged, 4U);
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(json["iterations_to_converge"]["median"].is_number());
  EXPECT_TRUE(json["position_error_m"]["p95"].is_number());
  EXPECT_EQ(json["after"].size(), 3U) << "after 1, 2 and 4 iterations";

  auto strict = options;
  strict.insert(strict.end(), {"--iterations", "1", "--rays", "1", "--require", "100"});
  strict.erase(strict.begin() + 2, strict.begin() + 4);
  EXPECT_EQ(localize(strict).status, 1);
}

TEST_F(Localize, SetsTrackingAgainstTheSequentialBound) {
  const std::vector<std::string> options{"--trials", "4", "--known-start", "--iterations", "6"};
  auto as_json = options;
  as_json.insert(as_json.end(), {"--format", "json"});
  const Json json = Json::parse(localize(as_json).out);
  EXPECT_EQ(json["settings"]["known_start"], true);
  const Json& tracking = json["tracking"];
  EXPECT_GT(tracking["rms_bound_m"].get<double>(), 0.002);
  // Scans and encoders can only add to what is known of the start: 0.5 m along each axis.
  EXPECT_LT(tracking["rms_bound_m"].get<double>(), 0.5 * std::numbers::sqrt2);
  EXPECT_NEAR(tracking["rms_ratio"].get<double>(), 1.5, 1.2);
  ASSERT_EQ(json["reliability"].size(), 5U);
  std::size_t iterations = 0;
  for (const auto& row : json["reliability"]) iterations += row["iterations"].get<std::size_t>();
  EXPECT_EQ(iterations, 24U);
  const std::string text = localize(options).out;
  EXPECT_NE(text.find("sequential Fisher bound rms"), std::string::npos) << text;
  EXPECT_NE(text.find("took itself for converged in"), std::string::npos) << text;
}

TEST_F(Localize, AKnownStartBelongsToTrials) {
  const auto result = localize({"--pose", "10,10,45", "--known-start"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--initial-pose"), std::string::npos);
}

TEST_F(Localize, IsTheSameForAnyNumberOfThreads) {
  const auto out = [&](const std::string& threads, const std::string& seed) {
    return localize({"--pose", "10,10,45", "--iterations", "2", "--first-particles", "3000",
                     "--threads", threads, "--seed", seed, "--format", "json"})
        .out;
  };
  EXPECT_EQ(out("1", "4"), out("3", "4"));
  EXPECT_NE(out("1", "4"), out("1", "5"));
}

TEST_F(Localize, TakesTheReportsParametersForTheReportsLikelihood) {
  const auto result = localize(
      {"--pose", "10,10,45", "--iterations", "1", "--likelihood", "report", "--format", "json"});
  const Json settings = Json::parse(result.out)["settings"];
  EXPECT_EQ(settings["alpha"], 1.0);
  EXPECT_EQ(settings["beta"], 0.1);
  EXPECT_EQ(settings["sigma"], 0.5);
  EXPECT_EQ(settings["first_particles"], 1000);
}

TEST_F(Localize, RefusesWrongUsage) {
  EXPECT_EQ(localize({}).status, 2);
  EXPECT_EQ(localize({"--pose", "1,2,3", "--trials", "3"}).status, 2);
  EXPECT_EQ(localize({"--pose", "4,4,0"}).status, 2) << "in a block";
  EXPECT_EQ(localize({"--pose", "40,4,0"}).status, 2) << "outside of the border";
  EXPECT_EQ(localize({"--trials", "0"}).status, 2);
  EXPECT_EQ(localize({"--trials", "2", "--initial-pose", "1,1,1"}).status, 2);
  EXPECT_EQ(localize({"--pose", "10,10,0", "--initial-pose", "40,4,0"}).status, 2);
  EXPECT_EQ(localize({"--pose", "1,1,0", "--likelihood", "best"}).status, 2);
  EXPECT_EQ(localize({"--pose", "1,1,0", "--likelihood", "report", "--temper", "0.5"}).status, 2);
  EXPECT_EQ(localize({"--pose", "1,1,0", "--with-particles"}).status, 2) << "needs json";
  EXPECT_EQ(localize({"--pose", "1,1,0", "--sigma", "0"}).status, 2);
  EXPECT_EQ(localize({"--pose", "1,1,0", "--iterations", "0"}).status, 2);
}

}  // namespace
}  // namespace mapwright
