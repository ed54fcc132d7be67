#include "mapcore/text/segment_tails.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "mapcore/text/characters.hpp"

namespace mapwright::text {
namespace {

SegmentTail tail_of(double height_m, InOut in_out, std::string_view semantic,
                    const DecimalFormat& numbers) {
  std::array<char, DecimalFormat::kMaxCharacters> height;
  SegmentTail tail;
  tail.text.assign(height.data(), numbers.write(height.data(), height_m));
  tail.text += in_out == InOut::kIndoor ? ";0;" : ";1;";
  tail.text += trimmed(semantic);
  tail.text += ";\n#\n";
  std::copy_n(tail.text.data(), std::min(tail.text.size(), SegmentTail::kShort), tail.begin.data());
  return tail;
}

}  // namespace

const SegmentTail& SegmentTails::of(double height_m, InOut in_out, std::string_view semantic,
                                    const DecimalFormat& numbers) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
  const std::uint64_t key = std::bit_cast<std::uint64_t>(height_m) + semantic.size();
  Known& known = known_[key * kGolden >> (64U - kSlotBits)];
  const bool fits = !known.tail.text.empty() && known.height_m == height_m &&
                    known.in_out == in_out && known.semantic == semantic;
  if (!fits) {
    known = {height_m, in_out, std::string(semantic), tail_of(height_m, in_out, semantic, numbers)};
  }
  return known.tail;
}

}  // namespace mapwright::text
