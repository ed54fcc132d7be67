#include "tests/validators/mutation_places.hpp"

namespace mapwright::test {
namespace {

bool is_plain(const Obstacle& o) {
  return o.shape_type != ShapeType::kStairs && o.shape_type != ShapeType::kRamp;
}

void set_height(Obstacle& o, double height_m) {
  for (auto& segment : o.segments) segment.height_m = height_m;
}

double median_height_m(const Map& map) {
  std::vector<double> heights;
  for (const auto& o : map.obstacles) {
    if (is_plain(o)) heights.push_back(max_height_m(o));
  }
  std::sort(heights.begin(), heights.end());
  return heights[heights.size() / 2];
}

Answer mixed_height_units(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_plain).value();
  const double metres = median_height_m(map) * random.uniform(0.7, 3.0);
  if (100.0 * metres > 990.0 || 100.0 * metres < 60.0) return std::nullopt;
  set_height(map.obstacles[i], 100.0 * metres);
  return Expected{i, {1}};
}

Answer below_laser(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_plain).value();
  set_height(map.obstacles[i], random.uniform(0.03, 0.49));
  return Expected{i, {}};
}

Answer missing_height(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, is_plain).value();
  set_height(map.obstacles[i], 0.0);
  return Expected{i, {1}};
}

// The obstacle's string, or that of one of its segments.
Answer replace_semantic(Map& map, Random& random, const Semantic& text) {
  const auto i = any_obstacle(map, random, is_any).value();
  Obstacle& o = map.obstacles[i];
  if (random.below(2) == 0) {
    o.semantic = text;
    return Expected{i, {}};
  }
  const std::size_t k = any_segment(o, random);
  o.segments[k].semantic = text;
  return Expected{i, {k + 1}};
}

Answer misspelt_token(Map& map, Random& random) {
  static constexpr const char* kMisspelt[] = {"colum",      "biulding",   "benhc",    "fencee",
                                              "nmae=Hall",  "Name=Hall",  "levl=2",   "tabel",
                                              "flowerpott", "soruce=x:1", "monumint", "railling"};
  return replace_semantic(map, random, kMisspelt[random.below(12)]);
}

Answer malformed_token(Map& map, Random& random) {
  static constexpr const char* kMalformed[] = {"hall,level=", "hall,=3", "hall,name=A,name=B",
                                               "hall,source= ", "hall,="};
  return replace_semantic(map, random, kMalformed[random.below(5)]);
}

Answer duplicate_name(Map& map, Random& random) {
  const std::size_t later = 2 + random.below(map.obstacles.size() - 2);
  const std::size_t earlier = random.below(later - 1);
  map.obstacles[earlier].semantic = "hall,name=Twin";
  map.obstacles[later].semantic = "gym,name=Twin";
  return Expected{later, {}};
}

Answer in_out_mismatch(Map& map, Random& random) {
  const auto i = any_obstacle(map, random, [](const Obstacle& o) {
    return o.semantic.has_label("table") || o.semantic.has_label("fountain");
  });
  for (auto& segment : map.obstacles[*i].segments) segment.in_out = InOut::kIndoor;
  return Expected{i, {1}};
}

Answer mixed_in_out(Map& map, Random& random) {
  const auto i = any_obstacle(
      map, random, [](const Obstacle& o) { return is_ring(o) && o.segments.size() >= 4; });
  const std::size_t k = any_segment(map.obstacles[*i], random);
  map.obstacles[*i].segments[k].in_out = InOut::kIndoor;
  return Expected{i, {k + 1}};
}

}  // namespace

const std::vector<Mutator>& attribute_mutators() {
  static const std::vector<Mutator> all{
      {FindingCode::S120, mixed_height_units}, {FindingCode::S121, below_laser},
      {FindingCode::S122, missing_height},     {FindingCode::S123, misspelt_token},
      {FindingCode::S124, malformed_token},    {FindingCode::S125, duplicate_name},
      {FindingCode::S126, in_out_mismatch},    {FindingCode::S127, mixed_in_out}};
  return all;
}

}  // namespace mapwright::test
