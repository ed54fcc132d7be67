#include "cli/support/ray_engine.hpp"

#include <string>

#include "cli/support/error.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/culled_ray_caster.hpp"

namespace mapwright::cli {

void declare_engine_option(boost::program_options::options_description& options,
                           const char* default_engine) {
  namespace po = boost::program_options;
  options.add_options()(
      "engine", po::value<std::string>()->default_value(default_engine),
      "ray caster: fast (single precision, ranges to 0.1 mm; last digits depend on the processor), "
      "culled (the report's method, double precision) or brute (every ray against every segment)");
}

RayEngineKind ray_engine_kind(const boost::program_options::variables_map& values) {
  const auto name = values["engine"].as<std::string>();
  if (name == "fast") return RayEngineKind::kFast;
  if (name == "culled") return RayEngineKind::kCulled;
  if (name == "brute") return RayEngineKind::kBrute;
  fail_usage("--engine is fast, culled or brute, not '" + name + "'");
}

RayEngine::RayEngine(const Map& map, RayEngineKind kind) {
  if (kind == RayEngineKind::kFast) {
    const auto engine = std::make_shared<const navcore::ScanEngine>(map);
    caster_ = engine;
    weigher_ = engine;
    return;
  }
  if (kind == RayEngineKind::kCulled) {
    caster_ = std::make_shared<const navcore::CulledRayCaster>(map);
  } else {
    caster_ = std::make_shared<const navcore::BruteForceRayCaster>(map);
  }
  weigher_ = std::make_shared<const navcore::RayCastingWeigher>(*caster_);
}

}  // namespace mapwright::cli
