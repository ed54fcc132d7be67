#include "validators/vocabulary.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "mapcore/semantic.hpp"
#include "mapcore/text/near_word.hpp"

namespace mapwright::validators {
namespace {

constexpr std::array kKeys{semantic_key::kInnerOf, semantic_key::kNormal, semantic_key::kLevel,
                           semantic_key::kSource, semantic_key::kName};

// Of five letters and more: shorter words resemble too many others.
constexpr std::array<std::string_view, 20> kLabels{
    "bench",    "bollard",   "brick",    "building",  "cement", "column", "courtyard",
    "fence",    "flowerpot", "fountain", "furniture", "glass",  "hedge",  "indoor",
    "monument", "outdoor",   "planter",  "railing",   "stairs", "table"};
constexpr std::size_t kShortest = 5;

std::string folded(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-' || c == ' ') c = '_';
  }
  return text;
}

bool is_one_slip_away(std::string_view p, std::string_view q) {
  const std::size_t difference = p.size() < q.size() ? q.size() - p.size() : p.size() - q.size();
  return difference <= 1 && text::edit_distance(p, q) == 1;
}

bool is_plural(std::string_view p, std::string_view q) {
  const auto [shorter, longer] = p.size() < q.size() ? std::pair(p, q) : std::pair(q, p);
  return longer.size() == shorter.size() + 1 && longer.ends_with('s') &&
         longer.starts_with(shorter);
}

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::optional<std::string_view> key_meant(std::string_view key) {
  if (contains(kKeys, key)) return std::nullopt;
  const std::string word = folded(key);
  for (const auto known : kKeys) {
    if (word == known || is_one_slip_away(word, known)) return known;
  }
  return std::nullopt;
}

// "ledge" is no hedge and "cable" no table: the first letter is rarely the wrong one.
std::optional<std::string_view> label_meant(std::string_view label) {
  if (label.size() + 1 < kShortest || contains(kLabels, label)) return std::nullopt;
  for (const auto known : kLabels) {
    if (label.front() != known.front() || is_plural(label, known)) continue;
    if (is_one_slip_away(label, known)) return known;
  }
  return std::nullopt;
}

}  // namespace mapwright::validators
