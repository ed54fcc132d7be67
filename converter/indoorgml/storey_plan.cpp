#include "converter/indoorgml/storey_plan.hpp"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <iterator>
#include <set>
#include <unordered_map>

#include "converter/indoorgml/door_fit.hpp"

namespace mapwright::converter {
namespace {

constexpr double kOneLine_m = 0.05;  // walls nearer than this are one
constexpr double kThickestWall_m = 0.6;
constexpr double kHighestSill_m = 0.3;
constexpr double kReach_m = 0.5;        // from a door to the room it leads to
constexpr double kLargestWay_m2 = 2.5;  // floor of a cell that stands in a wall as a door

bool is_letter(char c) {
  return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z');
}

// Words of a text, in lower case: "PublicSafetyDoor" has three, storey="1":indoor="room" as well.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : ' ';
    const bool upper = 'A' <= c && c <= 'Z';
    const bool goes_on_in_lower =
        !word.empty() && i > 0 && 'a' <= text[i - 1] && text[i - 1] <= 'z';
    if ((!is_letter(c) || (upper && goes_on_in_lower)) && !word.empty()) {
      words.insert(word);
      word.clear();
    }
    if (is_letter(c)) word += static_cast<char>(upper ? c - 'A' + 'a' : c);
  }
  return words;
}

bool says(const IndoorObject& object, std::initializer_list<const char*> any) {
  const auto words = words_of(object.type + " " + object.use_class + " " + object.function + " " +
                              object.usage + " " + object.description);
  return std::any_of(any.begin(), any.end(),
                     [&](const char* word) { return words.count(word) > 0; });
}

std::pair<std::size_t, std::size_t> sorted_pair(std::size_t p, std::size_t q) {
  return {std::min(p, q), std::max(p, q)};
}

Point flat(const Vertex& v) {
  return {v.x, v.y};
}

void add(const std::vector<Face>& faces, Box& box) {
  for (const auto& face : faces) {
    for (const auto& vertex : face.rings.front()) box.add(flat(vertex));
  }
}

Box box_of(const Footprint& print) {
  Box box = kEmptyBox;
  add(print.faces, box);
  return box;
}

Box box_of(const IndoorObject& boundary) {
  Box box = kEmptyBox;
  add(boundary.faces, box);
  for (const auto& line : boundary.lines) {
    for (const auto& vertex : line) box.add(flat(vertex));
  }
  return box;
}

bool meet(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

// Outer rings clockwise, holes the other way: the floor lies on the right.
void append_ring(const VertexPath& ring, bool outer, std::size_t owner,
                 std::vector<WallEdge>& edges) {
  std::vector<Point> points;
  for (const auto& vertex : ring) points.push_back(flat(vertex));
  if ((doubled_area(ring) > 0.0) == outer) std::reverse(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    if (a != b) edges.push_back({a, b, owner});
  }
}

}  // namespace

IndoorRole role_of_cell(const IndoorObject& cell) {
  return says(cell, {"non", "nonnavigable", "obstacle", "object", "furniture", "column"})
             ? IndoorRole::kObject
             : IndoorRole::kRoom;
}

IndoorRole role_of_boundary(const IndoorObject& boundary,
                            const std::unordered_set<std::string>& duals_of_transitions) {
  if (says(boundary, {"window", "non", "nonnavigable"})) return IndoorRole::kWall;
  const bool passes =
      says(boundary, {"door", "connection", "transfer", "anchor", "navigable", "virtual"});
  const bool is_dual = !boundary.duals.empty() || duals_of_transitions.count(boundary.id) > 0;
  return passes || is_dual ? IndoorRole::kOpening : IndoorRole::kWall;
}

std::vector<std::vector<Point>> ground_lines(const IndoorObject& boundary) {
  std::vector<std::vector<Point>> lines;
  for (const auto& line : boundary.lines) {
    auto& points = lines.emplace_back();
    for (const auto& vertex : line) {
      if (points.empty() || points.back() != flat(vertex)) points.push_back(flat(vertex));
    }
    if (points.size() < 2) lines.pop_back();
  }
  for (const auto& face : boundary.faces) {
    std::vector<Point> longest;
    const auto& ring = face.rings.front();
    for (const auto& p : ring) {
      for (const auto& q : ring) {
        if (longest.empty() || distance(flat(p), flat(q)) > distance(longest[0], longest[1]))
          longest = {flat(p), flat(q)};
      }
    }
    if (longest.size() == 2 && longest[0] != longest[1]) lines.push_back(std::move(longest));
  }
  return lines;
}

