#include "mapcore/parts/cut_record.hpp"

#include <array>
#include <charconv>

#include "mapcore/text/decimal.hpp"

namespace mapwright {
namespace {

constexpr char kRecordEnd = '/';
constexpr char kFieldEnd = ':';
constexpr std::string_view kHexDigits = "0123456789ABCDEF";

bool is_plain(char c) {
  constexpr std::string_view kReserved = ",;#%/:=";
  return static_cast<unsigned char>(c) > ' ' && c != '\x7f' && kReserved.find(c) == kReserved.npos;
}

void append_escaped(std::string& out, std::string_view text) {
  for (const char c : text) {
    if (is_plain(c)) {
      out += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    out += '%';
    out += kHexDigits[byte >> 4U];
    out += kHexDigits[byte & 15U];
  }
}

std::optional<std::string> unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const auto high = kHexDigits.find(text[i + 1]), low = kHexDigits.find(text[i + 2]);
    if (high == kHexDigits.npos || low == kHexDigits.npos) return std::nullopt;
    plain += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return plain;
}

void append_number(std::string& out, double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0);
  out.append(buffer.data(), end.ptr);
}

void append_point(std::string& out, Point p) {
  append_number(out, p.x);
  out += kFieldEnd;
  append_number(out, p.y);
}

bool looks_like(const Segment& p, const Segment& q) {
  return p.height_m == q.height_m && p.in_out == q.in_out && p.semantic == q.semantic;
}

void append_segment(std::string& out, const Segment& segment, const Segment* before) {
  out += kRecordEnd;
  if (before == nullptr || before->b != segment.a) {
    append_point(out, segment.a);
    out += kFieldEnd;
  }
  append_point(out, segment.b);
  if (before != nullptr && looks_like(*before, segment)) return;
  out += kFieldEnd;
  append_number(out, segment.height_m);
  out += kFieldEnd;
  out += segment.in_out == InOut::kIndoor ? '0' : '1';
  out += kFieldEnd;
  append_escaped(out, segment.semantic.view());
}

void append_obstacle(std::string& out, const Obstacle& obstacle) {
  out += kRecordEnd + std::to_string(obstacle.id) + kFieldEnd +
         std::to_string(static_cast<int>(obstacle.shape_type)) + kFieldEnd;
  append_escaped(out, obstacle.semantic.view());
  const Segment* before = nullptr;
  for (const auto& segment : obstacle.segments) {
    append_segment(out, segment, before);
    before = &segment;
  }
}

std::vector<std::string_view> split(std::string_view text, char end) {
  std::vector<std::string_view> parts;
  for (auto at = text.find(end); at != text.npos; at = text.find(end)) {
    parts.push_back(text.substr(0, at));
    text.remove_prefix(at + 1);
  }
  parts.push_back(text);
  return parts;
}

using Fields = std::vector<std::string_view>;

bool read(std::string_view text, double& value) {
  const auto number = text::read_number(text);
  value = number.value;
  return number.status == text::NumberStatus::kOk;
}

bool read(std::string_view text, std::int64_t& value) {
  const auto number = text::read_integer(text);
  value = number.value;
  return number.status == text::NumberStatus::kOk;
}

bool read(std::string_view text, Semantic& value) {
  const auto plain = unescaped(text);
  if (plain) value = *plain;
  return plain.has_value();
}

bool read_obstacle(const Fields& fields, Obstacle& obstacle) {
  std::int64_t type = 0;
  if (!read(fields[0], obstacle.id) || !read(fields[1], type) || !is_shape_type(type)) return false;
  obstacle.shape_type = static_cast<ShapeType>(type);
  return read(fields[2], obstacle.semantic);
}

// By the number of fields: 2 end; 4 both ends; 5 and 7 the same with height, inOut and semantic.
bool read_segment(const Fields& fields, Obstacle& obstacle) {
  const auto n = fields.size();
  const bool has_start = n == 4 || n == 7, has_looks = n == 5 || n == 7;
  if (n != 2 && !has_start && !has_looks) return false;
  if (obstacle.segments.empty() && n != 7) return false;
  Segment segment = n == 7 ? Segment() : obstacle.segments.back();
  std::size_t i = 0;
  segment.a = segment.b;
  if (has_start && (!read(fields[0], segment.a.x) || !read(fields[1], segment.a.y))) return false;
  if (has_start) i = 2;
  if (!read(fields[i], segment.b.x) || !read(fields[i + 1], segment.b.y)) return false;
  if (has_looks) {
    const auto in_out = fields[i + 3];
    if (!read(fields[i + 2], segment.height_m) || !read(fields[i + 4], segment.semantic) ||
        (in_out != "0" && in_out != "1"))
      return false;
    segment.in_out = in_out == "0" ? InOut::kIndoor : InOut::kOutdoor;
  }
  obstacle.segments.push_back(std::move(segment));
  return true;
}

}  // namespace

std::string format_cut_record(double resolution_m, std::span<const Obstacle* const> family) {
  std::string text;
  append_number(text, resolution_m);
  for (const auto* obstacle : family) append_obstacle(text, *obstacle);
  return text;
}

std::optional<CutRecord> parse_cut_record(std::string_view text) {
  const auto records = split(text, kRecordEnd);
  CutRecord cut;
  if (!read(records.front(), cut.resolution_m)) return std::nullopt;
  if (!(cut.resolution_m >= 1e-9 && cut.resolution_m <= 1e6)) return std::nullopt;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const auto fields = split(records[i], kFieldEnd);
    const bool begins = fields.size() == 3;
    if (begins) cut.family.emplace_back();
    if (cut.family.empty()) return std::nullopt;
    auto& obstacle = cut.family.back();
    if (!(begins ? read_obstacle(fields, obstacle) : read_segment(fields, obstacle))) {
      return std::nullopt;
    }
  }
  if (cut.family.empty()) return std::nullopt;
  return cut;
}

}  // namespace mapwright
