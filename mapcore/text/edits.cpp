#include "mapcore/text/edits.hpp"

#include <cassert>

#include "mapcore/text/document.hpp"

namespace mapwright {

std::string apply_edits(std::string_view text, const std::vector<TextEdit>& edits) {
  const TextIndex index(text);
  std::string edited;
  std::size_t done = 0;
  for (const auto& edit : edits) {
    const std::size_t begin = index.offset_at(text, edit.begin);
    const std::size_t end = index.offset_at(text, edit.end);
    assert(done <= begin && begin <= end);
    edited.append(text.substr(done, begin - done)).append(edit.replacement);
    done = end;
  }
  return edited.append(text.substr(done));
}

}  // namespace mapwright
