// Compiled once for each instruction set: baseline x86-64, SSE4, AVX2 and AVX-512.
#include "navcore/engine/kernels.hpp"

// Highway switches its 128-bit baseline off for this compiler because of a bug in multiplications
// of integers (GCC 106322). None are multiplied here, and the tests cover the baseline.
#define HWY_BROKEN_EMU128 0
// What lies between the four brings nothing the kernels use.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "navcore/engine/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "navcore/engine/place-inl.hpp"
#include "navcore/engine/weigh-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {

Kernels kernels() {
  return {
      hwy::TargetName(HWY_TARGET), HWY_TARGET, cast_scans, weigh_scans, group_size, place_poses};
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mapwright::navcore::engine {

namespace {

std::vector<Kernels> supported_kernels() {
  std::vector<Kernels> all;
#if HWY_TARGETS & HWY_AVX3
  all.push_back(N_AVX3::kernels());
#endif
#if HWY_TARGETS & HWY_AVX2
  all.push_back(N_AVX2::kernels());
#endif
#if HWY_TARGETS & HWY_SSE4
  all.push_back(N_SSE4::kernels());
#endif
#if !(HWY_STATIC_TARGET & (HWY_AVX3 | HWY_AVX2 | HWY_SSE4))
  all.push_back(HWY_STATIC_DISPATCH(kernels)());
#endif
  const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
  std::erase_if(all, [&](const Kernels& k) { return (k.target & supported) == 0; });
  return all;
}

}  // namespace

const std::vector<Kernels>& kernels_of_this_machine() {
  static const std::vector<Kernels> kKernels = supported_kernels();
  return kKernels;
}

}  // namespace mapwright::navcore::engine
#endif
