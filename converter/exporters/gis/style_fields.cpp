#include "converter/exporters/gis/style_fields.hpp"

#include <algorithm>
#include <functional>

#include "converter/exchange/decimal_text.hpp"
#include "converter/exchange/fields.hpp"

namespace mapwright::converter {
namespace {

std::string in_out_text(InOut in_out) {
  return in_out == InOut::kIndoor ? "indoor" : "outdoor";
}

// One segment of each run of like ones, and how many there are.
struct Runs {
  std::vector<const Segment*> first;
  std::vector<std::size_t> lengths;
};

Runs runs_of(std::span<const Segment> segments) {
  Runs runs;
  for (const auto& segment : segments) {
    if (runs.first.empty() || !same_style(*runs.first.back(), segment)) {
      runs.first.push_back(&segment);
      runs.lengths.push_back(0);
    }
    ++runs.lengths.back();
  }
  return runs;
}

std::string listed(const Runs& runs, const std::function<std::string(const Segment&)>& text) {
  std::string list;
  for (const auto* segment : runs.first) {
    if (segment != runs.first.front()) list += ';';
    list += text(*segment);
  }
  return list;
}

void append_lists(const Runs& runs, std::vector<NamedValue>& fields) {
  namespace field = exchange_field;
  std::string lengths;
  for (const std::size_t length : runs.lengths) {
    lengths += (lengths.empty() ? "" : ";") + std::to_string(length);
  }
  fields.emplace_back(field::kRuns, lengths);
  const auto differs = [&](const auto& same) {
    return std::any_of(runs.first.begin(), runs.first.end(),
                       [&](const Segment* s) { return !same(*s, *runs.first.front()); });
  };
  if (differs([](const auto& p, const auto& q) { return p.height_m == q.height_m; })) {
    fields.emplace_back(field::kHeights, listed(runs, [](const Segment& s) {
                          return shortest_decimal(s.height_m);
                        }));
  }
  if (differs([](const auto& p, const auto& q) { return p.in_out == q.in_out; })) {
    fields.emplace_back(field::kInOuts,
                        listed(runs, [](const Segment& s) { return in_out_text(s.in_out); }));
  }
  if (differs([](const auto& p, const auto& q) { return p.semantic == q.semantic; })) {
    fields.emplace_back(field::kSegmentSemantics,
                        listed(runs, [](const Segment& s) { return s.semantic.str(); }));
  }
}

}  // namespace

bool same_style(const Segment& p, const Segment& q) {
  return p.height_m == q.height_m && p.in_out == q.in_out && p.semantic == q.semantic;
}

std::vector<NamedValue> style_fields(std::span<const Segment> segments) {
  namespace field = exchange_field;
  std::vector<NamedValue> fields;
  if (segments.empty()) return fields;
  const auto runs = runs_of(segments);
  double highest = segments.front().height_m;
  for (const auto* segment : runs.first) highest = std::max(highest, segment->height_m);
  fields.emplace_back(field::kHeight, highest);
  fields.emplace_back(field::kInOut, in_out_text(segments.front().in_out));
  fields.emplace_back(field::kSegmentSemantic, segments.front().semantic.str());
  if (runs.first.size() > 1) append_lists(runs, fields);
  return fields;
}

}  // namespace mapwright::converter
