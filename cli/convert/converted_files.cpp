#include "cli/convert/converted_files.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/support/error.hpp"
#include "cli/support/map_files.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "validators/validator.hpp"

namespace mapwright::cli {
namespace {

void write_text(const TemporaryFile& file, const std::string& name, const std::string& text) {
  std::ofstream out(file.path(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw Error(ExitStatus::kOutput, name + ": cannot be written to its end");
}

}  // namespace

ConvertedFiles::ConvertedFiles(const std::string& output, const std::string& report)
    : output_(output) {
  if (output != "-") {
    map_ = std::make_unique<TemporaryFile>(output);
    sidecar_ = std::make_unique<TemporaryFile>(sidecar_path(output));
  }
  if (!report.empty()) report_ = std::make_unique<TemporaryFile>(report);
}

std::vector<Finding> ConvertedFiles::write_map(Map map, double resolution_m, Console& console,
                                               bool is_last) {
  if (!map_) {
    std::string text = format_map(map, {resolution_m});
    console.out() << text;
    return validators::validate(read_map(std::move(text)));
  }
  std::ofstream out(map_->path(), std::ios::binary);
  mapwright::write_map(map, out, {resolution_m});
  out.close();
  if (!out) throw Error(ExitStatus::kOutput, output_ + ": cannot be written to its end");
  map = {};  // before another one like it is read
  auto document = std::make_unique<MapDocument>(read_map_file(map_->path()));
  auto findings = validators::validate(*document);
  if (is_last) keep_to_the_end(std::move(document));
  return findings;
}

// A sidecar of an earlier map under this name would put the new one where it does not lie.
void ConvertedFiles::write_sidecar(const std::optional<Georeference>& georeference) {
  if (!sidecar_) return;
  const std::string path = sidecar_path(output_);
  if (georeference) return write_text(*sidecar_, path, format_georeference(*georeference));
  sidecar_.reset();
  if (std::filesystem::exists(path)) {
    throw Error(ExitStatus::kOutput, path +
                                         ": belongs to another map of this name, and the new one "
                                         "has no place on Earth: remove it or choose another name");
  }
}

void ConvertedFiles::write_report(const converter::Ledger& ledger) {
  if (report_) write_text(*report_, "report", converter::format_ledger(ledger));
}

void ConvertedFiles::commit_map() {
  if (map_) map_->commit();
  if (sidecar_) sidecar_->commit();
}

void ConvertedFiles::commit_report() {
  if (report_) report_->commit();
}

}  // namespace mapwright::cli
