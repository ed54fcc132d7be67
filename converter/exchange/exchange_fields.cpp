#include "converter/exchange/exchange_fields.hpp"

#include <charconv>
#include <cmath>

#include "converter/exchange/carried_fields.hpp"
#include "converter/exchange/fields.hpp"

namespace mapwright::converter {

ExchangeFields::ExchangeFields(std::vector<std::string> layer_fields)
    : layer_fields_(std::move(layer_fields)),
      carriers_(existing_fields(layer_fields_, {"rawcodevalues"})) {}

// Columns are looked up once: the field, and those its long texts go on in.
const std::vector<Field>& ExchangeFields::columns(std::string_view name) const {
  if (const auto known = columns_.find(name); known != columns_.end()) return known->second;
  std::vector<Field> found;
  for (int number = 1;; ++number) {
    const Field field(layer_fields_,
                      number == 1 ? std::string(name) : continued_field(std::string(name), number));
    if (!field.exists()) break;
    found.push_back(field);
  }
  return columns_.emplace(std::string(name), std::move(found)).first->second;
}

void ExchangeFields::load(const SourceFeature& feature) {
  feature_ = &feature;
  carried_.reset();
  for (const auto& carrier : carriers_) {
    if (const auto text = carrier.text(feature); text && !carried_) {
      carried_ = read_carried_items(*text);
    }
  }
}

bool ExchangeFields::has(std::string_view name) const {
  return carried_ ? carried_->find(name) != carried_->end() : !columns(name).empty();
}

std::optional<std::string> ExchangeFields::text(std::string_view name) const {
  if (carried_) {
    const auto found = carried_->find(name);
    return found == carried_->end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<std::string> whole;
  for (const auto& column : columns(name)) {
    const auto piece = column.text(*feature_);
    if (!piece) break;
    whole = whole.value_or("") + *piece;
  }
  return whole;
}

std::optional<double> ExchangeFields::number(std::string_view name) const {
  const auto value = text(name);
  return value ? exact_number(*value) : std::nullopt;
}

std::optional<std::int64_t> ExchangeFields::integer(std::string_view name) const {
  const auto value = text(name);
  if (!value) return std::nullopt;
  if (const auto whole = exact_integer(*value)) return whole;
  const auto real = exact_number(*value);  // formats without whole numbers, editors that write 3.0
  if (!real || *real != std::round(*real) || std::abs(*real) > 9.0e15) return std::nullopt;
  return static_cast<std::int64_t>(*real);
}

std::optional<double> exact_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> exact_integer(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace mapwright::converter
