#include "validators/fix/record_text.hpp"

#include <cassert>
#include <charconv>
#include <iterator>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright::validators {
namespace {

template <std::size_t count>
std::optional<RecordText<count>> record_at(std::string_view text, std::size_t begin,
                                           std::size_t first_field) {
  RecordText<count> record;
  record.begin = begin;
  const std::size_t hash = text.find('#', first_field);
  if (hash == text.npos) return std::nullopt;
  text::FieldWalker walker(text, first_field, hash);
  for (auto& field : record.fields) {
    field = walker.next();
    if (!field.closed) return std::nullopt;
  }
  if (skip_blanks(text, walker.at()) != hash) return std::nullopt;
  record.end = hash + 1;
  return record;
}

bool stands_alone(std::string_view text, std::size_t begin) {
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
  return begin == 0 || text[begin - 1] == '\n';
}

}  // namespace

std::string edited(std::string_view text, const std::vector<OffsetEdit>& edits) {
  std::string result;
  result.reserve(text.size());
  std::size_t done = 0;
  for (const auto& edit : edits) {
    assert(done <= edit.begin && edit.begin <= edit.end);
    result.append(text.substr(done, edit.begin - done)).append(edit.replacement);
    done = edit.end;
  }
  return result.append(text.substr(done));
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && text::is_blank(text[at])) ++at;
  return at;
}

std::optional<SegmentText> segment_text(const MapDocument& document, std::size_t obstacle,
                                        std::size_t segment) {
  const auto& index = document.index;
  const auto offset = index.segment_offset(document.text, obstacle, segment);
  return record_at<7>(document.text, offset, offset);
}

std::optional<HeaderText> header_text_at(std::string_view text, std::size_t offset) {
  std::size_t at = offset;
  while (at < text.size() && text::is_letter(text[at])) ++at;
  at = skip_blanks(text, at);
  if (at >= text.size() || text[at] != ';') return std::nullopt;
  return record_at<4>(text, offset, at + 1);
}

std::optional<HeaderText> header_text(const MapDocument& document, std::size_t obstacle) {
  return header_text_at(document.text, document.index.obstacle_offsets[obstacle]);
}

std::optional<HeaderText> border_text(const MapDocument& document) {
  if (document.index.border_offset == TextIndex::kNowhere) return std::nullopt;
  return header_text_at(document.text, document.index.border_offset);
}

std::optional<std::vector<SegmentText>> segment_texts(const MapDocument& document,
                                                      std::size_t obstacle) {
  std::vector<SegmentText> texts;
  const std::size_t count = document.map.obstacles[obstacle].segments.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto text = segment_text(document, obstacle, k);
    if (!text) return std::nullopt;
    texts.push_back(*text);
  }
  return texts;
}

OffsetEdit field_edit(const text::Field& field, std::string replacement) {
  return {field.offset, field.offset + field.text.size(), std::move(replacement)};
}

OffsetEdit removal(std::string_view text, std::size_t begin, std::size_t end) {
  std::size_t behind = end;
  while (behind < text.size() && (text[behind] == ' ' || text[behind] == '\t')) ++behind;
  if (!stands_alone(text, begin)) return {begin, end, ""};
  if (behind < text.size() && text[behind] == '\r') ++behind;
  if (behind < text.size() && text[behind] == '\n') return {begin, behind + 1, ""};
  return {begin, behind, ""};
}

std::string number_text(double value) {
  static const text::DecimalFormat kFine(1e-9);
  char buffer[text::DecimalFormat::kMaxCharacters];
  const std::string rounded(buffer, kFine.write(buffer, value));
  if (text::read_number(rounded).value == value) return rounded;
  const auto [end, error] =
      std::to_chars(std::begin(buffer), std::end(buffer), value, std::chars_format::fixed);
  return {buffer, end};
}

}  // namespace mapwright::validators
