#include "converter/indoorgml/storeys.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

namespace mapwright::converter {
namespace {

constexpr double kLeastStorey_m = 2.0;
constexpr double kLeastGap_m = 1.0;  // between floors: on ramps they follow each other closely

// "1-2" stands on 1, and "-1" on -1.
std::string first_named(const std::string& name, const std::set<std::string>& whole) {
  const auto dash = name.find('-', 1);
  if (dash == name.npos || name.empty()) return name;
  const auto first = name.substr(0, dash);
  return whole.count(first) > 0 ? first : name;
}

std::string height_name(double floor) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", std::round(floor * 100.0) / 100.0 + 0.0);
  return text;
}

class Sorter {
 public:
  Sorter(const IndoorDocument& document, const std::vector<std::optional<Footprint>>& footprints)
      : document_(document), footprints_(footprints) {
    for (const auto& cell : document.cells) {
      if (!cell.storey.empty()) names_.insert(cell.storey);
    }
  }

  std::vector<Storey> sort() {
    place_named_cells();
    place_cells_by_height();
    for (std::size_t i = 0; i < document_.boundaries.size(); ++i) place_boundary(i);
    for (auto& storey : storeys_) std::sort(storey.cells.begin(), storey.cells.end());
    std::stable_sort(storeys_.begin(), storeys_.end(), [](const Storey& p, const Storey& q) {
      return p.floor && q.floor ? *p.floor < *q.floor : !p.floor && q.floor;
    });
    return std::move(storeys_);
  }

 private:
  std::size_t named(const std::string& name) {
    const auto [found, is_new] = numbers_.try_emplace(name, storeys_.size());
    if (is_new) storeys_.push_back({name, std::nullopt, {}, {}});
    return found->second;
  }

  std::optional<double> floor_of(std::size_t cell) const {
    return footprints_[cell] ? footprints_[cell]->floor : std::nullopt;
  }

  void add_cell(std::size_t storey, std::size_t cell) {
    auto& target = storeys_[storey];
    target.cells.push_back(cell);
    storey_of_cell_[cell] = storey;
    const auto floor = floor_of(cell);
    if (floor) target.floor = std::min(target.floor.value_or(*floor), *floor);
  }

  void place_named_cells() {
    std::map<std::string, std::vector<std::size_t>> cells;
    for (std::size_t i = 0; i < document_.cells.size(); ++i) {
      const auto& name = document_.cells[i].storey;
      if (!name.empty()) cells[first_named(name, names_)].push_back(i);
    }
    for (const auto& [name, own] : cells) {
      for (const std::size_t cell : own) add_cell(named(name), cell);
    }
  }

  // The storey whose floor is the highest that is not above the height; nothing below all.
  std::optional<std::size_t> storey_at(double z) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < storeys_.size(); ++i) {
      const auto& floor = storeys_[i].floor;
      if (!floor || *floor > z + 0.5) continue;
      if (!best || *floor > *storeys_[*best].floor) best = i;
    }
    return best;
  }

  void place_cells_by_height() {
    std::vector<std::pair<double, std::size_t>> open;
    for (std::size_t i = 0; i < document_.cells.size(); ++i) {
      if (storey_of_cell_.count(i) > 0) continue;
      open.emplace_back(floor_of(i).value_or(std::numeric_limits<double>::infinity()), i);
    }
    std::sort(open.begin(), open.end());
    const bool any_named = !storeys_.empty();
    double below = open.empty() ? 0.0 : open.front().first;  // the floor before
    for (const auto& [floor, cell] : open) {
      if (!std::isfinite(floor)) {
        add_cell(storeys_.empty() ? named("") : 0, cell);
        continue;
      }
      const auto storey = storey_at(floor);
      const bool is_new = !storey || (!any_named && floor - below >= kLeastGap_m &&
                                      floor - *storeys_[*storey].floor >= kLeastStorey_m);
      below = floor;
      add_cell(is_new ? named(height_name(floor)) : *storey, cell);
    }
  }

  std::optional<std::size_t> storey_of_cells(const std::string& boundary) {
    if (cell_of_boundary_.empty()) {
      for (std::size_t i = 0; i < document_.cells.size(); ++i) {
        for (const auto& id : document_.cells[i].boundaries) cell_of_boundary_.try_emplace(id, i);
      }
    }
    const auto cell = cell_of_boundary_.find(boundary);
    if (cell == cell_of_boundary_.end()) return std::nullopt;
    return storey_of_cell_.at(cell->second);
  }

  void place_boundary(std::size_t i) {
    const auto& boundary = document_.boundaries[i];
    const auto name = first_named(boundary.storey, names_);
    std::optional<std::size_t> storey;
    if (const auto known = numbers_.find(name); known != numbers_.end()) storey = known->second;
    if (!storey) storey = storey_of_cells(boundary.id);
    if (const auto foot = foot_of(boundary); !storey && foot) storey = storey_at(*foot);
    storeys_[storey ? *storey : storeys_.empty() ? named(name) : 0].boundaries.push_back(i);
  }

  const IndoorDocument& document_;
  const std::vector<std::optional<Footprint>>& footprints_;
  std::set<std::string> names_;
  std::vector<Storey> storeys_;
  std::unordered_map<std::string, std::size_t> numbers_;
  std::unordered_map<std::size_t, std::size_t> storey_of_cell_;
  std::unordered_map<std::string, std::size_t> cell_of_boundary_;
};

}  // namespace

std::optional<double> foot_of(const IndoorObject& object) {
  if (!object.has_heights) return std::nullopt;
  double foot = std::numeric_limits<double>::infinity();
  for (const auto& face : object.faces) {
    for (const auto& vertex : face.rings.front()) foot = std::min(foot, vertex.z);
  }
  for (const auto& line : object.lines) {
    for (const auto& vertex : line) foot = std::min(foot, vertex.z);
  }
  return std::isfinite(foot) ? std::optional(foot) : std::nullopt;
}

std::vector<Storey> storeys_of(const IndoorDocument& document,
                               const std::vector<std::optional<Footprint>>& footprints) {
  return Sorter(document, footprints).sort();
}

}  // namespace mapwright::converter
