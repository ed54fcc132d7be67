// Private to this folder: Proof, at one look, that the checks of semantic strings have nothing to
// say.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mapcore/semantic.hpp"

namespace mapwright::validators {

/// What a semantic string holds.
struct Words {
  bool are_sound = false;    ///< proven: S104, S123 and S124 are silent, for an obstacle S103 too
  bool have_name = false;    ///< a token name=..., maybe an empty one
  bool have_outer = false;   ///< a token inner_of=...
  bool have_source = false;  ///< a token source=...
  std::string_view name, level;  ///< values, where they are sound
};

/// Words, and whether they are sound.
struct WordHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view word) const {
    return std::hash<std::string_view>()(word);
  }
};
using WordSet = std::unordered_map<std::string, bool, WordHash, std::equal_to<>>;

/// The last sound string, without its name where it ends with one: those that follow are mostly the
/// same, or the same with another name.
class WordPattern {
 public:
  /// Nothing where the string is another one.
  std::optional<Words> words_of(std::string_view semantic) const;

  void learn(std::string_view semantic, const Words& words);

 private:
  std::string text_;  // empty: none
  bool ends_with_name_ = false;
};

/// Judges one string after another; remembers words it has met, and the last strings that many
/// share.
class WordProver {
 public:
  /// The answer lasts as long as the string.
  Words words_of(std::string_view semantic);

  /// The same, for strings that many share: known by where they lie.
  bool are_sound(const Semantic& semantic);

 private:
  Words judged(std::string_view semantic);
  bool is_sound_key(std::string_view key);
  bool is_sound_label(std::string_view label);
  bool add_token(std::string_view token, Words& words);

  // Held, so that no other string comes to lie there.
  struct Known {
    Semantic text;
    bool is_sound = true;
  };
  static constexpr std::size_t kKnown = 256;

  WordPattern pattern_;  // of the strings of obstacles, and of segments that differ from theirs
  WordSet labels_, keys_;
  std::string last_label_;  // a sound one
  std::array<Known, kKnown> known_;
  unsigned known_keys_ = 0;  // of the string under way: a bit each
};

/// Remembers names by their hashes: where none came twice, no name did.
class NameSet {
 public:
  void add(std::string_view name, std::string_view level);

  /// False only if no name was added twice for a level. They are looked at now, and not when they
  /// came: a table of all of them does not fit into the cache.
  bool may_repeat() const;

 private:
  std::vector<std::uint64_t> hashes_;
};

}  // namespace mapwright::validators
