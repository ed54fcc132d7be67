#include "tests/sources/survey.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "mapcore/finding.hpp"

namespace mapwright::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::array<const char*, 21> kExtensions{
    ".shp", ".gpkg", ".geojson", ".json", ".topojson", ".fgb",    ".kml",
    ".kmz", ".gml",  ".xml",     ".dxf",  ".dwg",      ".osm",    ".osc",
    ".gz",  ".pbf",  ".csv",     ".zip",  ".tar",      ".sqlite", ".vrt"};

bool is_lone_table(const fs::path& file) {
  return file.extension() == ".dbf" && !fs::exists(fs::path(file).replace_extension(".shp"));
}

bool is_vector_file(const fs::path& file) {
  if (file.filename() == "test.json") return false;  // what a suite expects
  const auto extension = file.extension().string();
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end() ||
         extension == ".js" || is_lone_table(file);
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A folder of the run's own.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "mapwright-survey.XXXXXX").string();
    if (::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void become(const std::string& program, const fs::path& root, std::vector<std::string> arguments,
            const fs::path& messages) {
  const int nowhere = ::open("/dev/null", O_RDWR);
  const int out = ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  if (::chdir(root.c_str()) != 0) ::_exit(127);
  arguments.insert(arguments.begin(), program);
  std::vector<char*> words;
  for (auto& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  ::execv(words[0], words.data());
  ::_exit(127);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Status of a process, and whether it had to be ended. `cpu_s`: its processor time and that of the
// processes it waited for.
std::pair<int, bool> wait_for(pid_t process, double limit_s, double& cpu_s) {
  const auto end = Clock::now() + std::chrono::duration<double>(limit_s);
  int status = 0;
  bool hung = false;
  rusage usage{};
  while (::wait4(process, &status, hung ? 0 : WNOHANG, &usage) == 0) {
    if (Clock::now() > end) {
      ::kill(process, SIGKILL);
      hung = true;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), hung};
}

void read_ledger(const fs::path& report, SurveyRow& row) {
  const auto json = nlohmann::json::parse(text_of(report), nullptr, false);
  if (json.is_discarded() || !json.contains("totals")) return;
  row.has_ledger = true;
  const auto& totals = json["totals"];
  row.features = totals["features"];
  row.written = totals["written"];
  row.changed = totals["changed"];
  row.dropped = totals["dropped"];
  for (const auto& feature : json["features"]) {
    for (const auto& reason : feature["reasons"]) {
      const std::string code = reason["code"];
      ++row.codes[code];
      const auto known = finding_code(code);
      row.loses = row.loses || (known && finding_type(*known).severity == Severity::kError);
    }
  }
}

// The first error, else the first warning, without the program's name.
std::string first_message(const std::string& text) {
  std::istringstream lines(text);
  std::string best;
  for (std::string line; std::getline(lines, line);) {
    for (const char* sign : {"error: ", "warning: "}) {
      const auto at = line.find(sign);
      if (at == line.npos) continue;
      const bool is_error = sign[0] == 'e';
      if (is_error) return line.substr(at);
      if (best.empty()) best = line.substr(at);
    }
  }
  return best;
}

SurveyRow run(const std::string& program, const fs::path& root, const fs::path& file,
              const std::vector<std::string>& more, double limit_s) {
  const Folder folder;
  SurveyRow row;
  row.file = file.generic_string();
  for (const auto& option : more) row.options += (row.options.empty() ? "" : " ") + option;
  const auto report = folder.path() / "ledger.json";
  std::vector<std::string> arguments{"convert",  file.string(),
                                     "-o",       (folder.path() / "map.txt").string(),
                                     "--report", report.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const pid_t child = ::fork();
  if (child == 0) become(program, root, arguments, folder.path() / "messages");
  std::tie(row.status, row.hung) = wait_for(child, limit_s, row.seconds);
  read_ledger(report, row);
  const auto messages = text_of(folder.path() / "messages");
  row.message = first_message(messages);
  row.doubts_crs = messages.find("warning: ") != messages.npos &&
                   (messages.find(" is said to be in ") != messages.npos ||
                    messages.find("may be exchanged") != messages.npos);
  return row;
}

}  // namespace

std::vector<fs::path> vector_files(const fs::path& root, const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (entry.is_regular_file() && is_vector_file(entry.path())) {
      files.push_back(fs::relative(entry.path(), root));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<SurveyRow> survey_file(const std::string& program, const fs::path& root,
                                   const fs::path& file, double limit_s) {
  std::vector<SurveyRow> rows{run(program, root, file, {}, limit_s)};
  if (rows[0].message.find("states no coordinate reference system") != std::string::npos) {
    rows.push_back(run(program, root, file, {"--local"}, limit_s));
  }
  return rows;
}

}  // namespace mapwright::test
