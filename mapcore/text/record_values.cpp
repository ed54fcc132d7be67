#include "mapcore/text/record_values.hpp"

#include <string>

namespace mapwright::text {
namespace {

// "wall\n  brick" → "wall brick".
std::string without_line_breaks(std::string_view text) {
  std::string joined;
  while (!text.empty()) {
    const auto line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (trimmed(line).empty()) continue;
    if (!joined.empty()) joined += ' ';
    joined += trimmed(line);
  }
  return joined;
}

}  // namespace

std::optional<double> RecordValues::number(const Subject& subject, std::string_view name,
                                           const Field& field) {
  const auto [status, value] = read_number(field.text);
  if (status == NumberStatus::kOk) return value;
  const auto complaint = number_complaint(name, field.text, status);
  defects_.add(complaint.code, field.offset, subject, complaint.message);
  if (complaint.meant) {
    defects_.fix(field.offset, field.offset + field.text.size(), *complaint.meant);
  }
  return std::nullopt;
}

std::optional<std::int64_t> RecordValues::integer(const Subject& subject, std::string_view name,
                                                  const Field& field,
                                                  std::string_view consequence) {
  const auto [status, value] = read_integer(field.text);
  if (status == NumberStatus::kOk) return value;
  const auto complaint = integer_complaint(name, field.text, status);
  defects_.add(complaint.code, field.offset, subject, complaint.message + std::string(consequence));
  return std::nullopt;
}

std::optional<Border> RecordValues::border(const std::array<Field, kHeaderFields>& fields) {
  const Subject subject{Subject::Kind::kBorder, {}, {}};
  const auto left = number(subject, "mx1", fields[0]);
  const auto top = number(subject, "my1", fields[1]);
  const auto right = number(subject, "mx4", fields[2]);
  const auto bottom = number(subject, "my4", fields[3]);
  if (!left || !top || !right || !bottom) return std::nullopt;
  return Border{*left, *top, *right, *bottom};
}

void RecordValues::shape_type(ObstacleHeader& header, const Field& field) {
  header.shape_type_offset = field.offset;
  const auto number = integer({Subject::Kind::kObstacle, header.id, {}}, "ST", field,
                              "; read as 1 if the chain closes, as 2 if not");
  if (!number) return;
  if (is_shape_type(*number)) {
    header.shape_type = static_cast<ShapeType>(*number);
  } else {
    header.unknown_shape = std::to_string(*number);
  }
}

void RecordValues::declared_segments(ObstacleHeader& header, const Field& field) {
  const Subject subject{Subject::Kind::kObstacle, header.id, {}};
  header.declared_offset = field.offset;
  header.declared_segments = integer(subject, "NS", field, "; the segments that follow are taken");
  if (header.declared_segments.value_or(0) < 0) {
    header.declared_segments.reset();
    defects_.add(FindingCode::F111, field.offset, subject,
                 "NS " + quoted(field.text) + " is below 0; the segments that follow are taken");
  }
}

ObstacleHeader RecordValues::obstacle(std::size_t offset,
                                      const std::array<Field, kHeaderFields>& fields) {
  ObstacleHeader header;
  header.offset = offset;
  header.id = integer({Subject::Kind::kObstacle, {}, {}}, "id", fields[0],
                      "; the obstacle is left out with its segments");
  shape_type(header, fields[1]);
  declared_segments(header, fields[2]);
  header.semantic = semantic({Subject::Kind::kObstacle, header.id, {}}, fields[3]);
  return header;
}

InOut RecordValues::in_out(const Subject& subject, const Field& field) {
  if (field.text == "0") return InOut::kIndoor;
  if (field.text != "1") {
    defects_.add(FindingCode::F115, field.offset, subject,
                 "inOut is " + quoted(field.text) + "; write 0 (indoor) or 1 (outdoor); read as 1");
  }
  return InOut::kOutdoor;
}

Semantic RecordValues::semantic(const Subject& subject, const Field& field) {
  if (field.text.find_first_of("\r\n") == field.text.npos) return semantics_.get(field.text);
  defects_.add(FindingCode::F122, field.offset, subject,
               "the semantic string " + quoted(field.text) +
                   " has a line break within; write it on one line");
  const std::string joined = without_line_breaks(field.text);
  defects_.fix(field.offset, field.offset + field.text.size(), joined);
  return semantics_.get(joined);
}

std::optional<Segment> RecordValues::segment(const Subject& subject,
                                             const std::array<Field, kSegmentFields>& fields) {
  const auto ax = number(subject, "ax", fields[0]);
  const auto ay = number(subject, "ay", fields[1]);
  const auto bx = number(subject, "bx", fields[2]);
  const auto by = number(subject, "by", fields[3]);
  const auto height = number(subject, "h", fields[4]);
  const InOut side = in_out(subject, fields[5]);
  Semantic label = semantic(subject, fields[6]);
  if (!ax || !ay || !bx || !by || !height) return std::nullopt;
  return Segment{{*ax, *ay}, {*bx, *by}, *height, side, std::move(label)};
}

}  // namespace mapwright::text
