#include "navcore/exact/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>

namespace mapwright::navcore::exact {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                       CGAL::No_constraint_intersection_tag>;

std::vector<Kernel::Point_2> kernel_points(const LineWork& work) {
  std::vector<Kernel::Point_2> points;
  points.reserve(work.vertices.size());
  for (const GridPoint p : work.vertices) points.emplace_back(p.x, p.y);
  return points;
}

// Points close in the plane are inserted one after the other, so that each is found from the last.
std::vector<std::size_t> insertion_order(const std::vector<Kernel::Point_2>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  using PointOf = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;
  const PointOf point_of(points.data());
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, PointOf>(point_of));
  return order;
}

Cdt build(const LineWork& work) {
  const auto points = kernel_points(work);
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles(points.size());
  Cdt::Face_handle hint;
  for (const std::size_t i : insertion_order(points)) {
    handles[i] = cdt.insert(points[i], hint);
    handles[i]->info() = static_cast<std::uint32_t>(i);
    hint = handles[i]->face();
  }
  for (const Edge& edge : work.edges) cdt.insert_constraint(handles[edge.a], handles[edge.b]);
  return cdt;
}

// Finds the edge between two vertices.
class EdgeFinder {
 public:
  explicit EdgeFinder(const LineWork& work) : edges_(work.edges), first_(work.vertices.size() + 1) {
    for (const Edge& edge : edges_) ++first_[edge.a + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  // Requires an edge between a and b.
  std::int32_t operator()(std::uint32_t a, std::uint32_t b) const {
    if (a > b) std::swap(a, b);
    std::uint32_t i = first_[a];
    while (edges_[i].b != b) ++i;
    return static_cast<std::int32_t>(i);
  }

 private:
  const std::vector<Edge>& edges_;
  std::vector<std::uint32_t> first_;
};

constexpr int kNext[3] = {1, 2, 0};
constexpr int kOpposite[3] = {2, 0, 1};  // the corner across side i

Triangle to_triangle(const Cdt& cdt, Cdt::Face_handle face, const EdgeFinder& edge_between) {
  Triangle triangle;
  for (int i = 0; i < 3; ++i) triangle.corner[i] = face->vertex(i)->info();
  for (int i = 0; i < 3; ++i) {
    const auto across = face->neighbor(kOpposite[i]);
    triangle.neighbour[i] = cdt.is_infinite(across) ? -1 : across->info();
    triangle.edge[i] = face->is_constrained(kOpposite[i])
                           ? edge_between(triangle.corner[i], triangle.corner[kNext[i]])
                           : -1;
  }
  return triangle;
}

}  // namespace

std::vector<Triangle> triangulate(const LineWork& work) {
  const Cdt cdt = build(work);
  std::vector<Triangle> triangles;
  if (cdt.dimension() < 2) return triangles;
  std::int32_t count = 0;
  for (const auto face : cdt.finite_face_handles()) face->info() = count++;
  const EdgeFinder edge_between(work);
  triangles.reserve(static_cast<std::size_t>(count));
  for (const auto face : cdt.finite_face_handles()) {
    triangles.push_back(to_triangle(cdt, face, edge_between));
  }
  return triangles;
}

}  // namespace mapwright::navcore::exact
