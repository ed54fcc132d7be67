#include "converter/gdal/xml_coordinates.hpp"

#include <expat.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <memory>
#include <string_view>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

// Names of expat are "namespace|local" here.
std::string_view local_name(const XML_Char* name) {
  const std::string_view whole = name;
  return whole.substr(whole.rfind('|') + 1);
}

bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // A number too large or too small for a double is the driver's to judge.
  return end == word.data() + word.size() && error != std::errc::invalid_argument;
}

// Of a long word, without a half character at its end.
std::string beginning(const std::string& word) {
  constexpr std::size_t kShown = 40;
  if (word.size() <= kShown) return word;
  std::size_t size = kShown;
  while (size > 0 && (static_cast<unsigned char>(word[size]) & 0xC0U) == 0x80U) --size;
  return word.substr(0, size) + "…";
}

class CoordinateScan {
 public:
  CoordinateScan() : parser_(XML_ParserCreateNS(nullptr, '|'), XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), begin_element, end_element);
    XML_SetCharacterDataHandler(parser_.get(), take_text);
  }

  std::optional<std::string> find(const StoredFile& file) {
    std::array<char, 1U << 16U> bytes;
    std::uint64_t offset = 0;
    while (const auto size = file.read(offset, bytes.data(), bytes.size())) {
      const auto status = XML_Parse(parser_.get(), bytes.data(), static_cast<int>(size), XML_FALSE);
      if (status != XML_STATUS_OK) break;
      offset += size;
    }
    return found_;
  }

 private:
  static CoordinateScan& of(void* scan) { return *static_cast<CoordinateScan*>(scan); }

  static void begin_element(void* scan, const XML_Char* name, const XML_Char** attributes) {
    of(scan).begin(local_name(name), attributes);
  }
  static void end_element(void* scan, const XML_Char*) {
    of(scan).end_word();
    of(scan).is_inside_ = false;
  }
  static void take_text(void* scan, const XML_Char* text, int size) {
    if (of(scan).is_inside_) of(scan).take({text, static_cast<std::size_t>(size)});
  }

  // GML 2 may say which characters stand between its numbers.
  void begin(std::string_view name, const XML_Char** attributes) {
    is_inside_ = name == "pos" || name == "posList" || name == "coordinates";
    for (; is_inside_ && *attributes != nullptr; attributes += 2) {
      const std::string_view attribute = attributes[0];
      if (attribute == "decimal" || attribute == "cs" || attribute == "ts") is_inside_ = false;
    }
  }

  // Texts come in pieces that may end within a word.
  void take(std::string_view text) {
    for (const char c : text) {
      if (std::string_view(" \t\r\n,").find(c) != std::string_view::npos) {
        end_word();
      } else {
        if (word_.empty()) line_ = XML_GetCurrentLineNumber(parser_.get());
        word_ += c;
      }
    }
  }

  void end_word() {
    if (!word_.empty() && !is_number(word_)) {
      found_ = "line " + std::to_string(line_) + ": \"" + beginning(word_) +
               "\" stands among coordinates and is no number";
      XML_StopParser(parser_.get(), XML_FALSE);
      is_inside_ = false;
    }
    word_.clear();
  }

  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::optional<std::string> found_;
  std::string word_;
  XML_Size line_ = 0;
  bool is_inside_ = false;
};

}  // namespace

std::optional<std::string> word_among_coordinates(const std::string& path) {
  return CoordinateScan().find(StoredFile(path));
}

}  // namespace mapwright::converter
