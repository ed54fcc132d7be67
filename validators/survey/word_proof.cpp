#include "validators/survey/word_proof.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

#include "mapcore/text/byte_counts.hpp"
#include "validators/characters.hpp"
#include "validators/survey/repeated_hash.hpp"
#include "validators/vocabulary.hpp"

namespace mapwright::validators {
namespace {

// Words beyond these are judged again each time: a map of names without end must not fill memory.
constexpr std::size_t kMostWords = 4096;

constexpr std::array kKeys{semantic_key::kInnerOf, semantic_key::kNormal, semantic_key::kLevel,
                           semantic_key::kSource, semantic_key::kName};

// As Semantic::tokens trims.
std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Answers `judge(word)`, from memory where it can.
template <class Judge>
bool remembered(WordSet& words, std::string_view word, const Judge& judge) {
  const auto found = words.find(word);
  if (found != words.end()) return found->second;
  const bool answer = judge(word);
  if (words.size() < kMostWords) words.emplace(std::string(word), answer);
  return answer;
}

// All of a token behind its '='.
bool is_plain_value(std::string_view text) {
  return text.front() != ' ' && text.back() != ' ' && text.find(',') == text.npos &&
         text::is_printable_ascii(text);
}

std::size_t slot_of(const char* text, std::size_t slots) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
  const auto address = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(text));
  return (address * kGolden >> 32U) % slots;
}

}  // namespace

std::optional<Words> WordPattern::words_of(std::string_view semantic) const {
  if (text_.empty() || !semantic.starts_with(text_)) return std::nullopt;
  const auto name = semantic.substr(text_.size());
  if (name.empty() == ends_with_name_) return std::nullopt;
  Words words;
  words.are_sound = true;
  words.have_name = ends_with_name_;
  words.name = name;
  if (ends_with_name_ && !is_plain_value(name)) return std::nullopt;
  return words;
}

void WordPattern::learn(std::string_view semantic, const Words& words) {
  text_.clear();
  if (!words.are_sound || words.have_outer || words.have_source || !words.level.empty()) return;
  ends_with_name_ = words.have_name;
  if (!words.have_name) {
    text_ = semantic;
  } else if (words.name.data() + words.name.size() == semantic.data() + semantic.size()) {
    text_ = semantic.substr(0, semantic.size() - words.name.size());
  }
}

bool WordProver::are_sound(const Semantic& semantic) {
  const std::string_view text = semantic.view();
  Known& known = known_[slot_of(text.data(), kKnown)];
  if (known.text.view().data() == text.data()) return known.is_sound;
  // An empty string is a defect of obstacles alone.
  known = {semantic, text.empty() || words_of(text).are_sound};
  return known.is_sound;
}

Words WordProver::words_of(std::string_view semantic) {
  if (const auto words = pattern_.words_of(semantic)) return *words;
  const Words words = judged(semantic);
  pattern_.learn(semantic, words);
  return words;
}

Words WordProver::judged(std::string_view semantic) {
  Words words;
  std::string_view rest = semantic;
  words.are_sound = !unreadable_part(rest);
  known_keys_ = 0;
  bool says_something = false;
  while (true) {
    const auto comma = rest.find(',');
    const auto token = trimmed(rest.substr(0, comma));
    says_something = says_something || !token.empty();
    if (!add_token(token, words)) words.are_sound = false;
    if (comma == rest.npos) break;
    rest.remove_prefix(comma + 1);
  }
  words.are_sound = words.are_sound && says_something;
  return words;
}

// As S123 and S124 see it; false where one of them may have something to say.
bool WordProver::add_token(std::string_view token, Words& words) {
  const auto equals = token.find('=');
  if (equals == token.npos) return is_sound_label(token);
  const auto key = trimmed(token.substr(0, equals));
  const auto value = trimmed(token.substr(equals + 1));
  const auto known = std::find(kKeys.begin(), kKeys.end(), key);
  if (known == kKeys.end()) return !key.empty() && !value.empty() && is_sound_key(key);
  const unsigned bit = 1U << static_cast<unsigned>(known - kKeys.begin());
  const bool is_first = (std::exchange(known_keys_, known_keys_ | bit) & bit) == 0;
  if (key == semantic_key::kName) {
    words.have_name = true;
    words.name = value;
  }
  if (key == semantic_key::kLevel) words.level = value;
  if (key == semantic_key::kInnerOf) words.have_outer = true;
  if (key == semantic_key::kSource) words.have_source = true;
  return is_first && !value.empty();
}

bool WordProver::is_sound_key(std::string_view key) {
  return remembered(keys_, key, [](std::string_view word) { return !key_meant(word); });
}

bool WordProver::is_sound_label(std::string_view label) {
  if (label == last_label_) return true;  // obstacles of a kind follow each other
  if (!remembered(labels_, label, [](std::string_view word) { return !label_meant(word); })) {
    return false;
  }
  last_label_ = label;
  return true;
}

void NameSet::add(std::string_view name, std::string_view level) {
  const std::hash<std::string_view> hash;
  hashes_.push_back(hash(name) ^ (level.empty() ? 0 : std::rotl(hash(level), 31)));
}

bool NameSet::may_repeat() const {
  return some_repeat(hashes_);
}

}  // namespace mapwright::validators
