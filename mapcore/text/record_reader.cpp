#include "mapcore/text/record_reader.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/record_shapes.hpp"

namespace mapwright::text {
namespace {

template <std::size_t count>
std::array<Field, count> take(FieldWalker& walker) {
  std::array<Field, count> fields;
  for (auto& field : fields) field = walker.next();
  return fields;
}

}  // namespace

Subject RecordReader::subject(Kind kind) const {
  if (kind == Kind::kBorder) return {Subject::Kind::kBorder, {}, {}};
  if (kind == Kind::kObstacle) return {Subject::Kind::kObstacle, {}, {}};
  return builder_.next_segment();
}

std::size_t RecordReader::read(std::size_t at) {
  const auto hash = text_.find('#', at);
  const bool has_hash = hash != text_.npos;
  const std::size_t end = has_hash ? hash : text_.size();
  if (trimmed(text_.substr(at, end - at)).empty()) {
    if (has_hash) {
      defects_.add(FindingCode::F119, hash, "'#' closes nothing; remove it");
      defects_.fix(hash, hash + 1, "");
    }
    return has_hash ? end + 1 : end;
  }
  while (at < end) {
    const Run run = run_at(at, end, has_hash);
    read_run(run);
    at = run.end;
  }
  return has_hash ? end + 1 : end;
}

// A keyword begins a new run, but not where a semantic string stands: there it may be a label.
RecordReader::Run RecordReader::run_at(std::size_t at, std::size_t end, bool has_end) const {
  FieldWalker walker(text_, at, end);
  Run run{at, end, 0, {}, has_end};
  const auto first_keyword = keyword_of(field_at(text_, at, end).text);
  const std::size_t header = first_keyword.empty() ? 0 : kHeaderFields + 1;
  for (std::size_t index = 0; !walker.done(); ++index) {
    const std::size_t begin = walker.at();
    const Field field = walker.next();
    const bool is_semantic = index < header
                                 ? index == kHeaderFields
                                 : (index - header) % kSegmentFields == kSegmentFields - 1;
    if (index > 0 && !keyword_of(field.text).empty() &&
        (!is_semantic || follows_obstacle(walker))) {
      run.end = begin;
      run.has_end = true;
      return run;
    }
    if (field.closed) {
      ++run.closed_fields;
    } else {
      run.tail = field;
    }
  }
  return run;
}

RecordReader::Opening RecordReader::opening_of(const Run& run) {
  const Field first = field_at(text_, run.begin, run.end);
  if (const auto word = keyword_of(first.text); !word.empty()) {
    const Kind kind = (word[0] | ' ') == 'b' ? Kind::kBorder : Kind::kObstacle;
    return keyword_opening(run, first, kind, word);
  }
  if (const auto opening = misspelt_opening(run, first)) return *opening;
  return segment_opening(run, first);
}

RecordReader::Opening RecordReader::keyword_opening(const Run& run, const Field& first, Kind kind,
                                                    std::string_view word) {
  Opening opening;
  opening.kind = kind;
  opening.offset = static_cast<std::size_t>(word.data() - text_.data());
  const std::size_t word_end = opening.offset + word.size();
  const std::size_t lead = opening.offset - first.offset;
  if (lead > 0) report_stray({trimmed(first.text.substr(0, lead)), first.offset, 0, false});
  if (word != "border" && word != "obstacle") {
    defects_.add(FindingCode::F121, opening.offset,
                 "the keyword " + quoted(word) + " must be written in small letters");
    defects_.fix(opening.offset, word_end, kind == Kind::kBorder ? "border" : "obstacle");
  }
  const bool is_alone = lead + word.size() == first.text.size();
  if (!is_alone) {
    defects_.add(FindingCode::F120, word_end,
                 "';' is missing behind the keyword " + std::string(word));
    defects_.fix(word_end, word_end, ";");
  }
  opening.fields = is_alone ? first.next : word_end;
  opening.count = run.closed_fields - (is_alone && first.closed ? 1 : 0);
  opening.tail = first.closed ? run.tail : field_at(text_, opening.fields, run.end);
  return opening;
}

std::optional<RecordReader::Opening> RecordReader::misspelt_opening(const Run& run,
                                                                    const Field& first) {
  if (run.closed_fields != kHeaderFields + 1 || !run.tail.text.empty()) return std::nullopt;
  if (first.text.empty() || !std::all_of(first.text.begin(), first.text.end(), is_letter)) {
    return std::nullopt;
  }
  const FieldWalker values(text_, first.next, run.end);
  const bool is_obstacle = follows_obstacle(values);
  if (!is_obstacle && !follows_border(values)) return std::nullopt;
  const std::string meant = is_obstacle ? "obstacle" : "border";
  defects_.add(FindingCode::F121, first.offset,
               "there is no keyword " + quoted(first.text) + "; read as " + meant);
  defects_.fix(first.offset, first.offset + first.text.size(), meant);
  return Opening{is_obstacle ? Kind::kObstacle : Kind::kBorder, first.offset, first.next,
                 kHeaderFields, run.tail};
}

// Words before the first number belong to nothing: `" 4.53;12.10;…`.
RecordReader::Opening RecordReader::segment_opening(const Run& run, const Field& first) {
  Opening opening{Kind::kSegment, first.offset, first.offset, run.closed_fields, run.tail};
  const auto number = last_word(first.text);
  const auto stray = trimmed(first.text.substr(0, first.text.size() - number.size()));
  const bool has_stray = first.closed && !stray.empty() && is_number(number) &&
                         !is_number(first_word(stray)) && !is_number(last_word(stray));
  if (!has_stray) return opening;
  report_stray({stray, first.offset, 0, false});
  opening.offset = opening.fields = static_cast<std::size_t>(number.data() - text_.data());
  return opening;
}

void RecordReader::read_run(const Run& run) {
  const Opening opening = opening_of(run);
  const bool has_tail = !opening.tail.text.empty();
  const std::size_t fields = opening.count + (has_tail ? 1 : 0);
  if (are_records(opening, run.end, opening.count) && (run.has_end || !has_tail)) {
    const std::size_t stop = read_sequence(opening, run.end, opening.count);
    if (has_tail) report_stray(opening.tail);
    if (!is_closed(run)) report_missing_end(stop);
  } else if (!run.has_end) {
    read_unfinished(run, opening);
  } else if (has_tail && are_records(opening, run.end, fields)) {
    read_sequence(opening, run.end, fields);
    const std::size_t tail_end = opening.tail.offset + opening.tail.text.size();
    defects_.add(FindingCode::F120, tail_end, "';' is missing before '#'");
    defects_.fix(tail_end, tail_end, ";");
  } else {
    read_miscounted(run, opening);
    if (!is_closed(run)) report_missing_end(run.end);
  }
}

// One record, or several one after another: behind the first one only segments can follow.
bool RecordReader::are_records(const Opening& opening, std::size_t end, std::size_t fields) const {
  const std::size_t first = opening.kind == Kind::kSegment ? kSegmentFields : kHeaderFields;
  if (fields < first || (fields - first) % kSegmentFields != 0) return false;
  if (fields == first) return true;
  FieldWalker walker(text_, opening.fields, end);
  if (opening.kind != Kind::kSegment) {
    take<kHeaderFields>(walker);
    fields -= kHeaderFields;
  }
  for (; fields > 0; fields -= kSegmentFields) {
    if (!looks_like_segment(walker)) return false;
    take<kSegmentFields>(walker);
  }
  return true;
}

// Returns where the last record ends.
std::size_t RecordReader::read_sequence(const Opening& opening, std::size_t end,
                                        std::size_t fields) {
  FieldWalker walker(text_, opening.fields, end);
  read_record(opening.kind, opening.offset, walker);
  fields -= opening.kind == Kind::kSegment ? kSegmentFields : kHeaderFields;
  for (; fields >= kSegmentFields; fields -= kSegmentFields) {
    report_missing_end(walker.at());
    read_record(Kind::kSegment, field_at(text_, walker.at(), end).offset, walker);
  }
  return walker.at();
}

void RecordReader::read_record(Kind kind, std::size_t offset, FieldWalker& walker) {
  if (kind == Kind::kBorder) {
    builder_.border(offset, values_.border(take<kHeaderFields>(walker)));
  } else if (kind == Kind::kObstacle) {
    builder_.obstacle(values_.obstacle(offset, take<kHeaderFields>(walker)));
  } else {
    auto segment = values_.segment(subject(kind), take<kSegmentFields>(walker));
    if (segment) {
      builder_.segment(offset, *std::move(segment));
    } else {
      builder_.unreadable_segment(offset);
    }
  }
}

void RecordReader::read_miscounted(const Run& run, const Opening& opening) {
  const std::size_t fields = opening.count + (opening.tail.text.empty() ? 0 : 1);
  if (read_without_semantic(run, opening, fields)) return;
  if (read_with_split_semantic(run, opening, fields)) return;
  const FieldWalker values(text_, opening.fields, run.end);
  if (opening.kind == Kind::kSegment && !holds_a_number(values)) {
    report_stray({trimmed(text_.substr(opening.offset, run.end - opening.offset)), opening.offset,
                  0, false});
    return;
  }
  report_count(opening, fields, "; left out");
  leave_out(opening);
}

// The record with `semantic` in the place of its own last field.
void RecordReader::read_with_semantic(const Opening& opening, std::size_t end,
                                      const Field& semantic) {
  FieldWalker walker(text_, opening.fields, end);
  if (opening.kind == Kind::kObstacle) {
    auto fields = take<kHeaderFields>(walker);
    fields.back() = semantic;
    builder_.obstacle(values_.obstacle(opening.offset, fields));
  } else {
    auto fields = take<kSegmentFields>(walker);
    fields.back() = semantic;
    auto segment = values_.segment(subject(opening.kind), fields);
    if (segment) builder_.segment(opening.offset, *std::move(segment));
  }
}

bool RecordReader::read_without_semantic(const Run& run, const Opening& opening,
                                         std::size_t fields) {
  const bool of_segment = opening.kind == Kind::kSegment;
  const std::size_t wanted = (of_segment ? kSegmentFields : kHeaderFields) - 1;
  if (opening.kind == Kind::kBorder || fields != wanted) return false;
  const FieldWalker values(text_, opening.fields, run.end);
  if (!(of_segment ? holds_segment_values(values) : holds_obstacle_values(values))) return false;
  report_count(opening, fields, "; the semantic string is missing, read as empty");
  read_with_semantic(opening, run.end, Field{{}, run.end, run.end, false});
  return true;
}

bool RecordReader::read_with_split_semantic(const Run& run, const Opening& opening,
                                            std::size_t fields) {
  const bool of_segment = opening.kind == Kind::kSegment;
  const std::size_t wanted = of_segment ? kSegmentFields : kHeaderFields;
  if (opening.kind == Kind::kBorder || fields <= wanted) return false;
  FieldWalker walker(text_, opening.fields, run.end);
  if (!(of_segment ? holds_segment_values(walker) : holds_obstacle_values(walker))) return false;
  for (std::size_t i = 0; i + 1 < wanted; ++i) walker.next();
  const std::size_t begin = walker.at();
  if (holds_a_number(walker)) return false;
  std::string joined;
  for (std::size_t i = wanted; i <= fields; ++i) {
    if (i > wanted) joined += ',';
    joined += walker.next().text;
  }
  report_count(opening, fields,
               "; there can be no ';' in a semantic string, read as " + quoted(joined));
  Field semantic{joined, field_at(text_, begin, run.end).offset, run.end, true};
  read_with_semantic(opening, run.end, semantic);
  return true;
}

// The text ends within the run: whole records at its beginning count.
void RecordReader::read_unfinished(const Run& run, const Opening& opening) {
  const std::size_t first = opening.kind == Kind::kSegment ? kSegmentFields : kHeaderFields;
  std::size_t whole = 0;
  if (opening.count >= first) whole = opening.count - (opening.count - first) % kSegmentFields;
  Opening rest = opening;
  if (whole > 0 && are_records(opening, run.end, whole)) {
    const std::size_t stop = read_sequence(opening, run.end, whole);
    report_missing_end(stop);
    rest.kind = Kind::kSegment;
    rest.offset = rest.fields = field_at(text_, stop, run.end).offset;
    rest.count -= whole;
  }
  if (is_cut_) return;
  const bool is_stray =
      rest.kind == Kind::kSegment && rest.count == 0 && !is_number(last_word(rest.tail.text));
  if (is_stray) {
    report_stray(rest.tail);
    return;
  }
  const std::size_t wanted = rest.kind == Kind::kSegment ? kSegmentFields : kHeaderFields;
  defects_.add(FindingCode::F116, rest.offset, subject(rest.kind),
               "the file ends within the record, behind " + std::to_string(rest.count) + " of " +
                   std::to_string(wanted) + " fields; left out");
  if (rest.kind == Kind::kSegment) builder_.unreadable_segment(rest.offset);
}

void RecordReader::leave_out(const Opening& opening) {
  switch (opening.kind) {
    case Kind::kBorder:
      builder_.border(opening.offset, std::nullopt);
      break;
    case Kind::kObstacle: {
      ObstacleHeader header;
      header.offset = opening.offset;
      builder_.obstacle(std::move(header));
      break;
    }
    case Kind::kSegment:
      builder_.unreadable_segment(opening.offset);
      break;
  }
}

// A keyword ends a run too, but closes no record. What bytes that are no text cut off is reported
// as such.
bool RecordReader::is_closed(const Run& run) const {
  return run.end < text_.size() ? text_[run.end] == '#' : is_cut_;
}

void RecordReader::report_missing_end(std::size_t at) {
  defects_.add(FindingCode::F107, at, "'#' is missing here, behind the last field of a record");
  defects_.fix(at, at, "#");
}

void RecordReader::report_stray(const Field& field) {
  defects_.add(FindingCode::F117, field.offset,
               quoted(field.text) + " belongs to no record; remove it");
}

void RecordReader::report_count(const Opening& opening, std::size_t fields,
                                std::string_view consequence) {
  const bool of_segment = opening.kind == Kind::kSegment;
  const std::string_view layout = of_segment ? "ax;ay;bx;by;h;inOut;semantic;"
                                  : opening.kind == Kind::kObstacle ? "id;ST;NS;semantic;"
                                                                    : "mx1;my1;mx4;my4;";
  defects_.add(FindingCode::F108, opening.offset, subject(opening.kind),
               "the record has " + std::to_string(fields) + (fields == 1 ? " field" : " fields") +
                   " instead of " + std::to_string(of_segment ? kSegmentFields : kHeaderFields) +
                   " (" + std::string(layout) + ")" + std::string(consequence));
}

}  // namespace mapwright::text
