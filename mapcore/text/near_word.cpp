#include "mapcore/text/near_word.hpp"

#include <algorithm>
#include <string>

namespace mapwright::text {
namespace {

std::string in_small_letters(std::string_view word) {
  std::string small(word);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

}  // namespace

std::size_t edit_distance(std::string_view p, std::string_view q) {
  std::vector<std::size_t> before(q.size() + 1), last(q.size() + 1), row(q.size() + 1);
  for (std::size_t j = 0; j <= q.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= p.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= q.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (p[i - 1] == q[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && p[i - 1] == q[j - 2] && p[i - 2] == q[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[q.size()];
}

std::optional<std::string_view> near_word(std::string_view word,
                                          const std::vector<std::string_view>& candidates) {
  constexpr std::size_t kLongestWord = 100;  // nobody mistypes longer ones; bounds the work
  if (word.size() > kLongestWord) return std::nullopt;
  const std::string small = in_small_letters(word);
  std::optional<std::string_view> nearest;
  std::size_t least = SIZE_MAX;
  for (const auto candidate : candidates) {
    const std::size_t distance = edit_distance(small, in_small_letters(candidate));
    if (distance >= least || 3 * distance > candidate.size()) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace mapwright::text
