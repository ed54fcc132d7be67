#include "mapcore/text/document.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "mapcore/text/byte_counts.hpp"
#include "mapcore/text/characters.hpp"

namespace mapwright {
namespace {

// The place behind `text`, which begins at `place`.
TextPlace advanced(TextPlace place, std::string_view text) {
  const std::size_t breaks = text::count_byte(text, '\n');
  if (breaks == 0) return {place.line, place.column + text::count_characters(text)};
  return {place.line + breaks, 1 + text::count_characters(text.substr(text.rfind('\n') + 1))};
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && text::is_blank(text[at])) ++at;
  return at;
}

// First byte from `at` on that begins a character.
std::size_t skip_continuation(std::string_view text, std::size_t at) {
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
  return at;
}

// First byte of the field `fields` semicolons behind `at`; the record's '#' where it has fewer.
std::size_t field_offset(std::string_view text, std::size_t at, std::size_t fields) {
  for (; fields > 0; --fields) {
    while (at < text.size() && text[at] != ';' && text[at] != '#') ++at;
    if (at >= text.size() || text[at] == '#') return at;
    ++at;
  }
  return skip_blanks(text, at);
}

// First byte behind a record's keyword, and behind the ';' that should follow it.
std::size_t behind_keyword(std::string_view text, std::size_t at) {
  while (at < text.size() && text::is_letter(text[at])) ++at;
  const std::size_t next = skip_blanks(text, at);
  if (next < text.size() && text[next] == ';') return skip_blanks(text, next + 1);
  return next;
}

}  // namespace

TextIndex::TextIndex(std::string_view text) {
  add_lines(text, text.size());
}

void TextIndex::add_lines(std::string_view text, std::size_t end) {
  if (indexed_ == 0) {
    block_places_.reserve(text.size() / kBlockBytes + 1);
    indexed_place_.column = text.starts_with(text::kByteOrderMark) ? 0 : 1;
  }
  for (; indexed_ < end; indexed_ = std::min(indexed_ + kBlockBytes, end)) {
    block_places_.push_back(indexed_place_);
    indexed_place_ =
        advanced(indexed_place_, text.substr(indexed_, std::min(kBlockBytes, end - indexed_)));
  }
}

void TextIndex::add_anchor(std::size_t segment, std::size_t offset) {
  anchors_.push_back({offset, static_cast<std::uint32_t>(obstacle_offsets.size() - 1),
                      static_cast<std::uint32_t>(segment)});
}

TextPlace TextIndex::place_at(std::string_view text, std::size_t offset) const {
  offset = std::min(offset, text.size());
  if (block_places_.empty()) return advanced({}, text.substr(0, offset));
  const std::size_t block = std::min(offset / kBlockBytes, block_places_.size() - 1);
  const std::size_t start = block * kBlockBytes;
  TextPlace place = advanced(block_places_[block], text.substr(start, offset - start));
  place.column = std::max<std::size_t>(place.column, 1);
  return place;
}

std::size_t TextIndex::offset_at(std::string_view text, TextPlace place) const {
  const auto is_before = [](const TextPlace& p, const TextPlace& q) {
    return std::tie(p.line, p.column) < std::tie(q.line, q.column);
  };
  const auto above = std::upper_bound(block_places_.begin(), block_places_.end(), place, is_before);
  const auto block =
      static_cast<std::size_t>(above - block_places_.begin()) - (above != block_places_.begin());
  TextPlace at = block_places_.empty() ? TextPlace{} : block_places_[block];
  std::size_t offset = block * kBlockBytes;
  for (; at.line < place.line; at = {at.line + 1, 1}) {
    offset = text.find('\n', offset);
    if (offset == text.npos) return text.size();
    ++offset;
  }
  offset = skip_continuation(text, offset);
  for (; at.column < place.column && offset < text.size() && text[offset] != '\n'; ++at.column) {
    offset = skip_continuation(text, offset + 1);
  }
  return offset;
}

// From the nearest anchor before it, or from the obstacle's own record.
std::size_t TextIndex::segment_offset(std::string_view text, std::size_t obstacle,
                                      std::size_t segment) const {
  const auto is_before = [](std::pair<std::size_t, std::size_t> p, const Anchor& q) {
    return p < std::pair<std::size_t, std::size_t>(q.obstacle, q.segment);
  };
  const auto above =
      std::upper_bound(anchors_.begin(), anchors_.end(), std::pair(obstacle, segment), is_before);
  std::size_t offset = obstacle_offsets[obstacle];
  std::size_t records = segment + 1;
  if (above != anchors_.begin() && std::prev(above)->obstacle == obstacle) {
    offset = std::prev(above)->offset;
    records = segment - std::prev(above)->segment;
  }
  for (; records > 0; --records) offset = skip_blanks(text, text.find('#', offset) + 1);
  return offset;
}

TextPlace TextIndex::place(std::string_view text, std::size_t obstacle, ObstacleField field) const {
  const std::size_t keyword = obstacle_offsets[obstacle];
  if (field == ObstacleField::kKeyword) return place_at(text, keyword);
  const auto behind = static_cast<std::size_t>(field) - 1;
  return place_at(text, field_offset(text, behind_keyword(text, keyword), behind));
}

TextPlace TextIndex::place(std::string_view text, std::size_t obstacle, std::size_t segment,
                           SegmentField field) const {
  const std::size_t first = segment_offset(text, obstacle, segment);
  return place_at(text, field_offset(text, first, static_cast<std::size_t>(field)));
}

TextPlace TextIndex::border_place(std::string_view text) const {
  if (border_offset == kNowhere) return {};
  const std::size_t number = behind_keyword(text, border_offset);
  const bool has_one = number < text.size() && text[number] != '#';
  return place_at(text, has_one ? number : border_offset);
}

}  // namespace mapwright
