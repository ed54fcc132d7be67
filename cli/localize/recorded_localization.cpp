#include "cli/localize/recorded_localization.hpp"

#include <algorithm>

#include "cli/localize/kidnapped_answer.hpp"
#include "cli/localize/recorded_answer.hpp"
#include "cli/support/error.hpp"
#include "mapcore/random.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::cli {
namespace {

// Streams of a seed beside the filter's.
constexpr std::uint64_t kStartStream = UINT64_MAX;

/// The robot's belief where it starts: the reference, off by the errors it believes in.
Pose believed_start(const Pose& reference, const navcore::RecordedSettings& settings,
                    std::uint64_t seed) {
  Random random(seed, kStartStream);
  const double dx = random.normal(0.0, settings.initial_sigma_m);
  const double dy = random.normal(0.0, settings.initial_sigma_m);
  const double turn_deg = random.normal(0.0, settings.initial_sigma_deg);
  return {reference.x + dx, reference.y + dy,
          (reference.theta + Angle::from_degrees(turn_deg)).wrapped()};
}

class Runner {
 public:
  Runner(const Map& map, RayEngineKind engine, const RecordedQuestion& question, Console& console)
      : space_(map),
        engine_(map, engine),
        question_(question),
        steps_(recorded_steps(question, console)) {}

  std::vector<JudgedRun> run(unsigned threads, Console& console) const {
    const auto asked = stretches(question_, steps_.size());
    auto results = over_all<JudgedRun>(asked.size(), threads,
                                       [&](std::size_t i) { return run_stretch(asked[i], i); });
    console.note(speed_text(results));
    return results;
  }

  std::vector<KidnappedRun> kidnap(unsigned threads) const {
    const auto asked = stretches(question_, steps_.size());
    const std::size_t further = asked.size() / 2;
    return over_all<KidnappedRun>(asked.size(), threads, [&](std::size_t i) {
      return kidnap(asked[i], asked[(i + further) % asked.size()], i);
    });
  }

 private:
  template <class Run, class Work>
  static std::vector<Run> over_all(std::size_t count, unsigned threads, const Work& work) {
    std::vector<Result<Run>> runs(count);
    navcore::parallel_for(count, 1, threads,
                          [&](std::size_t i, std::size_t) { runs[i] = work(i); });
    std::vector<Run> results;
    for (auto& run : runs) results.push_back(value_or_throw(std::move(run)));
    return results;
  }

  // The number-th of all.
  Result<navcore::RecordedRun> run_steps(std::span<const navcore::RecordedStep> steps,
                                         std::size_t first, std::size_t last,
                                         std::size_t number) const {
    const std::uint64_t seed = question_.seed + number;
    navcore::RecordedSettings settings = question_.settings;
    if (question_.from_reference) {
      settings.initial_pose = believed_start(*steps[first].reference, settings, seed);
    }
    return navcore::run_recorded(space_, engine_.weigher(), settings, steps, first, last, seed);
  }

  Result<JudgedRun> run_stretch(const ScanStretch& stretch, std::size_t number) const {
    auto run = run_steps(steps_, stretch.first, stretch.last, number);
    if (!run) return tl::unexpected(run.error());
    JudgedRun judged{*std::move(run), {}};
    if (steps_.front().reference) judged.verdict = judge(judged.run);
    return judged;
  }

  std::span<const navcore::RecordedStep> steps_of(const ScanStretch& stretch) const {
    return std::span(steps_).subspan(stretch.first, stretch.last - stretch.first + 1);
  }

  Result<KidnappedRun> kidnap(const ScanStretch& before, const ScanStretch& after,
                              std::size_t number) const {
    const auto steps = navcore::spliced(steps_of(before), steps_of(after));
    const auto run = run_steps(steps, 0, steps.size() - 1, number);
    if (!run) return tl::unexpected(run.error());
    return KidnappedRun{before, after, judge_kidnapping(*run, steps_of(before).size())};
  }

  navcore::FreeSpace space_;
  RayEngine engine_;
  const RecordedQuestion& question_;
  std::vector<navcore::RecordedStep> steps_;
};

template <class Run, class Good>
bool are_enough(const std::vector<Run>& runs, double required_percent, const Good& good) {
  const auto converged = std::count_if(runs.begin(), runs.end(), good);
  return 100.0 * static_cast<double>(converged) >=
         required_percent * static_cast<double>(runs.size());
}

ExitStatus status_of(bool success) {
  return success ? ExitStatus::kSuccess : ExitStatus::kNegative;
}

}  // namespace

ExitStatus localize_recorded(const Map& map, RayEngineKind engine, const RecordedQuestion& question,
                             const RecordedOutput& output, Console& console) {
  const Runner runner(map, engine, question, console);
  if (question.kidnap) {
    const std::vector<KidnappedRun> runs = runner.kidnap(output.threads);
    output.json ? write_kidnapped_json(console.out(), question, runs)
                : write_kidnapped_text(console.out(), runs);
    return status_of(are_enough(runs, output.required_percent,
                                [](const KidnappedRun& run) { return run.verdict.recovered; }));
  }
  const std::vector<JudgedRun> runs = runner.run(output.threads, console);
  if (question.is_batch()) {
    output.json ? write_recorded_batch_json(console.out(), question, runs)
                : write_recorded_batch_text(console.out(), runs);
    return status_of(are_enough(runs, output.required_percent,
                                [](const JudgedRun& run) { return run.converged(); }));
  }
  output.json ? write_recorded_run_json(console.out(), question, runs.front())
              : write_recorded_run_text(console.out(), runs.front());
  return status_of(runs.front().converged());
}

}  // namespace mapwright::cli
