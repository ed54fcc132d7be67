#include "converter/exchange/edited_styles.hpp"

#include <algorithm>

#include "converter/exchange/edited_semantic.hpp"
#include "converter/exchange/fields.hpp"

namespace mapwright::converter {
namespace {

namespace field = exchange_field;

std::vector<std::string> split(const std::optional<std::string>& list) {
  std::vector<std::string> items;
  if (!list) return items;
  for (std::size_t begin = 0;;) {
    const auto end = list->find(';', begin);
    items.push_back(list->substr(begin, end - begin));
    if (end == list->npos) return items;
    begin = end + 1;
  }
}

InOut in_out_of(const std::string& text) {
  const bool indoor = text == "indoor" || text == "0" || text == "in" || text == "Indoor";
  return indoor ? InOut::kIndoor : InOut::kOutdoor;
}

// Which run each segment belongs to.
std::vector<std::size_t> run_of_segments(const std::vector<std::string>& runs, std::size_t count) {
  std::vector<std::size_t> run_of;
  run_of.reserve(count);
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const auto length = exact_integer(runs[run]).value_or(0);
    for (std::int64_t i = 0; i < length && run_of.size() < count; ++i) run_of.push_back(run);
  }
  run_of.resize(count, runs.empty() ? 0 : runs.size() - 1);
  return run_of;
}

std::vector<double> numbers_of(const std::vector<std::string>& texts) {
  std::vector<double> numbers;
  for (const auto& text : texts) {
    const auto number = exact_number(text);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

// Values of a list by run, if it fits the runs and the summary; else none.
template <class T>
std::vector<T> if_valid(std::vector<T> values, std::size_t runs, bool agrees) {
  if (values.size() != runs || !agrees) values.clear();
  return values;
}

}  // namespace

EditedStyles edited_styles(const FieldText& text, std::size_t count, double default_height_m) {
  EditedStyles edited;
  const auto height = text(field::kHeight);
  const auto height_m = height ? exact_number(*height) : std::nullopt;
  edited.height_is_missing = !height_m;
  const SegmentStyle plain{
      height_m.value_or(default_height_m), in_out_of(text(field::kInOut).value_or("")),
      safe_semantic(text(field::kSegmentSemantic).value_or(""), edited.altered)};

  const auto runs = split(text(field::kRuns));
  auto heights = numbers_of(split(text(field::kHeights)));
  auto in_outs = split(text(field::kInOuts));
  auto semantics = split(text(field::kSegmentSemantics));
  const bool heights_agree =
      !heights.empty() && *std::max_element(heights.begin(), heights.end()) == plain.height_m;
  const bool in_outs_agree = !in_outs.empty() && in_out_of(in_outs.front()) == plain.in_out;
  const bool semantics_agree = !semantics.empty() && semantics.front() == plain.semantic.view();
  heights = if_valid(std::move(heights), runs.size(), heights_agree);
  in_outs = if_valid(std::move(in_outs), runs.size(), in_outs_agree);
  semantics = if_valid(std::move(semantics), runs.size(), semantics_agree);

  std::vector<Semantic> shared;
  for (const auto& semantic : semantics) shared.push_back(safe_semantic(semantic, edited.altered));
  const auto run_of = run_of_segments(runs, count);
  edited.styles.assign(count, plain);
  for (std::size_t i = 0; i < count; ++i) {
    if (!heights.empty()) edited.styles[i].height_m = heights[run_of[i]];
    if (!in_outs.empty()) edited.styles[i].in_out = in_out_of(in_outs[run_of[i]]);
    if (!shared.empty()) edited.styles[i].semantic = shared[run_of[i]];
  }
  return edited;
}

}  // namespace mapwright::converter
