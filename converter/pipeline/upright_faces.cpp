#include "converter/pipeline/upright_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {
namespace {

// Lower than that, heights are those of the ground. A line that is no face is a wall all the same,
// and surveyors' lines that run back along themselves have heights that differ.
constexpr double kLeastFace_m = tolerance::kLeastStepRise_m;
constexpr double kLeastFaceOfLine_m = 0.1;

// Along a face: what is nearer together is one place.
constexpr double kLeastStretch_m = 1e-3;

struct Vertex {
  Point at;
  double z = 0.0;
};

using Face = std::vector<Vertex>;  // the first vertex is not repeated

// Lines count that end over the point they begin at: some writers leave the last edge out.
Face face_of(const SourceGeometry& geometry, const SourcePath& path, double resolution_m) {
  Face face;
  for (std::size_t i = path.first; i < path.first + path.count; ++i) {
    face.push_back({{geometry.xs[i], geometry.ys[i]}, geometry.zs[i]});
  }
  if (face.empty() || path.role == PathRole::kPoint) return {};
  if (path.role == PathRole::kLine && distance(face.front().at, face.back().at) > resolution_m) {
    return {};
  }
  const bool repeats = face.front().at == face.back().at && face.front().z == face.back().z;
  if (repeats) face.pop_back();
  return face.size() < 3 ? Face() : face;
}

std::pair<double, double> heights_of(const Face& face) {
  const auto [low, high] = std::minmax_element(
      face.begin(), face.end(), [](const Vertex& p, const Vertex& q) { return p.z < q.z; });
  return {low->z, high->z};
}

std::size_t farthest(const Face& face, Point from) {
  const auto further = [&](const Vertex& p, const Vertex& q) {
    return squared_length(p.at - from) < squared_length(q.at - from);
  };
  return static_cast<std::size_t>(std::max_element(face.begin(), face.end(), further) -
                                  face.begin());
}

// The ends of the footprint in the order they are drawn, where it is a straight line.
std::optional<std::pair<Point, Point>> straight_footprint(const Face& face, double resolution_m) {
  const std::size_t one = farthest(face, face.front().at);
  const std::size_t other = farthest(face, face[one].at);
  const Point a = face[std::min(one, other)].at, b = face[std::max(one, other)].at;
  const double reach = distance(a, b);
  if (!(reach > resolution_m)) return std::nullopt;
  for (const auto& vertex : face) {
    if (std::abs(cross(b - a, vertex.at - a)) > resolution_m * reach) return std::nullopt;
  }
  return std::pair(a, b);
}

struct Heights {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
};

// Where a face begins and ends over a place of its straight footprint.
Heights heights_at(const Face& face, Point a, Point along, double s) {
  Heights heights;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto& p = face[i];
    const auto& q = face[(i + 1) % face.size()];
    const double from = dot(p.at - a, along), to = dot(q.at - a, along);
    if (s < std::min(from, to) || s > std::max(from, to)) continue;
    const double t = from == to ? 0.0 : (s - from) / (to - from);
    heights.add(p.z + t * (q.z - p.z));
    if (from == to) heights.add(q.z);
  }
  return heights;
}

constexpr std::size_t kMostVertices = 1000;  // each looks at all

// The greatest height; over sloping ground that is less than from the lowest to the highest point.
double height_over(const Face& face, Point a, Point b) {
  const auto [low, high] = heights_of(face);
  if (face.size() > kMostVertices) return high - low;
  const Point along = (1.0 / distance(a, b)) * (b - a);
  double height = 0.0;
  for (const auto& vertex : face) {
    const auto heights = heights_at(face, a, along, dot(vertex.at - a, along));
    height = std::max(height, heights.high - heights.low);
  }
  return std::min(height, high - low);
}

// Whether a doorway is cut out of the face: its lower edge jumps up by more than stairs would.
bool has_doorway(const Face& face, Point a, Point b) {
  constexpr double kLeastDoorway_m = 1.0;
  if (face.size() > kMostVertices) return false;
  const Point along = (1.0 / distance(a, b)) * (b - a);
  std::vector<double> places;
  for (const auto& vertex : face) places.push_back(dot(vertex.at - a, along));
  std::sort(places.begin(), places.end());
  std::optional<double> low_before;  // at the end of the stretch before
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double width = places[i + 1] - places[i];
    if (!(width > kLeastStretch_m)) continue;
    constexpr double kInside = 1e-3;  // of a stretch: at its very end another edge may stand
    const double low = heights_at(face, a, along, places[i] + kInside * width).low;
    if (low_before && std::abs(low - *low_before) > kLeastDoorway_m) return true;
    low_before = heights_at(face, a, along, places[i + 1] - kInside * width).low;
  }
  return false;
}

struct PointOrder {
  bool operator()(Point p, Point q) const { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }
};

