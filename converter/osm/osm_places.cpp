#include "converter/osm/osm_places.hpp"

#include <algorithm>
#include <osmium/osm/location.hpp>

namespace mapwright::converter {
namespace {

constexpr std::size_t kBlock = 64;

}  // namespace

// Of equal ids the last stays. Most files have their nodes in order.
void OsmPlaces::sort() {
  const auto before = [](const Entry& a, const Entry& b) { return a.node < b.node; };
  const auto same = [](const Entry& a, const Entry& b) { return a.node == b.node; };
  if (!std::is_sorted(nodes_.begin(), nodes_.end(), before)) {
    std::stable_sort(nodes_.begin(), nodes_.end(), before);
  }
  nodes_.erase(nodes_.begin(), std::unique(nodes_.rbegin(), nodes_.rend(), same).base());
}

void OsmPlaces::finish() {
  // Before the nodes and backwards, so that the last of one id is the one that counts.
  nodes_.insert(nodes_.begin(), of_ways_.rbegin(), of_ways_.rend());
  of_ways_ = {};
  sort();
  for (std::size_t i = 0; i < nodes_.size(); i += kBlock) {
    first_of_blocks_.push_back(nodes_[i].node);
  }
}

const OsmPlaces::Entry* OsmPlaces::entry_of(std::int64_t node) const {
  const auto next = std::upper_bound(first_of_blocks_.begin(), first_of_blocks_.end(), node);
  if (next == first_of_blocks_.begin()) return nullptr;
  const auto block = static_cast<std::size_t>(next - first_of_blocks_.begin() - 1);
  const auto first = nodes_.begin() + static_cast<std::ptrdiff_t>(block * kBlock);
  const auto last =
      nodes_.begin() + static_cast<std::ptrdiff_t>(std::min((block + 1) * kBlock, nodes_.size()));
  const auto found = std::lower_bound(
      first, last, node, [](const Entry& entry, std::int64_t id) { return entry.node < id; });
  return found != last && found->node == node ? &*found : nullptr;
}

std::optional<Point> OsmPlaces::find(std::int64_t node) const {
  const auto* entry = entry_of(node);
  if (entry == nullptr) return std::nullopt;
  const osmium::Location place(entry->place.x, entry->place.y);
  return Point{place.lon_without_check(), place.lat_without_check()};
}

}  // namespace mapwright::converter
