// Areas and figures from a field of values.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "navcore/localizability/localizability.hpp"

namespace mapwright::navcore {
namespace {

bool is_weak(const LocalizabilityField& field, const WeaknessLimits& limits, Weakness weakness,
             std::size_t i) {
  if (field.stands[i] == 0) return false;
  return weakness == Weakness::kInaccurate
             ? field.accuracy[i].edges_median.with_edges.major_m > limits.accuracy_m
             : field.median_risk(i) > limits.risk;
}

// Takes the cells that are joined with `start` out of `weak`.
std::vector<std::size_t> take_joined(const PlaceGrid& grid, std::vector<char>& weak,
                                     std::size_t start) {
  std::vector<std::size_t> cells{start};
  weak[start] = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t i = cells[k];
    const auto take = [&](std::size_t j) {
      if (weak[j] == 0) return;
      weak[j] = 0;
      cells.push_back(j);
    };
    if (i % grid.columns > 0) take(i - 1);
    if (i % grid.columns + 1 < grid.columns) take(i + 1);
    if (i >= grid.columns) take(i - grid.columns);
    if (i + grid.columns < grid.size()) take(i + grid.columns);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

WeakArea area_of(const LocalizabilityField& field, Weakness weakness,
                 std::vector<std::size_t> cells) {
  WeakArea area;
  area.weakness = weakness;
  area.area_m2 = static_cast<double>(cells.size()) * field.grid.cell_area_m2();
  Point sum;
  std::vector<double> accuracies_m;
  for (const std::size_t i : cells) {
    const Box cell = field.grid.box(i);
    area.box.add({cell.min_x, cell.min_y});
    area.box.add({cell.max_x, cell.max_y});
    sum = sum + field.grid.center(i);
    accuracies_m.push_back(field.accuracy[i].edges_median.with_edges.major_m);
    if (field.median_risk(i) > area.risk) {
      area.risk = field.median_risk(i);
      area.riskiest = i;
    }
  }
  const Point mean = (1.0 / static_cast<double>(cells.size())) * sum;
  area.middle = *std::min_element(cells.begin(), cells.end(), [&](std::size_t p, std::size_t q) {
    return squared_length(field.grid.center(p) - mean) <
           squared_length(field.grid.center(q) - mean);
  });
  const auto middle = accuracies_m.begin() + static_cast<std::ptrdiff_t>(accuracies_m.size() / 2);
  std::nth_element(accuracies_m.begin(), middle, accuracies_m.end());
  area.accuracy_m = *middle;
  area.cells = std::move(cells);
  return area;
}

Spread spread_of(std::vector<double> values, double limit) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {  // nearest rank
    const auto rank =
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(rank, 1) - 1];
  };
  const auto above = values.end() - std::upper_bound(values.begin(), values.end(), limit);
  return {quantile(0.5), quantile(0.75), quantile(0.9), quantile(0.95),
          static_cast<double>(above) / static_cast<double>(values.size())};
}

}  // namespace

std::vector<WeakArea> weak_areas(const LocalizabilityField& field, const WeaknessLimits& limits) {
  std::vector<WeakArea> areas;
  for (const Weakness weakness : {Weakness::kInaccurate, Weakness::kConfusable}) {
    std::vector<char> weak(field.grid.size());
    for (std::size_t i = 0; i < weak.size(); ++i) {
      weak[i] = is_weak(field, limits, weakness, i) ? 1 : 0;
    }
    std::vector<WeakArea> own;
    for (std::size_t i = 0; i < weak.size(); ++i) {
      if (weak[i] == 0) continue;
      WeakArea area = area_of(field, weakness, take_joined(field.grid, weak, i));
      if (area.area_m2 >= limits.min_area_m2) own.push_back(std::move(area));
    }
    std::stable_sort(own.begin(), own.end(),
                     [](const auto& p, const auto& q) { return p.area_m2 > q.area_m2; });
    areas.insert(areas.end(), std::make_move_iterator(own.begin()),
                 std::make_move_iterator(own.end()));
  }
  return areas;
}

LocalizabilitySummary summary_of(const LocalizabilityField& field, const WeaknessLimits& limits) {
  LocalizabilitySummary summary;
  const auto spread = [&](double limit, auto&& value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < field.grid.size(); ++i) {
      if (field.stands[i] != 0) values.push_back(value(i));
    }
    return spread_of(std::move(values), limit);
  };
  const auto& accuracy = field.accuracy;
  for (const char stands : field.stands) summary.places += stands != 0 ? 1 : 0;
  summary.area_m2 = static_cast<double>(summary.places) * field.grid.cell_area_m2();
  const double limit = limits.accuracy_m;
  summary.worst_m = spread(limit, [&](std::size_t i) { return accuracy[i].worst.bound.major_m; });
  summary.median_m = spread(limit, [&](std::size_t i) { return accuracy[i].median.bound.major_m; });
  summary.edges_worst_m =
      spread(limit, [&](std::size_t i) { return accuracy[i].edges_worst.with_edges.major_m; });
  summary.edges_median_m =
      spread(limit, [&](std::size_t i) { return accuracy[i].edges_median.with_edges.major_m; });
  summary.heading_median_deg = spread(5.0, [&](std::size_t i) {
    return accuracy[i].median.bound.heading_rad * 180.0 / std::numbers::pi;
  });
  summary.risk_worst = spread(limits.risk, [&](std::size_t i) { return field.worst_risk(i); });
  summary.risk_median = spread(limits.risk, [&](std::size_t i) { return field.median_risk(i); });
  return summary;
}

}  // namespace mapwright::navcore
