// Which ray caster a verb works with: the option --engine.
#pragma once

#include <boost/program_options.hpp>
#include <memory>

#include "mapcore/map.hpp"
#include "navcore/localization/scan_weigher.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::cli {

enum class RayEngineKind {
  kFast,    ///< whole scans at a time, single precision, the machine's vector instructions
  kCulled,  ///< the report's method, double precision
  kBrute,   ///< every ray against every segment, double precision
};

/// Adds --engine with that default ("fast", "culled" or "brute").
void declare_engine_option(boost::program_options::options_description& options,
                           const char* default_engine);

/// What it says. Throws Error (kUsage) for another word.
RayEngineKind ray_engine_kind(const boost::program_options::variables_map& values);

/// A ray caster of a map, and what weighs scans with it.
class RayEngine {
 public:
  RayEngine(const Map& map, RayEngineKind kind);

  const navcore::RayCaster& caster() const { return *caster_; }
  const navcore::ScanWeigher& weigher() const { return *weigher_; }

 private:
  std::shared_ptr<const navcore::RayCaster> caster_;
  std::shared_ptr<const navcore::ScanWeigher> weigher_;
};

}  // namespace mapwright::cli
