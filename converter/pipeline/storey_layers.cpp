#include "converter/pipeline/storey_layers.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <vector>

namespace mapwright::converter {
namespace {

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    const bool divides = c == '_' || c == '-' || c == ' ' || c == '.';
    if (divides)
      words.emplace_back();
    else
      words.back() += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return words;
}

// 1, 02, B1, F2, L3, M1, 4F, EG, OG2, UG.
bool is_storey(const std::string& word) {
  static const std::regex kStorey("[BFLMUPE]?[0-9]{1,2}F?|EG|GF|DG|[OU]G[0-9]?");
  return std::regex_match(word, kStorey);
}

bool lie_above_each_other(const LayerJob& p, const LayerJob& q) {
  const auto below = p.source->extent(p.layer), above = q.source->extent(q.layer);
  return below && above && *below && *above && overlap(**below, **above);
}

}  // namespace

bool overlap(const Box& p, const Box& q) {
  return p.min_x < q.max_x && q.min_x < p.max_x && p.min_y < q.max_y && q.min_y < p.max_y;
}

bool are_names_of_storeys(const std::string& p, const std::string& q) {
  const auto words = words_of(p), others = words_of(q);
  if (words.size() != others.size()) return false;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == others[i]) continue;
    if (++differing > 1 || !is_storey(words[i]) || !is_storey(others[i])) return false;
  }
  return differing == 1;
}

std::optional<std::string> warning_of_storeys(const OpenedSources& sources) {
  const auto& jobs = sources.jobs;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    for (std::size_t k = i + 1; k < jobs.size(); ++k) {
      const auto& p = jobs[i].info().name;
      const auto& q = jobs[k].info().name;
      const bool have_names = are_names_of_storeys(p, q);
      if (!have_names || !lie_above_each_other(jobs[i], jobs[k])) continue;
      return "layers " + p + " and " + q +
             " look like storeys of a building, which a map has one on top of the other: take "
             "those of one, as with --layer '" +
             p + "'";
    }
  }
  return std::nullopt;
}

}  // namespace mapwright::converter
