// One map through the gate.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/support/map_rules.hpp"
#include "cli/support/worker_pool.hpp"
#include "validators/deployment/deployment_gate.hpp"
#include "validators/report/map_record.hpp"

namespace mapwright::cli {

/// Validates a map, sends the robot out, and judges what was found by the rules, which must know
/// the map. `text` is its text where it was read before (standard input). A map that cannot be read
/// is a record that says so.
validators::MapRecord check_map(const std::string& path, const std::optional<std::string>& text,
                                const validators::GateOptions& options, const MapRules& rules);

/// The record of a map whose check a worker did: as it was answered (record_json), or that it was
/// interrupted, and what to do.
validators::MapRecord record_of(const WorkerOutcome& outcome, const std::string& path,
                                const WorkerLimits& limits);

/// Digest of all that a verdict depends on: the text, and the sidecar where there is one. Throws
/// Error (kInput) for a sidecar that cannot be read.
std::string map_digest(const std::string& path, std::string_view text);

/// Digest of the map as it is on disk; nothing where it cannot be read.
std::optional<std::string> digest_on_disk(const std::string& path);

}  // namespace mapwright::cli
