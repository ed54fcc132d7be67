#include <algorithm>
#include <set>

#include "cli/check/shard_part.hpp"
#include "cli/support/digest.hpp"
#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

using validators::MapRecord;
using Values = std::map<std::string, std::string>;

std::string value_in(const Values& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? "not given" : found->second;
}

// Throws for the first value that differs.
void require_same(const ShardPart& a, const ShardPart& b, const std::string& what,
                  const std::string& in_a, const std::string& in_b) {
  if (in_a == in_b) return;
  fail_usage("the parts are not of one run: " + what + " is " + in_a + " in " + a.file + " and " +
             in_b + " in " + b.file);
}

void require_same_options(const ShardPart& a, const ShardPart& b, const Values& in_a,
                          const Values& in_b) {
  Values all = in_a;
  all.insert(in_b.begin(), in_b.end());
  for (const auto& [name, value] : all) {
    require_same(a, b, "--" + name, value_in(in_a, name), value_in(in_b, name));
  }
}

void require_same_run(const ShardPart& a, const ShardPart& b) {
  const auto& [shard_a, settings_a, maps_a, map_set_a, configurations_a, today_a] = a.header;
  const auto& [shard_b, settings_b, maps_b, map_set_b, configurations_b, today_b] = b.header;
  // Configurations and what the day makes of them are among the options, as a digest.
  require_same(a, b, "the program's version", settings_a.program, settings_b.program);
  require_same_options(a, b, settings_a.options, settings_b.options);
  require_same_options(a, b, settings_a.limits, settings_b.limits);
  require_same(a, b, "the number of parts", std::to_string(shard_a.parts),
               std::to_string(shard_b.parts));
  require_same(a, b, "the number of maps", std::to_string(maps_a), std::to_string(maps_b));
  require_same(a, b, "the digest of their paths", map_set_a, map_set_b);
}

using PartList = std::vector<const ShardPart*>;

PartList by_number(const std::vector<ShardPart>& parts) {
  PartList sorted;
  for (const auto& part : parts) sorted.push_back(&part);
  std::stable_sort(sorted.begin(), sorted.end(), [](const ShardPart* a, const ShardPart* b) {
    return a->header.shard.part < b->header.shard.part;
  });
  return sorted;
}

void require_each_once(const PartList& parts) {
  const std::size_t count = parts.front()->header.shard.parts;
  std::string missing;
  std::size_t next = 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t number = parts[i]->header.shard.part;
    if (i > 0 && number == parts[i - 1]->header.shard.part) {
      fail_usage("part " + std::to_string(number) + " is there twice: " + parts[i - 1]->file +
                 " and " + parts[i]->file);
    }
    for (; next < number; ++next) missing += " " + std::to_string(next);
    next = number + 1;
  }
  for (; next <= count; ++next) missing += " " + std::to_string(next);
  if (missing.empty()) return;
  fail_usage("of " + std::to_string(count) + " parts these are missing:" + missing +
             "; a report is merged from all of them");
}

void require_all_maps(const std::vector<MapRecord>& records, const ShardHeader& header) {
  std::vector<std::string_view> paths;
  for (const auto& record : records) paths.push_back(record.path);
  if (records.size() == header.maps && digest(paths) == header.map_set) return;
  throw Error(ExitStatus::kInput, "the parts hold " + std::to_string(records.size()) +
                                      " maps, but not the " + std::to_string(header.maps) +
                                      " that were to be checked: a part was changed");
}

}  // namespace

std::vector<validators::MapReport> configuration_reports(const ShardPart& part,
                                                         const std::vector<MapRecord>& records) {
  std::set<std::string> used;
  for (const auto& record : records) {
    for (const auto& suppressed : record.suppressed) used.insert(suppressed.by);
  }
  return policy_reports(part.header.configurations, used, true, part.header.today);
}

std::vector<MapRecord> merged(const std::vector<ShardPart>& parts) {
  for (const auto& part : parts) require_same_run(parts.front(), part);
  require_each_once(by_number(parts));
  std::vector<MapRecord> records;
  for (const auto& part : parts) {
    records.insert(records.end(), part.records.begin(), part.records.end());
  }
  std::sort(records.begin(), records.end(),
            [](const MapRecord& a, const MapRecord& b) { return a.path < b.path; });
  require_all_maps(records, parts.front().header);
  return records;
}

}  // namespace mapwright::cli
