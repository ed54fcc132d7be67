#include "mapcore/text/encoding.hpp"

#include <algorithm>

#include "mapcore/text/byte_counts.hpp"
#include "mapcore/text/characters.hpp"

namespace mapwright::text {
namespace {

constexpr std::size_t kBlockBytes = TextIndex::kBlockBytes;
constexpr std::size_t kFewestControls = 2;
constexpr std::size_t kBytesPerControl = 32;

bool is_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
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

std::size_t end_of_text(std::string_view text) {
  return end_of_text(text, 0, text.size());
}

std::size_t end_of_text(std::string_view text, std::size_t begin, std::size_t end) {
  if (begin == 0 && is_utf16(text)) return 0;
  for (std::size_t at = begin; at < end; at += kBlockBytes) {
    if (!is_text(text.substr(at, std::min(kBlockBytes, end - at)))) return at;
  }
  return end;
}

void report_not_text(std::string_view text, std::size_t end, Defects& defects) {
  if (is_utf16(text)) {
    defects.add(FindingCode::F102, 0, "the file is UTF-16; save it as UTF-8");
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
