#include "mapcore/text/reader.hpp"

#include <algorithm>
#include <utility>

#include "mapcore/text/byte_counts.hpp"
#include "mapcore/text/characters.hpp"
#include "mapcore/text/defects.hpp"
#include "mapcore/text/encoding.hpp"
#include "mapcore/text/map_builder.hpp"
#include "mapcore/text/quick_reader.hpp"
#include "mapcore/text/record_reader.hpp"
#include "mapcore/text/semantic_cache.hpp"

namespace mapwright {
namespace {

using text::Defects;

std::size_t first_character(std::string_view text) {
  std::size_t at = text.starts_with(text::kByteOrderMark) ? text::kByteOrderMark.size() : 0;
  while (at < text.size() && text::is_blank(text[at])) ++at;
  return at;
}

// Room for the records of a text without defects: S segments and O obstacles have S + O + 1 times '#'
// and 7 S + 5 O + 5 times ';'. Other texts get no more than the shortest records they could hold.
void reserve(std::string_view text, MapDocument& document) {
  constexpr std::size_t kShortestSegment = std::string_view("0;0;0;0;0;0;;#").size();
  constexpr std::size_t kShortestObstacle = std::string_view("obstacle;0;1;0;;#").size();
  const std::size_t hashes = text::count_byte(text, '#');
  const std::size_t semicolons = text::count_byte(text, ';');
  const std::size_t surplus = 7 * hashes > semicolons + 2 ? 7 * hashes - semicolons - 2 : 0;
  const std::size_t obstacles = std::min(surplus / 2, text.size() / kShortestObstacle);
  document.map.obstacles.reserve(obstacles);
  document.index.obstacle_offsets.reserve(obstacles);
  document.index.first_segment.reserve(obstacles);
  document.index.segment_offsets.reserve(std::min(hashes, text.size() / kShortestSegment));
}

void read_records(std::string_view text, bool is_cut, MapDocument& document, Defects& defects) {
  reserve(text, document);
  text::SemanticCache semantics;
  text::MapBuilder builder(document, defects);
  text::QuickReader quick(text, builder, semantics);
  text::RecordReader careful(text, is_cut, builder, defects, semantics);
  const std::size_t first = first_character(text);
  std::size_t at = first;
  while (at < text.size()) {
    at = quick.read(at);
    if (at < text.size()) at = careful.read(at);
  }
  builder.finish(first);
}

}  // namespace

MapDocument read_map(std::string text) {
  MapDocument document;
  document.text = std::move(text);
  const std::string_view all = document.text;
  document.index = TextIndex(all);
  Defects defects;
  const std::size_t end = text::report_encoding(all, defects);
  if (first_character(all) == all.size()) {
    defects.add(FindingCode::F101, 0, "the file is empty; a map has at least a border record");
  } else if (end > 0) {
    read_records(all.substr(0, end), end < all.size(), document, defects);
  }
  document.findings = std::move(defects).findings(all, document.index);
  return document;
}

}  // namespace mapwright
