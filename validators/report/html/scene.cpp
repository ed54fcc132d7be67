#include "validators/report/html/scene.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "mapcore/obstacle_kind.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

std::string json_string(std::string_view text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void append(std::string& json, double value) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), value);
  json.append(std::begin(buffer), result.ptr);
}

void append(std::string& json, std::size_t value) {
  json += std::to_string(value);
}

void append(std::string& json, Point p) {
  append(json, p.x);
  json += ',';
  append(json, p.y);
}

void append(std::string& json, std::span<const Point> points) {
  json += '[';
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) json += ',';
    append(json, points[i]);
  }
  json += ']';
}

// Runs of segments that join end to end.
void append_paths(std::string& json, const std::vector<Segment>& segments) {
  json += '[';
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool joins = i > 0 && segments[i - 1].b == segments[i].a;
    if (!joins) {
      json += i == 0 ? "[" : "],[";
      append(json, segments[i].a);
    }
    json += ',';
    append(json, segments[i].b);
  }
  json += segments.empty() ? "]" : "]]";
}

// One value where all are equal, else all.
template <class Value>
void append_shared(std::string& json, const std::vector<Value>& values) {
  if (values.empty()) {
    json += '0';
    return;
  }
  const bool shared = std::all_of(values.begin(), values.end(),
                                  [&](const Value& value) { return value == values.front(); });
  if (shared) return append(json, values.front());
  for (std::size_t i = 0; i < values.size(); ++i) {
    json += i == 0 ? '[' : ',';
    append(json, values[i]);
  }
  json += ']';
}

// The convex hull of all ends: of stairs good enough to fill.
std::vector<Point> hull(const std::vector<Segment>& segments) {
  std::vector<Point> points;
  for (const auto& segment : segments) points.insert(points.end(), {segment.a, segment.b});
  std::sort(points.begin(), points.end(),
            [](Point p, Point q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  std::vector<Point> ring;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t floor = ring.size();
    for (auto p = begin; p != end; ++p) {
      while (ring.size() >= floor + 2 &&
             cross(ring.back() - ring[ring.size() - 2], *p - ring.back()) <= 0.0) {
        ring.pop_back();
      }
      ring.push_back(*p);
    }
    ring.pop_back();
  };
  if (points.size() < 3) return {};
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return ring;
}

void append_area(std::string& json, const Obstacle& obstacle) {
  if (obstacle.shape_type == ShapeType::kStairs) {
    append(json, std::span<const Point>(hull(obstacle.segments)));
  } else {
    json += is_closed(obstacle.shape_type) ? '1' : '0';
  }
}

template <class Value, class Get>
std::vector<Value> column(const std::vector<Segment>& segments, const Get& get) {
  std::vector<Value> values;
  values.reserve(segments.size());
  for (const auto& segment : segments) values.push_back(get(segment));
  return values;
}

// The outline that an inner ring says it belongs to.
std::optional<std::int64_t> outer_ring_id(const Obstacle& obstacle) {
  const auto text = obstacle.semantic.value(semantic_key::kInnerOf);
  if (!text) return std::nullopt;
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), id);
  if (error != std::errc{} || end != text->data() + text->size()) return std::nullopt;
  return id;
}

void begin_entry(std::string& list) {
  if (!list.empty()) list += ",\n";
}

// Of the style sheet, in the order of ObstacleKind.
constexpr std::array<const char*, 9> kKindStyles = {
    "ramp", "stairs", "low", "plants", "building", "column", "room", "wall", "low-wall"};

}  // namespace

SceneWriter::SceneWriter(const Border& border, std::vector<SceneLayer> layers)
    : border_(border), layers_(std::move(layers)) {}

std::size_t SceneWriter::text_number(const Semantic& semantic) {
  const auto [entry, is_new] = text_numbers_.try_emplace(semantic.str(), texts_.size());
  if (is_new) texts_.push_back(semantic.str());
  return entry->second;
}

