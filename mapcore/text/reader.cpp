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

// Reads a text piece by piece: of each piece first the lines and the encoding, then the records
// that end in it, while it is in the processor's cache. What has been read is let go.
class PieceReader {
 public:
  PieceReader(MapDocument& document, Defects& defects)
      : document_(document),
        text_(document.text.view()),
        defects_(defects),
        builder_(document, defects),
        sink_(builder_, semantics_),
        quick_(text_, sink_),
        end_(text_.size()),
        first_(first_character(text_)),
        at_(first_) {}

  void read(const Progress& progress) {
    while (seen_ < text_.size()) {
      look_at_next_piece();
      read_whole_records();
      if (progress) progress(seen_ >> 10U, text_.size() >> 10U);
    }
    if (end_ > 0) builder_.finish(first_);
  }

 private:
  static constexpr std::size_t kPieceBytes = 64 * TextIndex::kBlockBytes;

  void look_at_next_piece() {
    const std::size_t begin = std::exchange(seen_, std::min(seen_ + kPieceBytes, text_.size()));
    document_.index.add_lines(text_, seen_);
    const std::size_t hash = text_.substr(begin, seen_ - begin).rfind('#');
    if (hash != text_.npos) whole_ = begin + hash + 1;
    const std::size_t end = text::end_of_text(text_, begin, seen_);
    if (end < seen_) cut_at(end);
    if (seen_ == text_.size()) whole_ = end_;
  }

  void cut_at(std::size_t end) {
    end_ = end;
    text::report_not_text(text_, end, defects_);
    document_.index.add_lines(text_, text_.size());
    seen_ = text_.size();
  }

  // All that end in what has been looked at.
  void read_whole_records() {
    if (whole_ == done_) return;
    text::report_invalid_utf8(text_, done_, whole_, defects_);
    text::RecordReader careful(text_.substr(0, whole_), end_ < text_.size(), builder_, defects_,
                               semantics_);
    while (at_ < whole_) {
      at_ = quick_.read(at_, whole_);
      if (at_ < whole_) at_ = careful.read(at_);
    }
    if (done_ == 0) reserve_as_begun();
    document_.text.release(done_, whole_);
    done_ = whole_;
  }

  // Room for the obstacles to come, as many in each byte as up to here.
  void reserve_as_begun() {
    const auto begun = static_cast<double>(document_.map.obstacles.size());
    const double share = static_cast<double>(text_.size()) / static_cast<double>(whole_);
    const auto expected = static_cast<std::size_t>(1.05 * begun * share) + 1;
    document_.map.obstacles.reserve(expected);
    document_.index.obstacle_offsets.reserve(expected);
  }

  MapDocument& document_;
  std::string_view text_;
  Defects& defects_;
  text::SemanticCache semantics_;
  text::MapBuilder builder_;
  text::MapSink sink_;
  text::QuickReader<text::MapSink> quick_;
  std::size_t end_;        // of what is text
  std::size_t first_;      // character that is not blank
  std::size_t seen_ = 0;   // looked at
  std::size_t whole_ = 0;  // of this: up to the last '#', or the end of the text
  std::size_t done_ = 0;   // read
  std::size_t at_;         // where the next record begins
};

}  // namespace

MapDocument read_map(MapText text, const Progress& progress) {
  MapDocument document;
  document.text = std::move(text);
  const std::string_view all = document.text;
  Defects defects;
  if (first_character(all) == all.size()) {
    document.index = TextIndex(all);
    defects.add(FindingCode::F101, 0, "the file is empty; a map has at least a border record");
  } else {
    PieceReader(document, defects).read(progress);
  }
  document.findings = std::move(defects).findings(all, document.index);
  return document;
}

}  // namespace mapwright
