// Private to this folder: moves chosen lanes together.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_PACKING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_PACKING_INL
#undef MAPWRIGHT_ENGINE_PACKING_INL
#else
#define MAPWRIGHT_ENGINE_PACKING_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "navcore/engine/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::RebindToSigned<Floats>;
using IntVector = hn::Vec<Ints>;

// The positions of the bits of a byte, lowest first.
using BitPositions = std::array<std::array<std::uint8_t, 8>, 256>;

constexpr BitPositions bit_positions() {
  BitPositions all{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    std::size_t count = 0;
    for (std::uint8_t bit = 0; bit < 8; ++bit) {
      if ((byte >> bit & 1U) != 0) all[byte][count++] = bit;
    }
  }
  return all;
}

alignas(kLine) inline constexpr BitPositions kPositions = bit_positions();

HWY_INLINE std::uint32_t bits_of(FloatMask mask) {
  const Floats d;
  std::uint8_t bytes[8];
  hn::StoreMaskBits(d, mask, bytes);
  if (hn::Lanes(d) <= 8) return bytes[0];
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

// The lanes of a mask, lowest first. (Highway's Compress, of the version that Debian has, copies a
// table each time where there is no instruction for it.)
class ChosenLanes {
 public:
  HWY_INLINE explicit ChosenLanes(FloatMask mask) {
#if HWY_TARGET <= HWY_AVX3
    numbers_ = hn::Compress(hn::Iota(Ints(), 0), hn::RebindMask(Ints(), mask));
    count_ = hn::CountTrue(Floats(), mask);
#else
    const std::uint32_t bits = bits_of(mask);
    const hn::Rebind<std::uint8_t, Ints> bytes;
    numbers_ = hn::PromoteTo(Ints(), hn::Load(bytes, kPositions[bits].data()));
    count_ = static_cast<std::size_t>(__builtin_popcount(bits));
#endif
  }

  HWY_INLINE std::size_t count() const {
    return count_;
  }

  // Lane numbers in the first count() lanes, and some in the others.
  HWY_INLINE IntVector numbers() const {
    return numbers_;
  }

  HWY_INLINE FloatVector pack(FloatVector v) const {
    return hn::TableLookupLanes(v, hn::IndicesFromVec(Floats(), numbers_));
  }

 private:
  IntVector numbers_;
  std::size_t count_;
};

// Calls f(lane) for each lane of the mask, of which there rarely are any.
template <class F>
HWY_INLINE void for_rare_lanes(FloatMask mask, F&& f) {
  for (std::uint32_t bits = bits_of(mask); HWY_UNLIKELY(bits != 0); bits &= bits - 1) {
    f(static_cast<std::uint32_t>(__builtin_ctz(bits)));
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
