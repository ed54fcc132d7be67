#include "converter/gdal/csv_rows.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

class RowReader {
 public:
  void take(char byte) {
    if (byte == '"') in_quotes_ = !in_quotes_;  // two of them, one in a text, change nothing
    if (in_quotes_ || byte == '"') return take_text();
    if (byte == '\n' || byte == '\r') return end_row();
    if (row_ == 0 && separator_ == '\0' && is_separator(byte)) separator_ = byte;
    if (byte == separator_ && separator_ != '\0') {
      is_blank_ = false;
      ++separators_;
    } else if (byte != ' ') {
      take_text();
    }
  }

  RowFaults finish() {
    const bool is_open = in_quotes_ || separators_ < heading_separators_;
    if (!is_blank_ && row_ > 0 && is_open) faults_.cut_short = row_;
    end_row();
    return std::move(faults_);
  }

 private:
  static bool is_separator(char byte) {
    return std::string_view(",;\t|").find(byte) != std::string_view::npos;
  }

  void take_text() {
    is_blank_ = false;
    is_too_long_ = is_too_long_ || (row_ > 0 && separators_ > heading_separators_);
  }

  void end_row() {
    if (is_blank_) return;
    if (row_ == 0) heading_separators_ = separators_;
    if (is_too_long_) faults_.too_long.push_back(row_);
    ++row_;
    separators_ = 0;
    is_blank_ = true;
    is_too_long_ = false;
  }

  RowFaults faults_;
  std::size_t row_ = 0;  // the heading is 0
  std::size_t separators_ = 0, heading_separators_ = 0;
  char separator_ = '\0';  // the first one of the heading
  bool in_quotes_ = false, is_blank_ = true, is_too_long_ = false;
};

}  // namespace

RowFaults faults_of_rows(const std::string& path) {
  const StoredFile file(path);
  std::array<char, 1U << 16U> bytes;
  RowReader rows;
  std::uint64_t offset = 0;
  while (const auto size = file.read(offset, bytes.data(), bytes.size())) {
    for (std::size_t i = 0; i < size; ++i) rows.take(bytes[i]);
    offset += size;
  }
  return rows.finish();
}

}  // namespace mapwright::converter
