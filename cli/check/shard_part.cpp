#include "cli/check/shard_part.hpp"

#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "cli/support/digest.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::map<std::string, std::string>;

constexpr std::string_view kSchema = "mapwright.check/1";

std::string dumped(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json header_json(const ShardHeader& header) {
  Json json;
  json["part"] = header.shard.part;
  json["parts"] = header.shard.parts;
  json["program"] = header.settings.program;
  json["fingerprint"] = header.settings.fingerprint();
  json["options"] = header.settings.options;
  json["limits"] = header.settings.limits;
  json["maps"] = header.maps;
  json["map_set"] = header.map_set;
  json["today"] = validators::date_text(header.today);
  json["configurations"] = Json::array();
  for (const auto& [path, policy] : header.configurations) {
    if (!path.empty()) json["configurations"].push_back({{"path", path}, {"text", policy.text}});
  }
  return json;
}

// Read once more: with the profile that was chosen, which gives its findings their severity.
Policies parse_configurations(const Json& json, const RunSettings& settings) {
  const auto profile = settings.options.find("profile");
  Policies policies;
  for (const auto& file : json) {
    const auto path = file.at("path").get<std::string>();
    policies[path] = value_or_throw(validators::read_policy(
        file.at("text").get<std::string>(), path,
        profile == settings.options.end() ? std::string_view() : profile->second));
  }
  return policies;
}

ShardHeader parse_header(const Json& json) {
  ShardHeader header;
  header.shard = {json.at("part").get<std::size_t>(), json.at("parts").get<std::size_t>()};
  header.settings = {json.at("program").get<std::string>(), json.at("options").get<Values>(),
                     json.at("limits").get<Values>()};
  header.maps = json.at("maps").get<std::size_t>();
  header.map_set = json.at("map_set").get<std::string>();
  header.today = validators::parse_date(json.at("today").get<std::string>()).value();
  header.configurations = parse_configurations(json.at("configurations"), header.settings);
  return header;
}

class PartSink : public RecordSink {
 public:
  PartSink(const ShardHeader& header, std::ostream& out) : out_(out) {
    out_ << "{\n\"schema\": \"" << kSchema << "\",\n\"shard\": " << dumped(header_json(header), 2)
         << ",\n\"maps\": [";
  }

  void add(const validators::MapRecord& record) override {
    out_ << (first_ ? "\n" : ",\n") << record_json(record);
    first_ = false;
  }

  void add_configuration(const validators::MapReport&) override {}

  void finish() override { out_ << (first_ ? "]\n}\n" : "\n]\n}\n"); }

 private:
  std::ostream& out_;
  bool first_ = true;
};

[[noreturn]] void fail_part(const std::string& path, const std::string& why) {
  throw Error(ExitStatus::kInput, path + ": " + why);
}

ShardPart part_of(const std::string& path, const Json& json) {
  if (!json.is_object() || json.value("schema", "") != kSchema || !json.contains("shard")) {
    fail_part(
        path,
        "is no part of a report; 'mapwright check MAP... --shard i/n --format json' writes them");
  }
  ShardPart part{path, parse_header(json.at("shard")), {}};
  for (const auto& map : json.at("maps")) {
    auto record = validators::parse_record(dumped(map));
    if (!record) fail_part(path, record.error().message);
    part.records.push_back(*std::move(record));
  }
  return part;
}

}  // namespace

ShardHeader shard_header(const Shard& shard, const RunSettings& settings,
                         const std::vector<MapInput>& maps, const Policies& configurations,
                         validators::Date today) {
  std::vector<std::string_view> paths;
  for (const auto& map : maps) paths.push_back(display_path(map.path));
  return {shard, settings, maps.size(), digest(paths), configurations, today};
}

std::unique_ptr<RecordSink> make_part_sink(const ShardHeader& header, std::ostream& out) {
  return std::make_unique<PartSink>(header, out);
}

ShardPart read_part(const std::string& path) {
  const std::string text = read_file(path);
  try {
    return part_of(path, Json::parse(text));
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {  // of JSON, or of a value that is missing
    fail_part(path, std::string("is no part of a report, or not all of it: ") + error.what());
  }
}

}  // namespace mapwright::cli
