#include "cli/localize/recorded_localization.hpp"

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
  Runner(const Map& map, RayEngineKind engine, const RecordedQuestion& question)
      : space_(map), engine_(map, engine), question_(question), steps_(recorded_steps(question)) {}

  std::vector<JudgedRun> run(unsigned threads, Console& console) const {
    const auto asked = stretches(question_, steps_.size());
    std::vector<Result<JudgedRun>> runs(asked.size());
    navcore::parallel_for(asked.size(), 1, threads, [&](std::size_t i, std::size_t) {
      runs[i] = run_stretch(asked[i], question_.seed + i);
    });
    std::vector<JudgedRun> results;
    for (auto& run : runs) results.push_back(value_or_throw(std::move(run)));
    console.note(speed_text(results));
    return results;
  }

 private:
  Result<JudgedRun> run_stretch(const ScanStretch& stretch, std::uint64_t seed) const {
    navcore::RecordedSettings settings = question_.settings;
    if (question_.from_reference) {
      settings.initial_pose = believed_start(*steps_[stretch.first].reference, settings, seed);
    }
    auto run = navcore::run_recorded(space_, engine_.weigher(), settings, steps_, stretch.first,
                                     stretch.last, seed);
    if (!run) return tl::unexpected(run.error());
    JudgedRun judged{*std::move(run), {}};
    if (steps_.front().reference) judged.verdict = judge(judged.run);
    return judged;
  }

  navcore::FreeSpace space_;
  RayEngine engine_;
  const RecordedQuestion& question_;
  std::vector<navcore::RecordedStep> steps_;
};

bool are_enough(const std::vector<JudgedRun>& runs, double required_percent) {
  std::size_t converged = 0;
  for (const auto& run : runs) converged += run.converged() ? 1 : 0;
  return 100.0 * static_cast<double>(converged) >=
         required_percent * static_cast<double>(runs.size());
}

}  // namespace

ExitStatus localize_recorded(const Map& map, RayEngineKind engine, const RecordedQuestion& question,
                             const RecordedOutput& output, Console& console) {
  const Runner runner(map, engine, question);
  const std::vector<JudgedRun> runs = runner.run(output.threads, console);
  if (question.is_batch()) {
    output.json ? write_recorded_batch_json(console.out(), question, runs)
                : write_recorded_batch_text(console.out(), runs);
    return are_enough(runs, output.required_percent) ? ExitStatus::kSuccess : ExitStatus::kNegative;
  }
  output.json ? write_recorded_run_json(console.out(), question, runs.front())
              : write_recorded_run_text(console.out(), runs.front());
  return runs.front().converged() ? ExitStatus::kSuccess : ExitStatus::kNegative;
}

}  // namespace mapwright::cli
