// Parts of a report, each of one shard of the maps, and the whole they make.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "cli/check/record_sink.hpp"
#include "cli/check/run_settings.hpp"
#include "cli/support/map_list.hpp"
#include "cli/support/policy_reports.hpp"
#include "validators/report/map_record.hpp"

namespace mapwright::cli {

/// What a part says of itself and of the whole.
struct ShardHeader {
  Shard shard;
  RunSettings settings;
  std::size_t maps = 0;     ///< of all shards
  std::string map_set;      ///< digest of the paths of all shards
  Policies configurations;  ///< of all shards' maps
  validators::Date today;
};

struct ShardPart {
  std::string file;  ///< to name it
  ShardHeader header;
  std::vector<validators::MapRecord> records;
};

/// `maps` are those of all shards.
ShardHeader shard_header(const Shard& shard, const RunSettings& settings,
                         const std::vector<MapInput>& maps, const Policies& configurations,
                         validators::Date today);

/// A part: a JSON report of schema mapwright.check/1 with a member "shard", and in each map what a
/// report in another format needs (record_json).
std::unique_ptr<RecordSink> make_part_sink(const ShardHeader& header, std::ostream& out);

/// Throws Error (kInput) for a file that cannot be read or is no part.
ShardPart read_part(const std::string& path);

/// What check would say of the configuration files behind all maps; refers to `part`, any of them.
std::vector<validators::MapReport> configuration_reports(
    const ShardPart& part, const std::vector<validators::MapRecord>& records);

/// All records, by path. Throws Error (kUsage) that names files and difference unless the parts are
/// all parts of one whole, each once.
std::vector<validators::MapRecord> merged(const std::vector<ShardPart>& parts);

}  // namespace mapwright::cli