std::vector<Point> footprint_of(const Face& face, const Snap& snap) {
  std::vector<Point> ring;
  for (const auto& vertex : face) {
    const Point p = snap(vertex.at);
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

// The greatest difference of heights over one place.
double height_over_places(const Face& face, const Snap& snap) {
  std::map<Point, std::pair<double, double>, PointOrder> places;
  for (const auto& vertex : face) {
    auto& [low, high] = places.try_emplace(snap(vertex.at), vertex.z, vertex.z).first->second;
    low = std::min(low, vertex.z);
    high = std::max(high, vertex.z);
  }
  double height = 0.0;
  for (const auto& [at, heights] : places) {
    height = std::max(height, heights.second - heights.first);
  }
  return height;
}

bool covers_ground(const std::vector<Point>& ring, double resolution_m, const Snap& snap) {
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    length += distance(ring[i], ring[(i + 1) % ring.size()]);
  }
  if (std::abs(signed_area_m2(ring)) > 0.5 * resolution_m * length) return true;
  const std::vector<std::vector<Point>> rings{ring};
  const auto parts = odd_even_polygons(rings, snap);  // a figure eight has no signed area either
  return !parts || !parts->empty();
}

class FaceCollector {
 public:
  FaceCollector(const SourceGeometry& geometry, double resolution_m, const Snap& snap)
      : geometry_(geometry), resolution_m_(resolution_m), snap_(snap) {}

  std::vector<UprightFace> collect() {
    for (std::size_t i = 0; i < geometry_.paths.size(); ++i) add(i);
    return std::move(faces_);
  }

 private:
  void add(std::size_t i) {
    const auto& path = geometry_.paths[i];
    if (path.role == PathRole::kInnerRing) {
      if (outer_is_upright_) add_opening(i);
      return;
    }
    outer_is_upright_ = false;
    const Face face = face_of(geometry_, path, resolution_m_);
    if (face.empty()) return;
    const double least_m = path.role == PathRole::kLine ? kLeastFaceOfLine_m : kLeastFace_m;
    const auto [low, high] = heights_of(face);
    if (!(high - low > least_m) || !std::isfinite(high - low)) return;
    const std::size_t before = faces_.size();
    if (const auto ends = straight_footprint(face, resolution_m_)) {
      const double height = height_over(face, ends->first, ends->second);
      if (height > least_m) {
        keep(i, {snap_(ends->first), snap_(ends->second)}, low, low + height);
        if (faces_.size() > before) {
          faces_.back().has_openings = has_doorway(face, ends->first, ends->second);
        }
      }
    } else if (const double height = height_over_places(face, snap_); height > least_m) {
      add_bent(i, face, low, low + height);
    }
    outer_is_upright_ = faces_.size() > before;
  }

  void add_opening(std::size_t i) {
    faces_.back().paths.push_back(i);
    faces_.back().has_openings = true;
  }

  void add_bent(std::size_t i, const Face& face, double bottom_m, double top_m) {
    auto ring = footprint_of(face, snap_);
    if (ring.size() < 3 || covers_ground(ring, resolution_m_, snap_)) return;
    ring.push_back(ring.front());
    const auto chains = simple_chains(std::move(ring), snap_);
    if (!chains) return;
    for (const auto& chain : *chains) keep(i, chain, bottom_m, top_m);
  }

  void keep(std::size_t i, std::vector<Point> line, double bottom_m, double top_m) {
    if (line.size() == 2 && line[0] == line[1]) return;
    faces_.push_back({{i}, std::move(line), geometry_.paths[i].curved, false, bottom_m, top_m});
  }

  const SourceGeometry& geometry_;
  double resolution_m_;
  const Snap& snap_;
  std::vector<UprightFace> faces_;
  bool outer_is_upright_ = false;
};

// The same whichever way it is drawn.
std::vector<Point> undirected(const std::vector<Point>& line) {
  std::vector<Point> reversed(line.rbegin(), line.rend());
  return PointOrder()(reversed.front(), line.front()) ? reversed : line;
}

struct LineOrder {
  bool operator()(const std::vector<Point>& p, const std::vector<Point>& q) const {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), PointOrder());
  }
};

// Two triangles that make a rectangle are one wall.
std::vector<UprightFace> one_a_line(std::vector<UprightFace> faces) {
  std::map<std::vector<Point>, std::size_t, LineOrder> known;
  std::vector<UprightFace> kept;
  for (auto& face : faces) {
    const auto [place, is_new] = known.try_emplace(undirected(face.line), kept.size());
    if (is_new) {
      kept.push_back(std::move(face));
      continue;
    }
    auto& same = kept[place->second];
    same.bottom_m = std::min(same.bottom_m, face.bottom_m);
    same.top_m = std::max(same.top_m, face.top_m);
    same.has_openings = same.has_openings || face.has_openings;
    same.paths.insert(same.paths.end(), face.paths.begin(), face.paths.end());
  }
  return kept;
}

}  // namespace

std::vector<UprightFace> upright_faces(const SourceGeometry& geometry, double resolution_m,
                                       const Snap& snap) {
  if (geometry.zs.empty()) return {};
  return one_a_line(FaceCollector(geometry, resolution_m, snap).collect());
}

}  // namespace mapwright::converter
