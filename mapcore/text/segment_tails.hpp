// Private to this folder: what segments end with, made text once for many.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "mapcore/map.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright::text {

/// All of a segment's text behind its ends: "4;1;brick;⏎#⏎".
struct SegmentTail {
  static constexpr std::size_t kShort = 48;

  bool is_short() const { return text.size() <= kShort; }
  /// For short ones: copies the text to `at` and moves `at` behind it; writes kShort bytes,
  /// whatever the length: a few moves, no call.
  void append_to(char*& at) const {
    std::memcpy(at, begin.data(), kShort);
    at += text.size();
  }

  std::string text;
  std::array<char, kShort> begin{};  ///< of the text
};

/// Remembers the tails of the last segments: neighbours differ in height, but a layer has few
/// heights and fewer labels.
class SegmentTails {
 public:
  /// Until the next one is asked for. No reserved characters in `semantic`.
  const SegmentTail& of(double height_m, InOut in_out, std::string_view semantic,
                        const DecimalFormat& numbers);

 private:
  struct Known {
    double height_m = 0.0;
    InOut in_out = InOut::kOutdoor;
    std::string semantic;
    SegmentTail tail;  // without text: none
  };
  static constexpr unsigned kSlotBits = 6;

  std::array<Known, std::size_t{1} << kSlotBits> known_;
};

}  // namespace mapwright::text
