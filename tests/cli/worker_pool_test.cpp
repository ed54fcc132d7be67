#include "cli/support/worker_pool.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "tests/cli/processes.hpp"

namespace mapwright::cli {
namespace {

using Kind = WorkerOutcome::Kind;
using Outcomes = std::map<std::size_t, WorkerOutcome>;
using Work = std::function<std::string(std::size_t)>;

Outcomes outcomes_of(std::size_t count, unsigned jobs, const Work& work,
                     const WorkerLimits& limits = {}) {
  Outcomes outcomes;
  run_in_workers(count, jobs, limits, work, [&](std::size_t i, WorkerOutcome outcome) {
    EXPECT_TRUE(outcomes.emplace(i, std::move(outcome)).second);
  });
  return outcomes;
}

[[noreturn]] void hang() {
  while (true) ::pause();
}

TEST(WorkerPool, GivesEachAnswerOnceForAnyNumberOfJobs) {
  for (const unsigned jobs : {1U, 3U, 50U}) {
    const auto outcomes =
        outcomes_of(20, jobs, [](std::size_t i) { return std::to_string(i * i); });
    ASSERT_EQ(outcomes.size(), 20U);
    for (const auto& [i, outcome] : outcomes) {
      EXPECT_EQ(outcome.kind, Kind::kDone);
      EXPECT_EQ(outcome.text, std::to_string(i * i));
    }
  }
  EXPECT_TRUE(outcomes_of(0, 2, [](std::size_t) { return ""; }).empty());
}

TEST(WorkerPool, CarriesLongAndEmptyAnswers) {
  const auto outcomes = outcomes_of(
      2, 2, [](std::size_t i) { return i == 0 ? std::string() : std::string(5'000'000, 'x'); });
  EXPECT_EQ(outcomes.at(0).kind, Kind::kDone);
  EXPECT_EQ(outcomes.at(0).text, "");
  EXPECT_EQ(outcomes.at(1).text.size(), 5'000'000U);
}

TEST(WorkerPool, ACrashCostsOnePieceAndIsNamed) {
  const auto outcomes = outcomes_of(4, 2, [](std::size_t i) -> std::string {
    for (const int signal : {SIGSEGV, SIGABRT}) std::signal(signal, SIG_DFL);  // no stack traces
    if (i == 1) std::raise(SIGSEGV);
    if (i == 2) std::raise(SIGABRT);
    if (i == 3) ::_exit(7);
    return "fine";
  });
  EXPECT_EQ(outcomes.at(0).text, "fine");
  EXPECT_EQ(outcomes.at(1).kind, Kind::kCrashed);
  EXPECT_EQ(outcomes.at(1).text, "SIGSEGV (Segmentation fault)");
  EXPECT_EQ(outcomes.at(2).text, "SIGABRT (Aborted)");
  EXPECT_EQ(outcomes.at(3).kind, Kind::kCrashed);
  EXPECT_EQ(outcomes.at(3).text, "exit status 7");
}

TEST(WorkerPool, AHangCostsOnePieceAndItsTime) {
  const auto start = std::chrono::steady_clock::now();
  const auto outcomes = outcomes_of(3, 1,
                                    [](std::size_t i) -> std::string {
                                      if (i == 1) hang();
                                      return "fine";
                                    },
                                    {1.0, 0});
  EXPECT_EQ(outcomes.at(0).text, "fine");
  EXPECT_EQ(outcomes.at(1).kind, Kind::kTimeLimit);
  EXPECT_EQ(outcomes.at(2).text, "fine");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_GE(taken.count(), 1.0);
  EXPECT_LT(taken.count(), 30.0);
  EXPECT_TRUE(test::children_of(::getpid()).empty());
}

TEST(WorkerPool, ExceptionsAreToldApart) {
  const auto outcomes = outcomes_of(2, 1, [](std::size_t i) -> std::string {
    if (i == 0) throw std::bad_alloc();
    throw std::runtime_error("no luck");
  });
  EXPECT_EQ(outcomes.at(0).kind, Kind::kOutOfMemory);
  EXPECT_EQ(outcomes.at(1).kind, Kind::kFailed);
  EXPECT_EQ(outcomes.at(1).text, "no luck");
}

TEST(WorkerPool, HoldsWorkersToTheMemoryTheyMayTake) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer takes terabytes of addresses";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
  GTEST_SKIP() << "the sanitizer takes terabytes of addresses";
#endif
#endif
  const auto sum_of = [](std::size_t megabytes) {
    const std::vector<char> bytes(megabytes * 1'000'000, 1);
    return std::to_string(std::accumulate(bytes.begin(), bytes.end(), std::size_t{0}));
  };
  const auto outcomes = outcomes_of(2, 1, [&](std::size_t i) { return sum_of(i == 0 ? 20 : 200); },
                                    {0.0, 50'000'000});
  EXPECT_EQ(outcomes.at(0).kind, Kind::kDone);
  EXPECT_EQ(outcomes.at(0).text, "20000000");
  EXPECT_EQ(outcomes.at(1).kind, Kind::kOutOfMemory);
}

TEST(WorkerPool, WhatTheReceiverThrowsLeavesNoChildBehind) {
  const auto work = [](std::size_t i) -> std::string {
    if (i > 0) hang();
    return "first";
  };
  const auto refuse = [](std::size_t, const WorkerOutcome&) { throw std::runtime_error("full"); };
  EXPECT_THROW(run_in_workers(3, 3, {}, work, refuse), std::runtime_error);
  EXPECT_TRUE(test::children_of(::getpid()).empty());
}

}  // namespace
}  // namespace mapwright::cli
