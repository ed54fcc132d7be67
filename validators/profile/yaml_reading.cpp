#include "validators/profile/yaml_reading.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <tuple>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/near_word.hpp"

namespace mapwright::validators {
namespace {

std::string number_text(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(std::begin(buffer), std::end(buffer), value);
  return {buffer, end};
}

}  // namespace

void YamlMistakes::add(const YAML::Mark& mark, const std::string& message) {
  const TextPlace place{static_cast<std::size_t>(std::max(mark.line, 0)) + 1,
                        static_cast<std::size_t>(std::max(mark.column, 0)) + 1};
  const bool is_known = std::any_of(
      mistakes_.begin(), mistakes_.end(),
      [&](const Mistake& mistake) { return mistake.place == place && mistake.message == message; });
  if (!is_known) mistakes_.push_back({place, message});
}

void YamlMistakes::add_unknown(const YAML::Node& node, std::string_view kind, std::string_view word,
                               const std::vector<std::string_view>& known) {
  std::string message = "there is no " + std::string(kind) + " " + text::quoted(word);
  if (const auto meant = text::near_word(word, known)) {
    add(node, message + "; did you mean " + std::string(*meant) + "?");
    return;
  }
  std::string all;
  for (const auto name : known) all += (all.empty() ? "" : ", ") + std::string(name);
  constexpr std::size_t kShownNames = 200;
  add(node, all.empty() || all.size() > kShownNames ? message : message + "; there are " + all);
}

std::string YamlMistakes::text() const {
  auto sorted = mistakes_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Mistake& p, const Mistake& q) {
    return std::tie(p.place.line, p.place.column) < std::tie(q.place.line, q.place.column);
  });
  std::string text;
  for (const auto& [place, message] : sorted) {
    text += (text.empty() ? "" : "\n") + path_ + ":" + std::to_string(place.line) + ":" +
            std::to_string(place.column) + ": error: " + message;
  }
  return text;
}

TextPlace place_of(const YAML::Node& node) {
  const auto mark = node.Mark();
  return {static_cast<std::size_t>(std::max(mark.line, 0)) + 1,
          static_cast<std::size_t>(std::max(mark.column, 0)) + 1};
}

std::optional<std::string> yaml_text(const YAML::Node& node, YamlMistakes& mistakes) {
  if (node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  mistakes.add(node, "expected one value here");
  return std::nullopt;
}

std::optional<double> yaml_number(const YAML::Node& node, double least, double most,
                                  YamlMistakes& mistakes) {
  const auto text = yaml_text(node, mistakes);
  if (!text) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc{} || end != text->data() + text->size() || !std::isfinite(value)) {
    mistakes.add(node, text::quoted(*text) + " is not a number");
    return std::nullopt;
  }
  if (least <= value && value <= most) return value;
  mistakes.add(node, *text + " is not from " + number_text(least) + " to " + number_text(most));
  return std::nullopt;
}

std::optional<std::int64_t> yaml_integer(const YAML::Node& node, YamlMistakes& mistakes) {
  const auto text = yaml_text(node, mistakes);
  if (!text) return std::nullopt;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error == std::errc{} && end == text->data() + text->size()) return value;
  mistakes.add(node, text::quoted(*text) + " is not a whole number");
  return std::nullopt;
}

void read_entries(
    const YAML::Node& node, YamlMistakes& mistakes,
    const std::function<void(const std::string&, const YAML::Node&, const YAML::Node&)>& read) {
  if (!node.IsMap()) {
    mistakes.add(node, "expected lines 'key: value' here");
    return;
  }
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const auto key = yaml_text(entry.first, mistakes);
    if (!key) continue;
    if (seen.insert(*key).second) {
      read(*key, entry.first, entry.second);
    } else {
      mistakes.add(entry.first, text::quoted(*key) + " stands here a second time");
    }
  }
}

void read_keys(const YAML::Node& node, YamlMistakes& mistakes, const std::vector<YamlKey>& keys) {
  read_entries(node, mistakes,
               [&](const std::string& key, const YAML::Node& key_node, const YAML::Node& value) {
                 const auto known = std::find_if(keys.begin(), keys.end(),
                                                 [&](const YamlKey& k) { return k.key == key; });
                 if (known != keys.end()) return known->read(value);
                 std::vector<std::string_view> names;
                 for (const auto& k : keys) names.push_back(k.key);
                 mistakes.add_unknown(key_node, "key", key, names);
               });
}

}  // namespace mapwright::validators
