#include "mapcore/text/reader.hpp"

#include <algorithm>
#include <utility>

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

void read_records(std::string_view text, bool is_cut, MapDocument& document, Defects& defects) {
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
