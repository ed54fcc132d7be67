#include "cli/localize/kidnapped_answer.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "cli/localize/answer_json.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::cli {
namespace {

struct Summary {
  std::size_t recovered = 0, right_before = 0;
  std::optional<navcore::MedianAndP95> scans, way_m;  ///< of the runs that recovered
};

Summary summarize(const std::vector<KidnappedRun>& runs) {
  Summary summary;
  std::vector<double> scans, way_m;
  for (const auto& run : runs) {
    summary.right_before += run.verdict.right_before ? 1 : 0;
    if (!run.verdict.recovered) continue;
    ++summary.recovered;
    scans.push_back(static_cast<double>(run.verdict.scans));
    way_m.push_back(run.verdict.way_m);
  }
  summary.scans = navcore::median_and_p95(scans);
  summary.way_m = navcore::median_and_p95(way_m);
  return summary;
}

template <class... Values>
void print(std::ostream& out, const char* format, Values... values) {
  char line[200];
  std::snprintf(line, sizeof line, format, values...);
  out << line;
}

}  // namespace

void write_kidnapped_text(std::ostream& out, const std::vector<KidnappedRun>& runs) {
  out << " first   last carried m  first   last  right before  right after scans   way m\n";
  for (const auto& run : runs) {
    print(out, "%6zu %6zu %9.1f %6zu %6zu %13s", run.before.first, run.before.last,
          run.verdict.carried_m, run.after.first, run.after.last,
          run.verdict.right_before ? "yes" : "no");
    if (run.verdict.recovered) {
      print(out, " %18zu %7.1f\n", run.verdict.scans, run.verdict.way_m);
    } else {
      print(out, " %18s\n", "-");
    }
  }
  const Summary all = summarize(runs);
  print(out, "recovered %zu of %zu; right before %zu", all.recovered, runs.size(),
        all.right_before);
  if (all.scans) {
    print(out, "; scans to it median %.1f, p95 %.1f; way to it median %.1f m, p95 %.1f m",
          all.scans->median, all.scans->p95, all.way_m->median, all.way_m->p95);
  }
  out << '\n';
}

void write_kidnapped_json(std::ostream& out, const RecordedQuestion& question,
                          const std::vector<KidnappedRun>& runs) {
  const Summary all = summarize(runs);
  Json json;
  json["schema"] = "mapwright.localize/1";
  json["trials"] = runs.size();
  json["right_before"] = all.right_before;
  json["recovered"] = all.recovered;
  json["scans_to_recover"] = spread_json(all.scans);
  json["way_m"] = spread_json(all.way_m);
  json["runs"] = Json::array();
  for (const auto& run : runs) {
    Json row;
    row["before"] = {{"first_scan", run.before.first}, {"last_scan", run.before.last}};
    row["after"] = {{"first_scan", run.after.first}, {"last_scan", run.after.last}};
    row["carried_m"] = run.verdict.carried_m;
    row["right_before"] = run.verdict.right_before;
    row["recovered"] = run.verdict.recovered;
    row["scans_to_recover"] = run.verdict.recovered ? Json(run.verdict.scans) : Json(nullptr);
    row["way_m"] = run.verdict.recovered ? Json(run.verdict.way_m) : Json(nullptr);
    json["runs"].push_back(std::move(row));
  }
  json["settings"] = recorded_settings_json(question);
  out << json.dump() << '\n';
}

}  // namespace mapwright::cli
