#include "converter/gdal/xml_coordinates.hpp"

#include <charconv>
#include <string_view>

#include "converter/gdal/xml_walk.hpp"

namespace mapwright::converter {
namespace {

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

class CoordinateScan : public XmlWalk {
 public:
  std::optional<std::string> find(const std::string& path) {
    walk(path);
    return found_;
  }

 private:
  // GML 2 may say which characters stand between its numbers.
  void begin(std::string_view element, Attributes attributes) override {
    const auto name = local_name(element);
    is_inside_ = name == "pos" || name == "posList" || name == "coordinates";
    for (; is_inside_ && *attributes != nullptr; attributes += 2) {
      const std::string_view attribute = attributes[0];
      if (attribute == "decimal" || attribute == "cs" || attribute == "ts") is_inside_ = false;
    }
  }

  void end(std::string_view) override {
    end_word();
    is_inside_ = false;
  }

  void text(std::string_view piece) override {
    if (!is_inside_) return;
    for (const char c : piece) {
      if (std::string_view(" \t\r\n,").find(c) != std::string_view::npos) {
        end_word();
      } else {
        if (word_.empty()) line_ = line();
        word_ += c;
      }
    }
  }

  void end_word() {
    if (!word_.empty() && !is_number(word_)) {
      found_ = "line " + std::to_string(line_) + ": \"" + beginning(word_) +
               "\" stands among coordinates and is no number";
      stop();
      is_inside_ = false;
    }
    word_.clear();
  }

  std::optional<std::string> found_;
  std::string word_;
  std::size_t line_ = 0;
  bool is_inside_ = false;
};

}  // namespace

std::optional<std::string> word_among_coordinates(const std::string& path) {
  return CoordinateScan().find(path);
}

}  // namespace mapwright::converter
