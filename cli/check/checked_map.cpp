#include "cli/check/checked_map.hpp"

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <utility>

#include "cli/support/digest.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "cli/support/map_reports.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/text/reader.hpp"

namespace mapwright::cli {
namespace {

using validators::Interruption;
using validators::MapRecord;
using Kind = WorkerOutcome::Kind;

MapRecord unjudged(const std::string& path, std::string why, Interruption interruption) {
  MapRecord record;
  record.path = display_path(path);
  record.unreadable = std::move(why);
  record.interruption = interruption;
  return record;
}

std::string plain(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

std::string memory_text(const WorkerLimits& limits) {
  if (limits.memory_bytes == 0) return "memory ran out; check fewer maps at once (--jobs)";
  return "it needs more than " + plain(static_cast<double>(limits.memory_bytes) / 1e6) +
         " MB of memory; allow it more (--memory-limit)";
}

// The kernel kills what takes the last memory; nobody else here sends that signal.
std::string crash_text(const std::string& how, const std::string& path) {
  if (how.starts_with("SIGKILL")) {
    return "its check was killed from outside: " + how +
           ", perhaps since memory ran out; check fewer maps at once (--jobs) or set "
           "--memory-limit";
  }
  return "its check crashed: " + how +
         "; this is a defect of mapwright, not of the map: 'mapwright check " + path +
         "' shows it again, please report it with the map";
}

}  // namespace

MapRecord check_map(const std::string& path, const std::optional<std::string>& text,
                    const validators::GateOptions& options, const MapRules& rules) {
  try {
    const MapDocument document = read_map(text ? *text : read_file(path));
    validators::GateOutcome outcome = check_deployment(document, options);
    auto more = sidecar_findings(path, document.map);
    outcome.findings.insert(outcome.findings.end(), std::make_move_iterator(more.begin()),
                            std::make_move_iterator(more.end()));
    validators::MapReport report{display_path(path), document.text, {}, {}, {}};
    report.sections = deployment_sections(outcome, options);
    auto judgement = rules.judge(path, document, std::move(outcome.findings));
    report.findings = std::move(judgement.findings);
    report.names = std::move(judgement.names);
    report.suppressed = std::move(judgement.suppressed);
    return validators::make_record(report, map_digest(path, document.text));
  } catch (const Error& error) {
    return unjudged(path, error.what(), Interruption::kNone);
  }
}

MapRecord record_of(const WorkerOutcome& outcome, const std::string& path,
                    const WorkerLimits& limits) {
  const std::string name(display_path(path));
  switch (outcome.kind) {
    case Kind::kDone:
      return value_or_throw(validators::parse_record(outcome.text));
    case Kind::kTimeLimit:
      return unjudged(path,
                      name + ": its check took longer than " + plain(limits.time_s) +
                          " s and was stopped; allow it more (--time-limit) or ask less of it "
                          "(--trials, --plans)",
                      Interruption::kTimeLimit);
    case Kind::kOutOfMemory:
      return unjudged(path, name + ": cannot be checked: " + memory_text(limits),
                      Interruption::kMemoryLimit);
    case Kind::kFailed:
    case Kind::kCrashed:
      return unjudged(path, name + ": " + crash_text(outcome.text, name), Interruption::kCrash);
  }
  return unjudged(path, name + ": " + crash_text(outcome.text, name), Interruption::kCrash);
}

std::string map_digest(const std::string& path, std::string_view text) {
  const std::string sidecar = sidecar_path(path);
  std::error_code error;
  if (path == "-" || !std::filesystem::exists(sidecar, error)) return digest({text});
  return digest({text, read_file(sidecar)});
}

std::optional<std::string> digest_on_disk(const std::string& path) {
  try {
    return map_digest(path, read_file(path));
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace mapwright::cli
