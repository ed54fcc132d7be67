#include "converter/gdal/xml_walk.hpp"

#include <expat.h>

#include <array>
#include <cstdint>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {

// What Expat calls.
struct XmlWalk::Handlers {
  static XmlWalk& of(void* walk) { return *static_cast<XmlWalk*>(walk); }

  static void begin(void* walk, const XML_Char* name, const XML_Char** attributes) {
    of(walk).begin(name, attributes);
  }
  static void end(void* walk, const XML_Char* name) { of(walk).end(name); }
  static void text(void* walk, const XML_Char* piece, int size) {
    of(walk).text({piece, static_cast<std::size_t>(size)});
  }
};

XmlWalk::XmlWalk() : parser_(XML_ParserCreateNS(nullptr, '|'), XML_ParserFree) {
  XML_SetUserData(parser_.get(), this);
  XML_SetElementHandler(parser_.get(), Handlers::begin, Handlers::end);
  XML_SetCharacterDataHandler(parser_.get(), Handlers::text);
}

void XmlWalk::walk(const std::string& path) {
  const StoredFile file(path);
  std::array<char, 1U << 16U> bytes;
  std::uint64_t offset = 0;
  while (const auto size = file.read(offset, bytes.data(), bytes.size())) {
    const auto status = XML_Parse(parser_.get(), bytes.data(), static_cast<int>(size), XML_FALSE);
    if (status != XML_STATUS_OK) return;
    offset += size;
  }
}

std::size_t XmlWalk::line() const {
  return XML_GetCurrentLineNumber(parser_.get());
}

void XmlWalk::stop() {
  XML_StopParser(parser_.get(), XML_FALSE);
}

std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind('|') + 1);
}

}  // namespace mapwright::converter
