#include "converter/gdal/csv_rows.hpp"

#include <array>
#include <cstdint>
#include <string_view>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

class RowCounter {
 public:
  void take(char byte) {
    if (byte == '"') in_quotes_ = !in_quotes_;  // two of them, one in a text, change nothing
    if (in_quotes_ || byte == '"') {
      is_blank_ = false;
    } else if (byte == '\n' || byte == '\r') {
      end_row();
    } else {
      is_blank_ = false;
      if (separator_ == '\0' && is_separator(byte)) separator_ = byte;
      if (byte == separator_) ++separators_;
    }
  }

  std::optional<std::size_t> cut_short() const {
    if (is_blank_ || rows_ == 0) return std::nullopt;
    return in_quotes_ || separators_ < heading_separators_ ? std::optional(rows_) : std::nullopt;
  }

 private:
  static bool is_separator(char byte) {
    return std::string_view(",;\t|").find(byte) != std::string_view::npos;
  }

  void end_row() {
    if (is_blank_) return;
    if (rows_ == 0) heading_separators_ = separators_;
    ++rows_;
    separators_ = 0;
    is_blank_ = true;
  }

  std::size_t rows_ = 0;  // that have ended, the heading among them
  std::size_t separators_ = 0, heading_separators_ = 0;
  char separator_ = '\0';  // the first there is
  bool in_quotes_ = false, is_blank_ = true;
};

}  // namespace

std::optional<std::size_t> row_cut_short(const std::string& path) {
  const StoredFile file(path);
  std::array<char, 1U << 16U> bytes;
  RowCounter rows;
  std::uint64_t offset = 0;
  while (const auto size = file.read(offset, bytes.data(), bytes.size())) {
    for (std::size_t i = 0; i < size; ++i) rows.take(bytes[i]);
    offset += size;
  }
  return rows.cut_short();
}

}  // namespace mapwright::converter