StoreyPlan::StoreyPlan(const IndoorDocument& document,
                       const std::vector<std::optional<Footprint>>& footprints, Storey storey,
                       double metres_per_unit)
    : document_(document),
      footprints_(footprints),
      storey_(std::move(storey)),
      metres_per_unit_(metres_per_unit) {
  std::copy_if(storey_.cells.begin(), storey_.cells.end(), std::back_inserter(grounds_),
               [this](std::size_t cell) { return is_ground(cell); });
  find_openings();
  join_cells_of_transitions();
  for (const std::size_t cell : storey_.cells) {
    if (is_way(cell)) ways_.insert(cell);
  }
  WallRules rules;
  rules.tolerance = kOneLine_m / metres_per_unit;
  rules.are_open = [this](std::size_t p, std::size_t q) { return are_open(p, q); };
  auto all = edges();
  fit_doors(all, rules);
  lines_ = std::make_unique<WallLines>(std::move(all), std::move(rules));
}

// In the document's order, so that the same document gives the same map.
void StoreyPlan::fit_doors(const std::vector<WallEdge>& edges, WallRules& rules) {
  const DoorLimits limits{rules.tolerance, kThickestWall_m / metres_per_unit_,
                          document_.cells.size()};
  const auto index = index_of(edges);
  for (const std::size_t boundary : storey_.boundaries) {
    if (!is_opening(boundary)) continue;
    bool opens = false;
    double farthest = 0.0;
    const auto lines = ground_lines(document_.boundaries[boundary]);
    for (const auto& line : lines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const OpenLine door(line[i], line[i + 1]);
        const auto fit = fit_door(door, edges, index, limits);
        rules.openings.push_back(door);
        rules.openings.insert(rules.openings.end(), fit.faces.begin(), fit.faces.end());
        jambs_.insert(jambs_.end(), fit.jambs.begin(), fit.jambs.end());
        opens = opens || fit.opens;
        farthest = std::max(farthest, fit.farthest);
      }
    }
    if (!lines.empty()) remark(boundary, opens, farthest * metres_per_unit_);
  }
}

void StoreyPlan::remark(std::size_t boundary, bool opens, double farthest_m) {
  if (!opens) {
    remarks_[boundary] = "a door at no wall: it opens none";
    idle_doors_.push_back(document_.boundaries[boundary].id);
  } else if (farthest_m > 0.0) {
    char text[96];
    std::snprintf(text, sizeof text,
                  "a door %.2f m beside a face of its wall: that face was opened too", farthest_m);
    remarks_[boundary] = text;
  }
}

std::string StoreyPlan::remark_about_door(std::size_t boundary) const {
  const auto remark = remarks_.find(boundary);
  return remark == remarks_.end() ? std::string() : remark->second;
}

double StoreyPlan::sill_of_cell(std::size_t cell) const {
  const auto& print = footprints_[cell];
  if (!print || !print->floor || is_ground(cell)) return 0.0;
  return *print->floor - ground_at(box_of(*print), *print->floor);
}

// What one stands on: a room, and none of the size of a door or a window.
bool StoreyPlan::is_ground(std::size_t cell) const {
  const auto& print = footprints_[cell];
  return print && print->floor &&
         print->area * metres_per_unit_ * metres_per_unit_ > kLargestWay_m2 &&
         role_of_cell(document_.cells[cell]) == IndoorRole::kRoom;
}

// The highest floor below a place of the rooms around it that reach up to it, since a ramp's lowest
// point may be far; where there is none, the place itself.
double StoreyPlan::ground_at(const Box& box, double z) const {
  const Box around = box.inflated(kReach_m / metres_per_unit_);
  std::optional<double> ground;
  for (const std::size_t cell : grounds_) {
    const auto& print = *footprints_[cell];
    if (*print.floor <= z && print.top.value_or(*print.floor) > z && meet(around, box_of(print))) {
      ground = std::max(ground.value_or(*print.floor), *print.floor);
    }
  }
  return ground.value_or(z);
}

