#include <algorithm>
#include <numeric>

#include "navcore/exact/line_grid.hpp"
#include "navcore/exact/line_work.hpp"

namespace mapwright::navcore::exact {
namespace {

__extension__ using Wide = __int128;

// Where lines meet other than end to end.
struct Meetings {
  std::vector<GridPoint> crossings;  // rounded to the grid
  bool any = false;
  bool all_on_grid = true;            // no crossing had to be rounded
  std::optional<GridPoint> off_grid;  // the first that had to be
};

bool boxes_meet(const Line& p, const Line& q) {
  return std::max(p.a.x, p.b.x) >= std::min(q.a.x, q.b.x) &&
         std::max(q.a.x, q.b.x) >= std::min(p.a.x, p.b.x) &&
         std::max(p.a.y, p.b.y) >= std::min(q.a.y, q.b.y) &&
         std::max(q.a.y, q.b.y) >= std::min(p.a.y, p.b.y);
}

// floor(numerator / denominator + 1/2), and whether nothing was rounded.
std::int64_t rounded_quotient(Wide numerator, Wide denominator, bool& exact) {
  Wide quotient = numerator / denominator;
  Wide rest = numerator % denominator;
  if (rest < 0) rest += denominator, --quotient;
  exact = exact && rest == 0;
  return static_cast<std::int64_t>(2 * rest >= denominator ? quotient + 1 : quotient);
}

// The crossing p.a + (p.b − p.a) · s / (s − t) for sides s ≠ t of p's ends.
GridPoint rounded_crossing(const Line& p, std::int64_t s, std::int64_t t, bool& exact) {
  Wide numerator = s, denominator = Wide{s} - t;
  if (denominator < 0) numerator = -numerator, denominator = -denominator;
  const Wide x = (Wide{p.b.x} - p.a.x) * numerator, y = (Wide{p.b.y} - p.a.y) * numerator;
  return {static_cast<std::int32_t>(p.a.x + rounded_quotient(x, denominator, exact)),
          static_cast<std::int32_t>(p.a.y + rounded_quotient(y, denominator, exact))};
}

constexpr int sign(std::int64_t value) {
  return (value > 0) - (value < 0);
}

bool is_inside(GridPoint p, const Line& line) {
  return p != line.a && p != line.b && is_on_segment(p, line.a, line.b);
}

void meet(const Line& p, const Line& q, Meetings& meetings) {
  const std::int64_t pa = orient(q.a, q.b, p.a), pb = orient(q.a, q.b, p.b);
  if (sign(pa) * sign(pb) > 0) return;
  const std::int64_t qa = orient(p.a, p.b, q.a), qb = orient(p.a, p.b, q.b);
  if (sign(qa) * sign(qb) > 0) return;
  if (sign(pa) * sign(pb) < 0 && sign(qa) * sign(qb) < 0) {
    meetings.any = true;
    meetings.crossings.push_back(rounded_crossing(p, pa, pb, meetings.all_on_grid));
    if (!meetings.all_on_grid && !meetings.off_grid) meetings.off_grid = meetings.crossings.back();
  } else if (is_inside(p.a, q) || is_inside(p.b, q) || is_inside(q.a, p) || is_inside(q.b, p)) {
    meetings.any = true;
  }
}

Meetings find_meetings(const std::vector<Line>& lines, const LineGrid& grid) {
  Meetings meetings;
  for (std::size_t bucket = 0; bucket < grid.bucket_count(); ++bucket) {
    const auto here = grid.lines_in(bucket);
    for (std::size_t i = 0; i < here.size(); ++i) {
      for (std::size_t j = i + 1; j < here.size(); ++j) {
        const Line &p = lines[here[i]], &q = lines[here[j]];
        if (boxes_meet(p, q)) meet(p, q, meetings);
      }
    }
  }
  return meetings;
}

// True if the segment ab meets the half-open unit square around p (left and lower side included).
bool meets_square(GridPoint p, GridPoint a, GridPoint b) {
  if (p.x < std::min(a.x, b.x) || p.x > std::max(a.x, b.x) || p.y < std::min(a.y, b.y) ||
      p.y > std::max(a.y, b.y)) {
    return false;
  }
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t reach = std::abs(dx) + std::abs(dy);
  const std::int64_t side = 2 * std::abs(orient(a, b, p));
  if (side != reach) return side < reach;
  // The line touches one corner only: it counts if that is the lower left one.
  const bool falls = (dx > 0) != (dy > 0);
  const bool below = (orient(a, b, p) > 0) == (dx > 0);
  return falls && dx != 0 && dy != 0 && below;
}

// Buckets of points, aligned with a LineGrid.
class PointBuckets {
 public:
  PointBuckets(const LineGrid& grid, std::vector<GridPoint> points) : grid_(grid) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    first_.assign(grid.bucket_count() + 1, 0);
    for (const GridPoint p : points) ++first_[grid.bucket_of(p) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    points_.resize(points.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const GridPoint p : points) points_[next[grid.bucket_of(p)]++] = p;
  }

