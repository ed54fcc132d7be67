#include "mapcore/text/encoding.hpp"

#include <algorithm>

#include "mapcore/text/byte_counts.hpp"
#include "mapcore/text/characters.hpp"

namespace mapwright::text {
namespace {

constexpr std::size_t kBlockBytes = TextIndex::kBlockBytes;
constexpr std::size_t kFewestControls = 2;
constexpr std::size_t kBytesPerControl = 32;

// Whether all bytes that far from each other are as `is_right` says.
bool holds_every_other(std::string_view text, std::size_t first, bool (*is_right)(char)) {
  for (std::size_t at = first; at < text.size(); at += 2) {
    if (!is_right(text[at])) return false;
  }
  return true;
}

bool is_zero(char byte) {
  return byte == '\0';
}

bool is_plain(char byte) {
  return (byte >= ' ' && byte <= '~') || byte == '\t' || byte == '\n' || byte == '\r';
}

bool is_text(std::string_view block) {
  const std::size_t controls = count_controls(block);
  return controls < kFewestControls || controls * kBytesPerControl < block.size();
}

std::size_t count_invalid(std::string_view text) {
  std::size_t count = 0;
  for (auto at = find_invalid_utf8(text); at != text.npos; at = find_invalid_utf8(text)) {
    ++count;
    text.remove_prefix(at + 1);
  }
  return count;
}

}  // namespace

std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
  constexpr std::size_t kStart = 16;  // eight characters: no file that is no text begins like that
  if (text.size() < kStart) return {};
  const auto start = text.substr(0, kStart);
  if (holds_every_other(start, 0, is_plain) && holds_every_other(start, 1, is_zero)) {
    return "UTF-16LE";
  }
  const bool is_big_endian =
      holds_every_other(start, 0, is_zero) && holds_every_other(start, 1, is_plain);
  return is_big_endian ? "UTF-16BE" : std::string_view();
}

std::size_t end_of_text(std::string_view text) {
  return end_of_text(text, 0, text.size());
}

std::size_t end_of_text(std::string_view text, std::size_t begin, std::size_t end) {
  if (begin == 0 && !wide_encoding(text).empty()) return 0;
  for (std::size_t at = begin; at < end; at += kBlockBytes) {
    if (!is_text(text.substr(at, std::min(kBlockBytes, end - at)))) return at;
  }
  return end;
}

void report_not_text(std::string_view text, std::size_t end, Defects& defects) {
  if (const auto encoding = wide_encoding(text); !encoding.empty()) {
    defects.add(FindingCode::F102, 0,
                "the file is " + std::string(encoding) + "; save it as UTF-8");
    return;
  }
  const auto control =
      std::find_if(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), is_control);
  defects.add(FindingCode::F102, static_cast<std::size_t>(control - text.begin()),
              end == 0 ? "the file is not a text file; is it the map itself?"
                       : "from here on the file is not text; the records before are read");
}

void report_invalid_utf8(std::string_view text, std::size_t begin, std::size_t end,
                         Defects& defects) {
  text = text.substr(0, end);
  if (is_ascii(text.substr(begin))) return;
  std::size_t at = begin;
  while (true) {
    const auto invalid = find_invalid_utf8(text.substr(at));
    if (invalid == text.npos) return;
    at += invalid;
    const auto record_end = std::min(text.find('#', at), text.size());
    const auto count = count_invalid(text.substr(at, record_end - at));
    const auto bytes =
        count == 1 ? std::string("a byte that is") : std::to_string(count) + " bytes that are";
    defects.add(FindingCode::F103, at,
                "the record has " + bytes + " not UTF-8, the first one " +
                    quoted(text.substr(at, 1)) + "; save the file as UTF-8");
    at = record_end;
  }
}

}  // namespace mapwright::text
