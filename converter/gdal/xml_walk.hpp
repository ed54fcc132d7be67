// Private to this folder: XML documents element by element (Expat).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace mapwright::converter {

/// Calls what a scan overrides for each element and text of a document, in order. Names come with
/// their namespace in front: "http://www.opengis.net/gml|pos".
class XmlWalk {
 public:
  XmlWalk();
  XmlWalk(const XmlWalk&) = delete;
  XmlWalk& operator=(const XmlWalk&) = delete;
  virtual ~XmlWalk() = default;

  /// Until the document ends, a mistake in it or stop(). `path` may lie in GDAL's memory.
  void walk(const std::string& path);

 protected:
  using Attributes = const char* const*;  ///< name, value, name, value …, null

  virtual void begin(std::string_view name, Attributes attributes) = 0;
  virtual void end(std::string_view name) = 0;
  /// In pieces that may end within a word.
  virtual void text(std::string_view piece) = 0;

  std::size_t line() const;
  void stop();

 private:
  struct Handlers;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> parser_;
};

/// Of a name without its namespace.
std::string_view local_name(std::string_view name);

}  // namespace mapwright::converter