std::size_t SceneWriter::obstacle(const Obstacle& obstacle, std::size_t layer,
                                  const SceneFacts& facts) {
  const auto& segments = obstacle.segments;
  begin_entry(rows_);
  rows_ += '[' + std::to_string(layer) + ',' + std::to_string(obstacle.id) + ',' +
           std::to_string(static_cast<int>(obstacle.shape_type)) + ',' +
           std::to_string(text_number(obstacle.semantic)) + ',';
  append_paths(rows_, segments);
  rows_ += ',';
  append_area(rows_, obstacle);
  rows_ += ',';
  append_shared(rows_, column<double>(segments, [](const Segment& s) { return s.height_m; }));
  rows_ += ',';
  append_shared(
      rows_, column<std::size_t>(segments, [](const Segment& s) { return std::size_t(s.in_out); }));
  rows_ += ',';
  append_shared(rows_, column<std::size_t>(
                           segments, [&](const Segment& s) { return text_number(s.semantic); }));
  for (std::size_t i = 0; i < facts.size(); ++i) {
    rows_ += (i == 0 ? ",[[" : ",[") + json_string(facts[i].first) + ',' + json_string(facts[i].second) + ']';
  }
  rows_ += facts.empty() ? "]" : "]]";
  return obstacles_++;
}

void SceneWriter::hole(std::size_t inner, std::size_t outer) {
  begin_entry(holes_);
  holes_ += '[' + std::to_string(inner) + ',' + std::to_string(outer) + ']';
}

void SceneWriter::line(std::size_t layer, std::span<const Point> points, bool arrow) {
  begin_entry(marks_);
  marks_ += "{\"layer\":" + std::to_string(layer) + ",\"line\":";
  append(marks_, points);
  marks_ += arrow ? ",\"arrow\":true}" : "}";
}

void SceneWriter::box(std::size_t layer, const Box& box) {
  begin_entry(marks_);
  marks_ += "{\"layer\":" + std::to_string(layer) + ",\"box\":";
  const std::array<Point, 2> corners = {Point{box.min_x, box.min_y}, Point{box.max_x, box.max_y}};
  append(marks_, std::span<const Point>(corners));
  marks_ += '}';
}

void SceneWriter::dot(std::size_t layer, Point at) {
  begin_entry(marks_);
  marks_ += "{\"layer\":" + std::to_string(layer) + ",\"dot\":[";
  append(marks_, at);
  marks_ += "]}";
}

std::string SceneWriter::json() const {
  Json layers = Json::array();
  for (const auto& layer : layers_)
    layers.push_back({{"name", layer.name}, {"style", layer.style}});
  std::string json = "{\"border\":";
  const std::array<Point, 2> corners = {Point{border_.left, border_.top},
                                        Point{border_.right, border_.bottom}};
  append(json, std::span<const Point>(corners));
  json += ",\"layers\":" + layers.dump() +
          ",\"texts\":" + Json(texts_).dump(-1, ' ', false, Json::error_handler_t::replace);
  json += ",\"obstacles\":[" + rows_ + "],\"holes\":[" + holes_ + "],\"marks\":[" + marks_ + "]}";
  return json;
}

std::vector<SceneLayer> kind_layers() {
  std::vector<SceneLayer> layers;
  for (std::size_t i = 0; i < kKindStyles.size(); ++i) {
    layers.push_back({std::string(to_string(static_cast<ObstacleKind>(i))), kKindStyles[i]});
  }
  return layers;
}

void add_map(SceneWriter& scene, const Map& map) {
  std::unordered_map<std::int64_t, std::size_t> numbers;
  std::vector<std::size_t> rows;
  for (const auto& obstacle : map.obstacles) {
    rows.push_back(scene.obstacle(obstacle, static_cast<std::size_t>(obstacle_kind(obstacle))));
    numbers.try_emplace(obstacle.id, rows.back());
  }
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const auto outer = outer_ring_id(map.obstacles[i]);
    const auto found = outer ? numbers.find(*outer) : numbers.end();
    if (found != numbers.end() && found->second != rows[i]) scene.hole(rows[i], found->second);
  }
}

}  // namespace mapwright::validators
