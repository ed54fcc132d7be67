// "Did you mean": the known word that a mistyped one was meant to be.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace mapwright::text {

/// Fewest insertions, deletions, replacements of single bytes and swaps of neighbours that turn one
/// word into the other (optimal string alignment distance).
std::size_t edit_distance(std::string_view p, std::string_view q);

/// The candidate nearest to `word`, capitals apart, if it is near enough to be meant: at most a
/// third of its bytes are wrong. Of equally near ones the first.
std::optional<std::string_view> near_word(std::string_view word,
                                          const std::vector<std::string_view>& candidates);

}  // namespace mapwright::text
