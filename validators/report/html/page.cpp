#include "validators/report/html/page.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

#include "validators/report/html/page_files.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

// '<' stands within strings of JSON only; written as an escape it can neither end the element nor
// begin a comment in it.
void write_without_markup(std::ostream& out, std::string_view json) {
  while (true) {
    const auto at = json.find('<');
    out << json.substr(0, at);
    if (at == std::string_view::npos) return;
    out << "\\u003c";
    json.remove_prefix(at + 1);
  }
}

Json words_json(const PageWords& words) {
  Json json;
  json["title"] = words.title;
  json["summary"] = words.summary;
  json["levels"] = Json::array();
  for (const auto& level : words.levels) {
    json["levels"].push_back({{"name", level.name}, {"colour", level.colour}});
  }
  json["columns"] = words.columns;
  json["codes"] = Json::parse(words.codes_json);
  return json;
}

}  // namespace

ViewerPage::ViewerPage(std::ostream& out) : out_(out) {
  out_ << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
       << "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
       << page_files::kThemeHash << ' ' << page_files::kScriptHash << "; style-src "
       << page_files::kStyleHash << "; base-uri 'none'; form-action 'none'; "
       << "require-trusted-types-for 'script'\">\n"
       << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
       << "<meta name=\"generator\" content=\"mapwright\">\n<title>mapwright</title>\n"
       << "<script>" << page_files::kTheme << "</script>\n"
       << "<style>" << page_files::kStyle << "</style>\n</head>\n"
       << page_files::kBody;
}

void ViewerPage::data_block(std::string_view attributes, std::string_view json) {
  out_ << "<script type=\"application/json\" " << attributes << '>';
  write_without_markup(out_, json);
  out_ << "</script>\n";
}

void ViewerPage::map(std::string_view found_json, std::string_view scene_json) {
  data_block("class=\"found\"", found_json);
  data_block("class=\"scene\"", scene_json);
}

void ViewerPage::finish(const PageWords& words) {
  data_block("id=\"page\"", words_json(words).dump(-1, ' ', false, Json::error_handler_t::replace));
  out_ << "<script>" << page_files::kScript << "</script>\n</body>\n</html>\n";
}

}  // namespace mapwright::validators
