#include "converter/pipeline/exported_obstacles.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "converter/exchange/edited_semantic.hpp"
#include "converter/exchange/edited_styles.hpp"
#include "converter/exchange/fields.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

namespace field = exchange_field;
using Json = nlohmann::ordered_json;
using Ring = std::vector<Point>;

std::vector<Point> points_of(const SourceGeometry& geometry, const SourcePath& path,
                             const Workspace& workspace) {
  std::vector<Point> points;
  points.reserve(path.count);
  for (std::size_t i = path.first; i < path.first + path.count; ++i) {
    points.push_back(workspace.snapped({geometry.xs[i], geometry.ys[i]}));
  }
  return points;
}

Ring ring_of(const FeatureTask& task, const SourcePath& path, const Workspace& workspace) {
  Ring ring = points_of(task.feature.geometry, path, workspace);
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

// The first vertex stays the first, whichever way round a format stores rings.
void orient(Ring& ring, RingOrientation wanted) {
  const auto found = ring_orientation(ring);
  if (found == wanted || found == RingOrientation::kDegenerate) return;
  std::reverse(ring.begin() + 1, ring.end());
}

std::vector<Segment> chain(const std::vector<Point>& points, bool closed,
                           const std::vector<SegmentStyle>& styles) {
  std::vector<Segment> segments;
  const std::size_t count = points.empty() ? 0 : points.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& style = styles[i];
    segments.push_back({points[i], points[i + 1 == points.size() ? 0 : i + 1], style.height_m,
                        style.in_out, style.semantic});
  }
  return segments;
}

std::vector<Json> hole_records(const ExchangeFields& fields) {
  const auto text = fields.text(field::kHoles);
  if (!text) return {};
  const Json list = Json::parse(*text, nullptr, false);
  std::vector<Json> records;
  if (!list.is_array()) return records;
  for (const auto& item : list) records.push_back(item.is_object() ? item : Json::object());
  return records;
}

std::optional<std::string> text_in(const Json& record, std::string_view name) {
  const auto found = record.find(name);
  if (found == record.end()) return std::nullopt;
  return found->is_string() ? found->get<std::string>() : found->dump();
}

std::optional<std::int64_t> integer_in(const Json& record, std::string_view name) {
  const auto text = text_in(record, name);
  return text ? exact_integer(*text) : std::nullopt;
}

}  // namespace

// Shape, id and semantic string of a hole, where its record says something.
void ExportedObstacles::take_identity(const nlohmann::ordered_json& record, std::size_t place,
                                      const Draft& outline, Hole& hole) {
  auto& obstacle = hole.draft.obstacle;
  hole.draft.recorded.reset();
  if (const auto shape = text_in(record, field::kShape)) {
    obstacle.shape_type = shape_named(*shape).value_or(obstacle.shape_type);
  }
  const auto id = integer_in(record, field::kId);
  const auto position = integer_in(record, field::kPos);
  if (!outline.recorded || !id || !position) return;
  hole.draft.recorded = {*id, place, *position};
  const auto semantic = text_in(record, field::kSemantic);
  if (!semantic) return;
  bool altered = false;
  obstacle.semantic = safe_semantic(*semantic, altered);
  hole.is_tied =
      obstacle.semantic.value(semantic_key::kInnerOf) == std::to_string(outline.recorded->id);
}

std::size_t ExportedObstacles::place_number(const std::string& place) {
  return places_.try_emplace(place, places_.size()).first->second;
}

void ExportedObstacles::say(const FeatureTask& task, bool height_is_missing, bool altered) {
  if (height_is_missing) {
    workspace_.ledger.remark(task.account, FindingCode::C216,
                             "no height is given: the rules' default stands in");
  }
  if (altered) {
    workspace_.ledger.change(task.account, FindingCode::C215,
                             "characters the map format reserves were replaced");
  }
}

// The first vertex is the top left one and the third the bottom right one, also of a border that
// is the wrong way round; what lies between is what the person made of it.
void ExportedObstacles::add_border(const FeatureTask& task) {
  const auto& geometry = task.feature.geometry;
  const Ring ring = ring_of(task, geometry.paths.front(), workspace_);
  Box box = kEmptyBox;
  for (const Point p : ring) box.add(p);
  Border border{box.min_x, box.max_y, box.max_x, box.min_y};
  const Point opposite = ring.size() > 2 ? ring[2] : ring.back();
  if (ring.front().x > opposite.x) std::swap(border.left, border.right);
  if (ring.front().y < opposite.y) std::swap(border.top, border.bottom);
  workspace_.exported_border = border;
  workspace_.ledger.remark(task.account, FindingCode::C227, "its extent is the map's border");
}

void ExportedObstacles::add(const FeatureTask& task, const ExchangeFields& fields,
                            const std::string& place) {
  const auto& paths = task.feature.geometry.paths;
  const std::string shape = fields.text(field::kShape).value_or("");
  const auto is_area = [](const SourcePath& path) { return path.role == PathRole::kOuterRing; };
  const bool has_area = std::any_of(paths.begin(), paths.end(), is_area);
  if (shape == kBorderShape && !paths.empty()) return add_border(task);
  const bool only_points = std::all_of(paths.begin(), paths.end(), [](const SourcePath& path) {
    return path.role == PathRole::kPoint;
  });
  if (!paths.empty() && only_points) {
    return workspace_.ledger.drop(task.account, FindingCode::C207, "a point has no outline");
  }

  bool altered = false;
  Draft draft = draft_for(task, shape_named(shape).value_or(has_area ? ShapeType::kClosedPolygon
                                                                     : ShapeType::kOpenPolygon));
  draft.obstacle.semantic = edited_semantic(fields, altered);
  say(task, false, altered);
  const Key key{place_number(place), fields.integer(field::kPos).value_or(0)};
  if (const auto id = fields.integer(field::kId)) draft.recorded = {*id, key.first, key.second};
  has_area ? add_polygons(task, fields, std::move(draft), key)
           : add_lines(task, fields, std::move(draft), key);
}

