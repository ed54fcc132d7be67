#include "mapcore/text/defects.hpp"

#include <algorithm>

#include "mapcore/text/characters.hpp"

namespace mapwright::text {
namespace {

bool is_number(std::string_view text) {
  return read_number(text).status == NumberStatus::kOk;
}

// `text` with the first `what` in it replaced.
std::string replaced(std::string_view text, std::string_view what, std::string_view by) {
  const auto at = text.find(what);
  if (at == text.npos) return std::string(text);
  std::string result(text.substr(0, at));
  result.append(by).append(text.substr(at + what.size()));
  return result;
}

// "1,5" with a decimal comma; empty for other texts.
std::string with_decimal_point(std::string_view text) {
  const std::string pointed = replaced(text, ",", ".");
  return pointed != text && is_number(pointed) ? pointed : "";
}

// U+2212, the minus sign of word processors, as the hyphen of programs; empty for other texts.
std::string with_hyphen(std::string_view text) {
  const std::string hyphenated = replaced(text, "\xE2\x88\x92", "-");
  return hyphenated != text && is_number(hyphenated) ? hyphenated : "";
}

std::string decimal_comma_advice(std::string_view text) {
  const std::string pointed = with_decimal_point(text);
  if (pointed.empty()) return {};
  return quoted(text) + " has a decimal comma; write " + pointed;
}

std::string minus_sign_advice(std::string_view text) {
  const std::string hyphenated = with_hyphen(text);
  if (hyphenated.empty()) return {};
  return quoted(text) + " has the character U+2212 for its minus sign; write " + hyphenated;
}

// What is certainly meant; "5 m" may be five of something else.
std::optional<std::string> meant(std::string_view text) {
  for (const auto correct : {with_decimal_point, with_hyphen}) {
    if (std::string number = correct(text); !number.empty()) return number;
  }
  return std::nullopt;
}

// "4.53 12.10" or "5 m".
std::string several_words_advice(std::string_view text) {
  const auto gap = std::find_if(text.begin(), text.end(), is_blank);
  if (gap == text.end()) return {};
  const auto first = text.substr(0, static_cast<std::size_t>(gap - text.begin()));
  if (!is_number(first)) return {};
  const auto rest = trimmed(text.substr(first.size()));
  if (is_number(rest)) return quoted(text) + " are two numbers; put a ';' between them";
  return quoted(text) + " is more than a number; write " + std::string(first) +
         " (all lengths are metres)";
}

// "5m", "12.1ft".
std::string unit_advice(std::string_view text) {
  std::size_t end = text.size();
  while (end > 0 && is_letter(text[end - 1])) --end;
  const auto number = text.substr(0, end);
  if (end == text.size() || !is_number(number)) return {};
  return quoted(text) + " is more than a number; write " + std::string(number) +
         " (all lengths are metres)";
}

std::string advice(std::string_view text) {
  for (const auto advise :
       {decimal_comma_advice, minus_sign_advice, several_words_advice, unit_advice}) {
    if (std::string words = advise(text); !words.empty()) return words;
  }
  return quoted(text) + " is not a number";
}

}  // namespace

std::string Subject::name() const {
  const auto obstacle_name = [&] {
    return obstacle ? "obstacle " + std::to_string(*obstacle) : std::string("an obstacle");
  };
  switch (kind) {
    case Kind::kBorder:
      return "border";
    case Kind::kObstacle:
      return obstacle_name();
    case Kind::kSegment:
      break;
  }
  if (!segment) return "a segment";
  return "segment " + std::to_string(*segment) + " of " + obstacle_name();
}

void Defects::add(FindingCode code, std::size_t offset, std::string message) {
  defects_.push_back({offset, make_finding(code, std::move(message)), {}});
}

void Defects::add(FindingCode code, std::size_t offset, const Subject& subject,
                  std::string_view message) {
  Finding finding = make_finding(code, subject.name() + ": " + std::string(message));
  finding.obstacle = subject.obstacle;
  finding.segment = subject.segment;
  defects_.push_back({offset, std::move(finding), {}});
}

void Defects::fix(std::size_t begin, std::size_t end, std::string replacement) {
  defects_.back().fix = OffsetEdit{begin, end, std::move(replacement)};
}

void Defects::show(DefectGeometry geometry) {
  defects_.back().finding.geometry = std::move(geometry);
}

std::vector<Finding> Defects::findings(std::string_view text, const TextIndex& index) && {
  std::stable_sort(defects_.begin(), defects_.end(),
                   [](const Defect& p, const Defect& q) { return p.offset < q.offset; });
  std::vector<Finding> findings;
  findings.reserve(defects_.size());
  for (auto& defect : defects_) {
    defect.finding.place = index.place_at(text, defect.offset);
    if (auto& fix = defect.fix) {
      defect.finding.fix.push_back({index.place_at(text, fix->begin),
                                    index.place_at(text, fix->end), std::move(fix->replacement)});
    }
    findings.push_back(std::move(defect.finding));
  }
  return findings;
}

NumberComplaint number_complaint(std::string_view field_name, std::string_view text,
                                 NumberStatus status) {
  const std::string field(field_name);
  if (text.empty()) return {FindingCode::F109, field + " is empty; write a number"};
  if (status == NumberStatus::kNonFinite) {
    return {FindingCode::F110, field + " is " + quoted(text) + "; write a finite number"};
  }
  if (status == NumberStatus::kOutOfRange) {
    return {FindingCode::F118, field + " " + quoted(text) + " is too large to hold"};
  }
  return {FindingCode::F109, field + " " + advice(text), meant(text)};
}

NumberComplaint integer_complaint(std::string_view field_name, std::string_view text,
                                  NumberStatus status) {
  const std::string field(field_name);
  if (text.empty()) return {FindingCode::F111, field + " is empty; write a whole number"};
  if (status == NumberStatus::kOutOfRange) {
    return {FindingCode::F118, field + " " + quoted(text) +
                                   " is too large to hold; the greatest is 9223372036854775807"};
  }
  return {FindingCode::F111, field + " " + quoted(text) + " is not a whole number"};
}

}  // namespace mapwright::text