  // The points on the line, ends included, in its direction.
  void collect(const Line& line, bool exactly, std::vector<GridPoint>& on) const {
    on.clear();
    grid_.for_each_bucket(line.a, line.b, [&](std::size_t bucket) {
      for (std::size_t i = first_[bucket]; i < first_[bucket + 1]; ++i) {
        const GridPoint p = points_[i];
        if (exactly ? is_on_segment(p, line.a, line.b) : meets_square(p, line.a, line.b)) {
          on.push_back(p);
        }
      }
    });
    std::sort(on.begin(), on.end(), [&](GridPoint p, GridPoint q) {
      const auto along_p = dot_from(line.a, line.b, p), along_q = dot_from(line.a, line.b, q);
      return along_p != along_q ? along_p < along_q : p < q;
    });
  }

 private:
  const LineGrid& grid_;
  std::vector<std::size_t> first_;
  std::vector<GridPoint> points_;
};

std::vector<GridPoint> all_ends(const std::vector<Line>& lines) {
  std::vector<GridPoint> ends;
  ends.reserve(2 * lines.size());
  for (const Line& line : lines) {
    ends.push_back(line.a);
    ends.push_back(line.b);
  }
  return ends;
}

std::vector<Line> cut(const std::vector<Line>& lines, const LineGrid& grid, Meetings meetings) {
  std::vector<GridPoint> stops = all_ends(lines);
  stops.insert(stops.end(), meetings.crossings.begin(), meetings.crossings.end());
  const PointBuckets buckets(grid, std::move(stops));
  std::vector<Line> pieces;
  pieces.reserve(lines.size() + 2 * meetings.crossings.size());
  std::vector<GridPoint> on;
  for (const Line& line : lines) {
    buckets.collect(line, meetings.all_on_grid, on);
    for (std::size_t i = 1; i < on.size(); ++i) {
      pieces.push_back({on[i - 1], on[i], line.source});
    }
  }
  return pieces;
}

// An end of a line.
struct End {
  std::uint64_t key;
  std::uint32_t number;  // 2 · line, + 1 for its end
};

// The bits of a number with a gap before each.
std::uint64_t spread(std::uint32_t number) {
  std::uint64_t bits = number;
  bits = (bits | bits << 16U) & 0x0000'ffff'0000'ffffU;
  bits = (bits | bits << 8U) & 0x00ff'00ff'00ff'00ffU;
  bits = (bits | bits << 4U) & 0x0f0f'0f0f'0f0f'0f0fU;
  bits = (bits | bits << 2U) & 0x3333'3333'3333'3333U;
  return (bits | bits << 1U) & 0x5555'5555'5555'5555U;
}

// Position on the Z-order curve (Morton, 1966): neighbours in the order are mostly neighbours in
// the plane, so what follows works on memory that is near.
std::uint64_t key_of(GridPoint p) {
  constexpr std::uint32_t kSignBit = 1U << 31U;
  return spread(static_cast<std::uint32_t>(p.x) ^ kSignBit) |
         spread(static_cast<std::uint32_t>(p.y) ^ kSignBit) << 1U;
}

// Fills in the vertices; gives the vertex of each line's start and end.
std::vector<std::uint32_t> number_vertices(const std::vector<Line>& lines,
                                           std::vector<GridPoint>& vertices) {
  std::vector<End> ends;
  ends.reserve(2 * lines.size());
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    ends.push_back({key_of(lines[i].a), 2 * i});
    ends.push_back({key_of(lines[i].b), 2 * i + 1});
  }
  std::sort(ends.begin(), ends.end(), [](const End& p, const End& q) { return p.key < q.key; });
  std::vector<std::uint32_t> vertex_of_end(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Line& line = lines[ends[i].number / 2];
    if (i == 0 || ends[i].key != ends[i - 1].key) {
      vertices.push_back(ends[i].number % 2 == 0 ? line.a : line.b);
    }
    vertex_of_end[ends[i].number] = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  return vertex_of_end;
}

struct NumberedPiece {
  std::uint64_t ends;  // smaller vertex number above the larger one
  Piece piece;
};

std::vector<NumberedPiece> number_pieces(const std::vector<Line>& lines,
                                         const std::vector<std::uint32_t>& vertex_of_end) {
  std::vector<NumberedPiece> pieces;
  pieces.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::uint64_t a = vertex_of_end[2 * i], b = vertex_of_end[2 * i + 1];
    const bool reversed = a > b;
    if (reversed) std::swap(a, b);
    pieces.push_back({a << 32U | b, {lines[i].source, reversed}});
  }
  std::sort(pieces.begin(), pieces.end(), [](const NumberedPiece& p, const NumberedPiece& q) {
    if (p.ends != q.ends) return p.ends < q.ends;
    if (p.piece.source != q.piece.source) return p.piece.source < q.piece.source;
    return p.piece.reversed < q.piece.reversed;
  });
  return pieces;
}

// Numbers vertices and joins lines that run along the same edge.
LineWork join(const std::vector<Line>& lines) {
  LineWork work;
  const auto vertex_of_end = number_vertices(lines, work.vertices);
  const auto pieces = number_pieces(lines, vertex_of_end);
  work.pieces.reserve(pieces.size());
  work.edges.reserve(pieces.size());
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || pieces[i].ends != pieces[i - 1].ends) {
      work.edges.push_back({static_cast<std::uint32_t>(pieces[i].ends >> 32U),
                            static_cast<std::uint32_t>(pieces[i].ends), i, i});
    }
    work.edges.back().last_piece = i + 1;
    work.pieces.push_back(pieces[i].piece);
  }
  return work;
}

std::vector<Line> without_points(const std::vector<Line>& lines) {
  std::vector<Line> rest;
  rest.reserve(lines.size());
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(rest),
               [](const Line& line) { return line.a != line.b; });
  return rest;
}

constexpr double kHalfDiagonal_mm = 0.7072;

}  // namespace

LineWork node(const std::vector<Line>& input) {
  std::vector<Line> lines = without_points(input);
  double displacement_mm = 0.0;
  std::optional<GridPoint> displaced_at;
  while (true) {
    const LineGrid grid(lines);
    Meetings meetings = find_meetings(lines, grid);
    if (!meetings.any) break;
    if (!meetings.all_on_grid) displacement_mm += kHalfDiagonal_mm;
    if (!displaced_at) displaced_at = meetings.off_grid;
    lines = cut(lines, grid, std::move(meetings));
  }
  LineWork work = join(lines);
  work.displacement_mm = displacement_mm;
  work.displaced_at = displaced_at;
  return work;
}

}  // namespace mapwright::navcore::exact
