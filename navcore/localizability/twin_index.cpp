#include "navcore/localizability/twin_index.hpp"

#include <CGAL/Orthogonal_incremental_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <algorithm>

namespace mapwright::navcore {
namespace {

using Entry = TwinIndex::Entry;

/// A digest as CGAL's kd-tree wants its points.
struct Key {
  ScanDigest digest{};
  std::uint32_t entry = 0;
};

struct Coordinates {
  using result_type = const float*;
  const float* operator()(const Key& key) const { return key.digest.data(); }
  const float* operator()(const Key& key, int) const { return key.digest.data() + kSectors; }
};

using Traits = CGAL::Search_traits<float, Key, const float*, Coordinates,
                                   CGAL::Dimension_tag<static_cast<int>(kSectors)>>;
using Search = CGAL::Orthogonal_incremental_neighbor_search<Traits>;

// Many poses beside one that looks alike do so too: after so many the search gives up.
constexpr std::size_t kMostVisited = 400;

}  // namespace

struct TwinIndex::Impl {
  std::vector<Entry> entries;
  Search::Tree tree;
};

ScanDigest digest_of(std::span<const float> ranges) {
  ScanDigest digest{};
  for (std::size_t s = 0; s < kSectors; ++s) {
    const std::size_t first = s * ranges.size() / kSectors;
    const std::size_t end = std::max(first + 1, (s + 1) * ranges.size() / kSectors);
    float sum = 0.0F;
    for (std::size_t i = first; i < end; ++i) sum += ranges[std::min(i, ranges.size() - 1)];
    digest[s] = sum / static_cast<float>(end - first);
  }
  return digest;
}

TwinIndex::TwinIndex(std::vector<Entry> entries) {
  auto impl = std::make_unique<Impl>();
  impl->entries = std::move(entries);
  std::vector<Key> keys;
  keys.reserve(impl->entries.size());
  for (const Entry& entry : impl->entries) {
    keys.push_back({entry.digest, static_cast<std::uint32_t>(keys.size())});
  }
  impl->tree.insert(keys.begin(), keys.end());
  if (!keys.empty()) impl->tree.build();  // here, since it is not safe from many threads later
  impl_ = std::move(impl);
}
TwinIndex::TwinIndex(TwinIndex&&) noexcept = default;
TwinIndex& TwinIndex::operator=(TwinIndex&&) noexcept = default;
TwinIndex::~TwinIndex() = default;

std::vector<Pose> TwinIndex::most_similar(const ScanDigest& digest, Point from, double apart_m,
                                          std::size_t count) const {
  std::vector<Pose> found;
  if (impl_->entries.empty()) return found;
  const double apart2 = apart_m * apart_m;
  Search search(impl_->tree, Key{digest, 0});
  std::size_t visited = 0;
  for (auto it = search.begin(); it != search.end() && found.size() < count; ++it) {
    if (++visited > kMostVisited) break;
    const Pose& pose = impl_->entries[it->first.entry].pose;
    const auto near = [&](Point p) { return squared_length(pose.position() - p) <= apart2; };
    if (near(from)) continue;
    if (std::any_of(found.begin(), found.end(),
                    [&](const Pose& other) { return near(other.position()); })) {
      continue;
    }
    found.push_back(pose);
  }
  return found;
}

}  // namespace mapwright::navcore
