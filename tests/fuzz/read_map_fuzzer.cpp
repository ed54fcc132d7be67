// Whatever the bytes: reading ends, every place lies in the text, and what was understood survives
// writing and reading.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/encoding.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void look_up_every_place(const mapwright::MapDocument& document) {
  using mapwright::ObstacleField;
  using mapwright::SegmentField;
  const auto& [text, map, index, findings] = document;
  index.border_place(text);
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    index.place(text, i, ObstacleField::kSemantic);
    for (std::size_t j = 0; j < map.obstacles[i].segments.size(); ++j) {
      index.place(text, i, j, SegmentField::kSemantic);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const mapwright::MapDocument document = mapwright::read_map(text);
  for (const auto& finding : document.findings) {
    require(finding.place.has_value() && finding.place->line <= size + 1);
    require(mapwright::text::find_invalid_utf8(finding.message) == std::string::npos);
  }
  look_up_every_place(document);
  const std::string written = format_map(document.map);
  // Labels made of control characters are kept as they are, but can make a map look binary.
  if (mapwright::text::end_of_text(written) < written.size()) return 0;
  const mapwright::MapDocument again = mapwright::read_map(written);
  require(again.map == quantized(document.map));
  require(format_map(again.map) == written);
  return 0;
}
