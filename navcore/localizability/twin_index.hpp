// Private to this folder: finds scans that look alike.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mapcore/angle.hpp"

namespace mapwright::navcore {

/// A scan in a few numbers: mean ranges of as many equal sectors of the field of view.
inline constexpr std::size_t kSectors = 10;
using ScanDigest = std::array<float, kSectors>;

ScanDigest digest_of(std::span<const float> ranges);

/// The poses of a map by the digests of their scans. Immutable; safe to use from many threads.
class TwinIndex {
 public:
  struct Entry {
    ScanDigest digest{};
    Pose pose;
  };

  explicit TwinIndex(std::vector<Entry> entries);
  TwinIndex(TwinIndex&&) noexcept;
  TwinIndex& operator=(TwinIndex&&) noexcept;
  ~TwinIndex();

  /// Up to `count` poses with the most similar digests that are farther than `apart_m` from `from`
  /// and from each other, the most similar first.
  std::vector<Pose> most_similar(const ScanDigest& digest, Point from, double apart_m,
                                 std::size_t count) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace mapwright::navcore