// A cell in the wall that one walks through.
bool StoreyPlan::is_way(std::size_t cell) const {
  const auto& object = document_.cells[cell];
  if (role_of_cell(object) == IndoorRole::kObject || says(object, {"window"})) return false;
  return says(object, {"connection", "anchor", "door"}) && sill_of_cell(cell) <= kHighestSill_m;
}

bool StoreyPlan::are_open(std::size_t cell, std::size_t other) const {
  if (cell >= document_.cells.size() || other >= document_.cells.size()) return false;
  if (ways_.count(cell) > 0 || ways_.count(other) > 0) return true;
  return std::binary_search(joined_.begin(), joined_.end(), sorted_pair(cell, other));
}

void StoreyPlan::find_openings() {
  std::unordered_set<std::string> duals;
  for (const auto& object : document_.graph) {
    if (says(object, {"transition"})) duals.insert(object.duals.begin(), object.duals.end());
  }
  for (const std::size_t i : storey_.boundaries) {
    const auto& boundary = document_.boundaries[i];
    if (role_of_boundary(boundary, duals) != IndoorRole::kOpening) continue;
    const auto foot = foot_of(boundary);
    const double sill = foot ? *foot - ground_at(box_of(boundary), *foot) : 0.0;
    if (sill <= kHighestSill_m) openings_.insert(i);
  }
}

// A transition without a boundary of its own says that there is a way, and where only if one of its
// cells is no larger than a door.
void StoreyPlan::join_cells_of_transitions() {
  std::unordered_map<std::string, std::size_t> cell_of_id, cell_of_state;
  for (const std::size_t cell : storey_.cells) {
    cell_of_id.emplace(document_.cells[cell].id, cell);
    cell_of_state.emplace(document_.cells[cell].id, cell);  // some name the cells themselves
    for (const auto& state : document_.cells[cell].duals) cell_of_state.emplace(state, cell);
  }
  for (const auto& object : document_.graph) {
    if (says(object, {"transition"}) || object.duals.empty()) continue;
    const auto cell = cell_of_id.find(object.duals.front());
    if (cell != cell_of_id.end()) cell_of_state.emplace(object.id, cell->second);
  }
  const auto is_small = [&](std::size_t cell) {
    const double area = footprints_[cell] ? footprints_[cell]->area : 0.0;
    return area * metres_per_unit_ * metres_per_unit_ <= kLargestWay_m2 &&
           sill_of_cell(cell) <= kHighestSill_m && !says(document_.cells[cell], {"window"});
  };
  for (const auto& object : document_.graph) {
    if (!says(object, {"transition"}) || object.connects.size() != 2) continue;
    const auto p = cell_of_state.find(object.connects[0]);
    const auto q = cell_of_state.find(object.connects[1]);
    if (p == cell_of_state.end() || q == cell_of_state.end()) continue;
    if (is_small(p->second) || is_small(q->second)) {
      joined_.push_back(sorted_pair(p->second, q->second));
    }
  }
  std::sort(joined_.begin(), joined_.end());
}

std::vector<WallEdge> StoreyPlan::edges() const {
  std::vector<WallEdge> edges;
  for (const std::size_t cell : storey_.cells) {
    if (!footprints_[cell] || role_of_cell(document_.cells[cell]) == IndoorRole::kObject) continue;
    for (const auto& face : footprints_[cell]->faces) {
      for (const auto& ring : face.rings) append_ring(ring, &ring == &face.rings[0], cell, edges);
    }
  }
  for (const std::size_t boundary : storey_.boundaries) {
    if (is_opening(boundary)) continue;
    for (const auto& line : ground_lines(document_.boundaries[boundary])) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        edges.push_back({line[i], line[i + 1], document_.cells.size() + boundary});
      }
    }
  }
  return edges;
}

std::vector<std::vector<Point>> StoreyPlan::walls_of_cell(std::size_t cell) const {
  auto walls = lines_->of(cell);
  for (const auto& jamb : jambs_) {
    if (jamb.owner == cell) walls.push_back({jamb.a, jamb.b});
  }
  return walls;
}

std::vector<std::vector<Point>> StoreyPlan::walls_of_boundary(std::size_t boundary) const {
  return lines_->of(document_.cells.size() + boundary);
}

}  // namespace mapwright::converter
