// Prints docs/source-survey.md: what `mapwright convert` makes of every GIS file of the real data.
// Usage: source_survey MAPWRIGHT DATA_FOLDER > docs/source-survey.md
#include <cstdio>
#include <iostream>
#include <map>

#include "tests/sources/survey.hpp"

namespace mapwright::test {
namespace {

constexpr double kLimit_s = 30.0;

// Suites of many small files are summed up by exit status.
bool is_suite(const std::string& file) {
  return file.find("json_suite") != file.npos || file.find("osm_testdata_grid") != file.npos;
}

std::string suite_of(const std::string& file) {
  return file.substr(0, file.find('/', file.find('/') + 1));
}

std::string outcome(const SurveyRow& row) {
  if (row.hung) return "hung";
  if (row.status >= 128) return "crashed";
  switch (row.status) {
    case 0:
      return "map";
    case 1:
      return row.written + row.changed > 0 ? "map, findings" : "no map";
    case 3:
      return "refused";
    default:
      return "status " + std::to_string(row.status);
  }
}

std::string totals(const SurveyRow& row) {
  if (!row.has_ledger) return "–";
  return std::to_string(row.features) + " = " + std::to_string(row.written) + " + " +
         std::to_string(row.changed) + " + " + std::to_string(row.dropped);
}

std::string codes(const SurveyRow& row) {
  std::string text;
  for (const auto& [code, count] : row.codes) {
    text += (text.empty() ? "" : ", ") + code + " ×" + std::to_string(count);
  }
  return text;
}

// A table's cell: no bars, and no paths of the machine.
std::string cell(std::string text) {
  for (char& c : text) {
    if (c == '|' || c == '\n') c = '/';
  }
  constexpr std::size_t kWidest = 260;
  if (text.size() <= kWidest) return text;
  std::size_t end = kWidest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end) + " …";
}

// The file's own path, however it is reached, is "…".
std::string without_path(std::string message, const std::string& file) {
  for (auto at = message.find(file); at != message.npos; at = message.find(file)) {
    auto begin = at;
    while (begin > 0 && message[begin - 1] != ' ' && message[begin - 1] != '\'') --begin;
    message.replace(begin, at + file.size() - begin, "…");
  }
  return message;
}

void print(const SurveyRow& row) {
  const std::string message = without_path(row.message, row.file);
  std::printf("| %s%s%s | %d %s | %s | %s | %.1f | %s |\n", row.file.c_str(),
              row.options.empty() ? "" : " ", row.options.c_str(), row.status, outcome(row).c_str(),
              totals(row).c_str(), codes(row).c_str(), row.seconds, cell(message).c_str());
}

struct Sum {
  std::map<std::string, std::size_t> outcomes;
  std::size_t features = 0, written = 0, changed = 0, dropped = 0;
  double slowest_s = 0.0;
};

void add(const SurveyRow& row, Sum& sum) {
  ++sum.outcomes[std::to_string(row.status) + " " + outcome(row)];
  sum.features += row.features;
  sum.written += row.written;
  sum.changed += row.changed;
  sum.dropped += row.dropped;
  sum.slowest_s = std::max(sum.slowest_s, row.seconds);
}

void print(const std::string& name, const Sum& sum) {
  std::string outcomes;
  for (const auto& [outcome, count] : sum.outcomes) {
    outcomes += (outcomes.empty() ? "" : ", ") + std::to_string(count) + " × " + outcome;
  }
  std::printf("| %s | %s | %zu = %zu + %zu + %zu | %.1f |\n", name.c_str(), outcomes.c_str(),
              sum.features, sum.written, sum.changed, sum.dropped, sum.slowest_s);
}

constexpr const char* kHead = R"(# Every file of the real data

Made by `build/dev/tests/sources/source_survey build/dev/cli/mapwright ../shared/data > docs/source-survey.md`; not edited by hand. Each
file goes through `mapwright convert FILE -o map.txt --report ledger.json`, and once more with `--local` where it states no CRS.
*Features* is all = written + changed + dropped, as the ledger has them; *reasons* counts the ledger's codes ([pages](checks/README.md));
*s* is processor time, of all processes and on all cores; the message is the first error, else the first warning, with the file's path
as "…". A test (`SourceSurvey`) runs the same files and fails for a crash, a hang, five seconds of processor time, a ledger that does not
balance, or exit status 0 with features lost; for the files of `1_gis` also if the CRS they state is doubted.

| file | exit | features | reasons | s | message |
|---|---|---|---|---|---|
)";

int survey(const std::string& program, const std::string& root) {
  std::fputs(kHead, stdout);
  std::map<std::string, Sum> suites;
  Sum all;
  for (const auto* folder : {"1_gis", "2_hostile", "campus_nord"}) {
    for (const auto& file : vector_files(root, folder)) {
      for (const auto& row : survey_file(program, root, file, kLimit_s)) {
        add(row, all);
        if (is_suite(row.file))
          add(row, suites[suite_of(row.file)]);
        else
          print(row);
      }
    }
  }
  std::puts(
      "\n## Suites, summed up\n\n| suite | exits | features | slowest, s |\n|---|---|---|---|");
  for (const auto& [name, sum] : suites) print(name, sum);
  print("all files", all);
  return 0;
}

}  // namespace
}  // namespace mapwright::test

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: source_survey MAPWRIGHT DATA_FOLDER\n";
    return 2;
  }
  return mapwright::test::survey(std::filesystem::absolute(arguments[1]).string(), arguments[2]);
}
