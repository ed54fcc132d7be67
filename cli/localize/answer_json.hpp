// Private to this folder: pieces that JSON answers of localize share.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "cli/localize/recorded_question.hpp"
#include "navcore/localization/particles.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::cli {

using Json = nlohmann::ordered_json;

/// Rows [x, y, theta_deg, weight].
Json particles_json(const navcore::ParticleSet& particles);

/// {"median", "p95"}, null where there is nothing.
Json spread_json(const std::optional<navcore::MedianAndP95>& spread);

/// Settings of a run over a log.
Json recorded_settings_json(const RecordedQuestion& question);

}  // namespace mapwright::cli
