#include <algorithm>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

/// A record as the grammar has it, and its canonical text.
struct Laid {
  std::size_t begin, end;
  std::string text;
};

// The same double in the fewest digits; a text that is none stays.
std::string number(const text::Field& field) {
  const auto reading = text::read_number(field.text);
  return reading.status == text::NumberStatus::kOk ? number_text(reading.value)
                                                   : std::string(field.text);
}

std::string integer(const text::Field& field) {
  const auto reading = text::read_integer(field.text);
  return reading.status == text::NumberStatus::kOk ? std::to_string(reading.value)
                                                   : std::string(field.text);
}

std::string border_layout(const HeaderText& record) {
  const auto& f = record.fields;
  return "border;\n" + number(f[0]) + ";" + number(f[1]) + ";\n" + number(f[2]) + ";" +
         number(f[3]) + ";\n#\n";
}

std::string obstacle_layout(const HeaderText& record) {
  const auto& f = record.fields;
  return "obstacle;\n" + integer(f[0]) + ";" + integer(f[1]) + ";" + integer(f[2]) + ";" +
         std::string(f[3].text) + ";\n#\n";
}

std::string segment_layout(const SegmentText& record) {
  const auto& f = record.fields;
  return number(f[0]) + ";" + number(f[1]) + ";\n" + number(f[2]) + ";" + number(f[3]) + ";\n" +
         number(f[4]) + ";" + std::string(f[5].text) + ";" + std::string(f[6].text) + ";\n#\n";
}

bool begins_with(std::string_view text, std::size_t at, std::string_view word) {
  return text.substr(at, word.size()) == word;
}

// In the order of the text. Records with findings of their own are left as they are.
std::vector<Laid> laid_out(const MapDocument& document) {
  const std::string_view text = document.text;
  std::vector<Laid> records;
  if (const auto border = border_text(document);
      border && begins_with(text, border->begin, "border")) {
    records.push_back({border->begin, border->end, border_layout(*border)});
  }
  for (std::size_t i = 0; i < document.map.obstacles.size(); ++i) {
    const auto header = header_text(document, i);
    if (header && begins_with(text, header->begin, "obstacle")) {
      records.push_back({header->begin, header->end, obstacle_layout(*header)});
    }
    for (std::size_t k = 0; k < document.map.obstacles[i].segments.size(); ++k) {
      if (const auto segment = segment_text(document, i, k)) {
        records.push_back({segment->begin, segment->end, segment_layout(*segment)});
      }
    }
  }
  std::sort(records.begin(), records.end(),
            [](const Laid& p, const Laid& q) { return p.begin < q.begin; });
  return records;
}

bool holds_line_break(const Laid& record, std::string_view text) {
  const auto raw = text.substr(record.begin, record.end - record.begin);
  text::FieldWalker walker(raw, 0, raw.size());
  while (!walker.done()) {
    if (walker.next().text.find_first_of("\r\n") != std::string_view::npos) return true;
  }
  return false;
}

// White space between records goes; anything else that stands there stays byte for byte.
class Layout {
 public:
  explicit Layout(std::string_view text) : text_(text) {
    if (text.starts_with(text::kByteOrderMark)) done_ = text::kByteOrderMark.size();
    if (done_ > 0) edits_.push_back({0, done_, ""});
  }

  void add(const Laid& record) {
    if (record.begin < done_) return;
    const bool is_blank = skip_blanks(text_, done_) >= record.begin;
    const std::size_t begin = is_blank ? done_ : record.begin;
    std::size_t end = record.end;
    // The line break is the record's own.
    if (begins_with(text_, end, "\n")) ++end;
    if (text_.substr(begin, end - begin) != record.text) {
      edits_.push_back({begin, end, record.text});
      ++changed_;
    }
    done_ = end;
  }

  Proposals take() {
    if (skip_blanks(text_, done_) == text_.size() && done_ < text_.size()) {
      edits_.push_back({done_, text_.size(), ""});
    }
    if (edits_.empty()) return {};
    return {{{},
             {},
             std::to_string(changed_) + (changed_ == 1 ? " record" : " records") + " laid out anew",
             std::move(edits_)}};
  }

 private:
  std::string_view text_;
  std::size_t done_ = 0;
  std::size_t changed_ = 0;
  std::vector<OffsetEdit> edits_;
};

}  // namespace

Proposals fix_layout(const FixContext& context) {
  const std::string_view text = context.document.text;
  Layout layout(text);
  for (const auto& record : laid_out(context.document)) {
    if (!holds_line_break(record, text)) layout.add(record);
  }
  return layout.take();
}

}  // namespace mapwright::validators
