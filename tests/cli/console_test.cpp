// The bar that shows on terminals how far long work is.
#include "cli/support/console.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

namespace mapwright::cli {
namespace {

using Clock = std::chrono::steady_clock;

class Bar : public testing::Test {
 protected:
  // What is drawn since the last call.
  std::string drawn() {
    const std::string text = err_.str();
    err_.str("");
    return text;
  }

  std::ostringstream out_, err_;
};

TEST_F(Bar, ShowsHowFarTheWorkIs) {
  Console console(out_, err_, true);
  const auto progress = console.progress("converting");
  progress(25, 100);
  const auto bar = drawn();
  EXPECT_NE(bar.find("converting [==========  "), std::string::npos) << bar;
  EXPECT_NE(bar.find("25 %, 25 of 100"), std::string::npos) << bar;
  progress(100, 100);
  EXPECT_EQ(drawn(), "\r\033[K");  // nothing of it stays
}

TEST_F(Bar, IsForTerminalsAndThoseWhoWantToHear) {
  Console file(out_, err_, false);
  file.progress("converting")(25, 100);
  Console quiet(out_, err_, true);
  quiet.set_verbosity(Verbosity::kQuiet);
  quiet.progress("converting")(25, 100);
  EXPECT_EQ(drawn(), "");
}

// Before the first news a file was opened, which says nothing of the pace.
TEST_F(Bar, EstimatesFromTheFirstNewsOn) {
  Console console(out_, err_, true);
  const auto progress = console.progress("converting");
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  progress(1000, 101000);
  const auto start = Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  drawn();
  progress(51000, 101000);
  const double gone_s = std::chrono::duration<double>(Clock::now() - start).count();
  const auto bar = drawn();
  const auto at = bar.rfind(", ");
  ASSERT_NE(bar.find(" s left", at), std::string::npos) << bar;
  EXPECT_LE(std::stod(bar.substr(at + 2)), gone_s + 0.6) << bar;  // as much again, in whole seconds
}

}  // namespace
}  // namespace mapwright::cli