void ExportedObstacles::add_polygons(const FeatureTask& task, const ExchangeFields& fields,
                                     Draft draft, const Key& key) {
  const auto& paths = task.feature.geometry.paths;
  const bool inside = fields.text(field::kFreeSide).value_or("") == "inside";
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].role != PathRole::kOuterRing) continue;
    Ring ring = ring_of(task, paths[i], workspace_);
    orient(ring, inside ? RingOrientation::kClockwise : RingOrientation::kCounterClockwise);
    const auto edited = edited_styles([&](std::string_view name) { return fields.text(name); },
                                      ring.size(), workspace_.settings.default_height_m);
    say(task, edited.height_is_missing, edited.altered);
    Obstacle outline;
    outline.is_polygon = true;
    outline.draft = draft;
    outline.pieces.push_back({0, chain(ring, true, edited.styles), task.account});
    const bool is_new = !draft.recorded || known_.count(key) > 0;
    if (is_new) outline.draft.recorded.reset();
    add_holes(task, fields, outline, i + 1, key);
    if (is_new)
      fresh_.push_back(std::move(outline));
    else
      known_.emplace(key, std::move(outline));
  }
}

void ExportedObstacles::add_holes(const FeatureTask& task, const ExchangeFields& fields,
                                  Obstacle& outline, std::size_t first, const Key& key) {
  const auto& paths = task.feature.geometry.paths;
  const auto records = hole_records(fields);
  for (std::size_t i = first; i < paths.size() && paths[i].role == PathRole::kInnerRing; ++i) {
    const Json record = i - first < records.size() ? records[i - first] : Json::object();
    Hole hole{outline.draft, true};
    take_identity(record, key.first, outline.draft, hole);
    Ring ring = ring_of(task, paths[i], workspace_);
    orient(ring, RingOrientation::kClockwise);
    const bool has_styles = record.contains(field::kHeight);
    const auto edited = edited_styles(
        [&](std::string_view name) {
          if (has_styles) return text_in(record, name);
          return name == field::kRuns ? std::nullopt : fields.text(name);
        },
        ring.size(), workspace_.settings.default_height_m);
    hole.draft.obstacle.segments = chain(ring, true, edited.styles);
    outline.holes.push_back(std::move(hole));
  }
}

void ExportedObstacles::add_lines(const FeatureTask& task, const ExchangeFields& fields,
                                  Draft draft, const Key& key) {
  Piece piece;
  piece.part = fields.integer(field::kPart).value_or(0);
  piece.account = task.account;
  for (const auto& path : task.feature.geometry.paths) {
    if (path.role != PathRole::kLine) continue;
    const auto points = points_of(task.feature.geometry, path, workspace_);
    const auto edited =
        edited_styles([&](std::string_view name) { return fields.text(name); },
                      points.empty() ? 0 : points.size() - 1, workspace_.settings.default_height_m);
    say(task, edited.height_is_missing, edited.altered);
    for (auto& segment : chain(points, false, edited.styles)) {
      piece.segments.push_back(std::move(segment));
    }
  }
  add_piece(std::move(draft), std::move(piece), key);
}

// The next piece of an obstacle that is known already, a new one, or a copy of a piece.
void ExportedObstacles::add_piece(Draft draft, Piece piece, const Key& key) {
  const auto known = known_.find(key);
  if (draft.recorded && known == known_.end()) {
    known_.emplace(key, Obstacle{std::move(draft), {std::move(piece)}, {}, false});
    return;
  }
  const auto is_same_part = [&](const Piece& other) { return other.part == piece.part; };
  const bool belongs =
      draft.recorded && !known->second.is_polygon &&
      std::none_of(known->second.pieces.begin(), known->second.pieces.end(), is_same_part);
  if (belongs) {
    known->second.draft.features.push_back(piece.account);
    known->second.pieces.push_back(std::move(piece));
    return;
  }
  draft.recorded.reset();
  fresh_.push_back({std::move(draft), {std::move(piece)}, {}, false});
}

void ExportedObstacles::write(Obstacle& obstacle) {
  std::stable_sort(obstacle.pieces.begin(), obstacle.pieces.end(),
                   [](const Piece& p, const Piece& q) { return p.part < q.part; });
  auto& segments = obstacle.draft.obstacle.segments;
  for (auto& piece : obstacle.pieces) {
    std::move(piece.segments.begin(), piece.segments.end(), std::back_inserter(segments));
  }
  const std::size_t position = workspace_.drafts.size();
  workspace_.drafts.push_back(std::move(obstacle.draft));
  for (auto& hole : obstacle.holes) {
    if (hole.is_tied) hole.draft.inner_of = position;
    workspace_.drafts.push_back(std::move(hole.draft));
  }
}

void ExportedObstacles::finish() {
  for (auto& [key, obstacle] : known_) write(obstacle);
  for (auto& obstacle : fresh_) write(obstacle);
}

}  // namespace mapwright::converter
