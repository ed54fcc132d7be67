#include "cli/convert/converted_files.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "cli/support/error.hpp"
#include "cli/support/map_files.hpp"
#include "cli/support/validated_map.hpp"
#include "mapcore/georeference.hpp"

namespace mapwright::cli {
namespace {

void write_stream(const TemporaryFile& file, const std::string& name,
                  const std::function<void(std::ostream&)>& write) {
  // The file is new and empty. One that is cut to nothing once more is written to the disk by some
  // file systems (ext4) while it is closed, at our cost.
  std::ofstream out(file.path(), std::ios::binary | std::ios::app);
  write(out);
  out.close();
  if (!out) throw Error(ExitStatus::kOutput, name + ": cannot be written to its end");
}

}  // namespace

ConvertedFiles::ConvertedFiles(const std::string& output, const std::string& report)
    : output_(output), report_name_(report) {
  if (output != "-") {
    map_ = std::make_unique<TemporaryFile>(output);
    sidecar_ = std::make_unique<TemporaryFile>(sidecar_path(output));
  }
  if (!report.empty() && report != "-") report_ = std::make_unique<TemporaryFile>(report);
}

std::vector<Finding> ConvertedFiles::write_map(converter::ConvertedMap map, double resolution_m,
                                               Console& console, bool is_last) {
  if (!map_) {
    std::ostringstream out;
    map.write(out, {resolution_m});
    map = {};  // before the text of it is read
    std::string text = std::move(out).str();
    console.out() << text;
    return validated_text(std::move(text), {}, console.progress("validating")).findings;
  }
  write_stream(*map_, output_, [&](std::ostream& out) {
    map.write(out, {resolution_m}, console.progress("writing"));
  });
  map = {};
  auto validated = validated_file(map_->path(), {}, console.progress("validating"));
  if (is_last) keep_to_the_end(std::make_unique<MapDocument>(std::move(validated.document)));
  return std::move(validated.findings);
}

std::vector<Finding> ConvertedFiles::write_map(Map map, double resolution_m, Console& console) {
  return write_map(converter::ConvertedMap(std::move(map)), resolution_m, console);
}

// A sidecar of an earlier map under this name would put the new one where it does not lie.
void ConvertedFiles::write_sidecar(const std::optional<Georeference>& georeference) {
  if (!sidecar_) return;
  const std::string path = sidecar_path(output_);
  if (georeference) {
    return write_stream(*sidecar_, path,
                        [&](std::ostream& out) { out << format_georeference(*georeference); });
  }
  sidecar_.reset();
  if (std::filesystem::exists(path)) {
    throw Error(ExitStatus::kOutput, path +
                                         ": belongs to another map of this name, and the new one "
                                         "has no place on Earth: remove it or choose another name");
  }
}

void ConvertedFiles::write_report(const converter::Ledger& ledger, Console& console) {
  if (report_name_ == "-") {
    converter::write_ledger(ledger, console.out());
    console.out().flush();  // with --watch a reader waits for it
    return;
  }
  if (!report_) return;
  write_stream(*report_, report_name_,
               [&](std::ostream& out) { converter::write_ledger(ledger, out); });
  report_->commit();
}

void ConvertedFiles::commit_map() {
  if (map_) map_->commit();
  if (sidecar_) sidecar_->commit();
}

}  // namespace mapwright::cli
