// Stands in where Embree is not installed.
#include <cassert>

#include "bench/embree_rays.hpp"

namespace mapwright::bench {

struct EmbreeRays::Impl {};

bool EmbreeRays::is_available() {
  return false;
}

std::string EmbreeRays::name(Mode) {
  return {};
}

EmbreeRays::EmbreeRays(const Map&, double) {
  assert(false);
}
EmbreeRays::~EmbreeRays() = default;

std::size_t EmbreeRays::memory_bytes() const {
  return 0;
}

void EmbreeRays::cast(Mode, std::span<const Pose>, const navcore::LaserModel&,
                      std::span<float>) const {}

}  // namespace mapwright::bench
