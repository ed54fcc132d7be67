#include "mapcore/text/obstacle_stream.hpp"

#include <utility>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/obstacle_sink.hpp"
#include "mapcore/text/quick_reader.hpp"

namespace mapwright {
namespace {

// What is read at a time and then let go.
constexpr std::size_t kPieceBytes = std::size_t{1} << 18U;

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && text::is_blank(text[at])) ++at;
  return at;
}

// Behind the last '#' of the piece that begins at `begin`; `begin` where it has none.
std::size_t end_of_records(std::string_view text, std::size_t begin) {
  const std::size_t hash = text.substr(begin, kPieceBytes).rfind('#');
  return hash == text.npos ? begin : begin + hash + 1;
}

std::size_t kibibytes(std::size_t bytes) {
  return bytes >> 10U;
}

// Reads record by record up to the end of the text; false where one is not plain.
bool read_records(const MapText& text, std::size_t at,
                  text::QuickReader<text::ObstacleSink>& reader, const text::ObstacleSink& sink,
                  const Progress& progress) {
  const std::string_view all = text;
  std::size_t released = 0;
  while ((at = skip_blanks(all, at)) < all.size()) {
    const std::size_t end = end_of_records(all, at);
    if (end == at || reader.read(at, end) != end || !sink.wants_more()) return false;
    text.release(std::exchange(released, end), end);
    if (progress) progress(kibibytes(end), kibibytes(all.size()));
    at = end;
  }
  return true;
}

}  // namespace

std::optional<Border> visit_obstacles(const MapText& text, const ObstacleVisitor& visit,
                                      const Progress& progress) {
  const std::string_view all = text;
  const std::size_t mark = all.starts_with(text::kByteOrderMark) ? text::kByteOrderMark.size() : 0;
  const std::size_t first = skip_blanks(all, mark);
  text::ObstacleSink sink(all.size(), visit);
  text::QuickReader<text::ObstacleSink> reader(all, sink);
  Border border;
  const std::size_t behind = reader.read_border(first, all.size(), border);
  if (behind == first || !read_records(text, behind, reader, sink, progress)) return std::nullopt;
  sink.finish();
  if (!sink.wants_more()) return std::nullopt;
  return border;
}

}  // namespace mapwright
