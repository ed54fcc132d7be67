#include "navcore/exact/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

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

// The vertices come in an order that keeps neighbours together. A coarse sample of them goes first,
// then finer ones: no long row of points is ever added to an empty plane, which is slow.
std::vector<std::uint32_t> insertion_order(std::size_t count) {
  std::vector<std::uint32_t> order;
  order.reserve(count);
  constexpr std::size_t kCoarsest = 4096, kRatio = 8;
  for (std::size_t stride = kCoarsest; stride > 0; stride /= kRatio) {
    for (std::size_t i = 0; i < count; i += stride) {
      const bool is_in = stride < kCoarsest && i % (stride * kRatio) == 0;
      if (!is_in) order.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return order;
}

Cdt build(const LineWork& work) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles(work.vertices.size());
  Cdt::Face_handle hint;
  for (const std::uint32_t i : insertion_order(handles.size())) {
    const GridPoint p = work.vertices[i];
    handles[i] = cdt.insert(Kernel::Point_2(p.x, p.y), hint);
    handles[i]->info() = i;
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
