#include "converter/indoorgml/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::converter {
namespace {

constexpr double kLevel_m = 0.01;    // of a floor's corners
constexpr double kAgreement = 0.25;  // of the areas that look up and down
constexpr double kLeastSlope = 0.2;  // of the normal of a face that looks up or down, to z

Vertex cross(const Vertex& p, const Vertex& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
Vertex minus(const Vertex& p, const Vertex& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
double dot(const Vertex& p, const Vertex& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

// Twice the area, along the normal (Newell).
Vertex area_vector(const VertexPath& ring) {
  Vertex sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vertex n = cross(minus(ring[i], ring[0]), minus(ring[i + 1], ring[0]));
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  return sum;
}

// The volume that a face spans with a point is positive where the face looks away from it.
double signed_volume(const std::vector<Face>& faces) {
  double volume = 0.0;
  const Vertex& base = faces.front().rings.front().front();
  for (const auto& face : faces) {
    for (const auto& ring : face.rings) volume += dot(area_vector(ring), minus(ring.front(), base));
  }
  return volume;
}

double flat_area(const Face& face) {
  double area = std::abs(doubled_area(face.rings.front()));
  for (std::size_t i = 1; i < face.rings.size(); ++i) area -= std::abs(doubled_area(face.rings[i]));
  return 0.5 * area;
}

bool is_sound(const Face& face) {
  return !face.rings.empty() &&
         std::all_of(face.rings.begin(), face.rings.end(),
                     [](const VertexPath& ring) { return ring.size() >= 3; });
}

std::vector<Face> looking_down(const std::vector<Face>& faces) {
  const double sign = signed_volume(faces) < 0.0 ? -1.0 : 1.0;
  std::vector<Face> down;
  double down_area = 0.0, up_area = 0.0;
  for (const auto& face : faces) {
    const Vertex n = area_vector(face.rings.front());
    if (std::abs(n.z) <= kLeastSlope * std::sqrt(dot(n, n))) continue;
    const bool is_down = sign * n.z < 0.0;
    (is_down ? down_area : up_area) += flat_area(face);
    if (is_down) down.push_back(face);
  }
  if (std::abs(down_area - up_area) > kAgreement * std::max(down_area, up_area)) down.clear();
  return down;
}

// Where faces wind as they like: those in the lower half of the cell.
std::vector<Face> in_the_lower_half(const std::vector<Face>& faces, double middle) {
  std::vector<Face> low;
  for (const auto& face : faces) {
    const auto& ring = face.rings.front();
    const Vertex n = area_vector(ring);
    if (std::abs(n.z) <= kLeastSlope * std::sqrt(dot(n, n))) continue;
    const bool is_low =
        std::all_of(ring.begin(), ring.end(), [&](const Vertex& v) { return v.z <= middle; });
    if (is_low) low.push_back(face);
  }
  return low;
}

}  // namespace

double doubled_area(const VertexPath& ring) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum += (ring[i].x - ring[0].x) * (ring[i + 1].y - ring[0].y) -
           (ring[i].y - ring[0].y) * (ring[i + 1].x - ring[0].x);
  }
  return sum;
}

std::optional<Footprint> footprint_of(const IndoorObject& cell) {
  std::vector<Face> faces;
  std::copy_if(cell.faces.begin(), cell.faces.end(), std::back_inserter(faces), is_sound);
  if (faces.empty()) return std::nullopt;
  Footprint print;
  double foot = faces.front().rings.front().front().z, top = foot;
  for (const auto& face : faces) {
    for (const auto& vertex : face.rings.front()) {
      foot = std::min(foot, vertex.z);
      top = std::max(top, vertex.z);
    }
  }
  if (cell.has_heights) print.floor = foot;
  if (top - foot <= kLevel_m) {
    print.faces = std::move(faces);
  } else {
    print.top = top;
    print.faces = looking_down(faces);
    if (print.faces.empty()) print.faces = in_the_lower_half(faces, 0.5 * (foot + top));
  }
  for (const auto& face : print.faces) print.area += flat_area(face);
  if (!(print.area > 0.0)) return std::nullopt;
  return print;
}

}  // namespace mapwright::converter
