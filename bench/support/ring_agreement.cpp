#include "bench/support/ring_agreement.hpp"

#include <geos_c.h>

#include <iomanip>
#include <sstream>
#include <string>

#include "bench/support/exact_rings.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright::bench {
namespace {

using Ring = std::vector<Point>;

class Geos {
 public:
  Geos() : context_(GEOS_init_r()) {}
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(context_); }

  // True if the polygon with this outline is valid (OGC 06-103r4, 6.1.11).
  bool is_valid(const Ring& ring) const {
    auto* sequence = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(ring.size() + 1), 2);
    for (unsigned i = 0; i <= ring.size(); ++i) {
      const Point p = ring[i == ring.size() ? 0 : i];
      GEOSCoordSeq_setXY_r(context_, sequence, i, p.x, p.y);
    }
    auto* outline = GEOSGeom_createLinearRing_r(context_, sequence);
    if (outline == nullptr) return false;  // too few points
    auto* polygon = GEOSGeom_createPolygon_r(context_, outline, nullptr, 0);
    const char answer = GEOSisValid_r(context_, polygon);
    GEOSGeom_destroy_r(context_, polygon);
    return answer == 1;
  }

  // True if GEOS sees three of the vertices turn another way than they do.
  bool misjudges_a_turn(const Ring& ring) const {
    for (const Point a : ring) {
      for (const Point b : ring) {
        for (const Point p : ring) {
          const int side = GEOSOrientationIndex_r(context_, a.x, a.y, b.x, b.y, p.x, p.y);
          if (side != static_cast<int>(turn(a, b, p))) return true;
        }
      }
    }
    return false;
  }

 private:
  GEOSContextHandle_t context_;
};

bool repeats_in_a_row(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] == ring[i + 1 == ring.size() ? 0 : i + 1]) return true;
  }
  return false;
}

Ring without_repeats(const Ring& ring) {
  Ring kept;
  for (const Point p : ring) {
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

// GEOS takes a vertex that stands twice in a row as one; here it is a segment without length
// (G103). Such a disagreement is explained if both agree on the ring without the repetition; any
// other only if GEOS is wrong about some turn.
RingOutcome compare(const Ring& ring, const Geos& geos) {
  const bool ours = is_simple_ring(ring);
  if (ours != is_simple_exactly(ring)) return RingOutcome::kUnexplainedCgal;
  const bool theirs = geos.is_valid(ring);
  if (ours == theirs) return ours ? RingOutcome::kAllValid : RingOutcome::kAllInvalid;
  const Ring kept = without_repeats(ring);
  const bool only_repeats = theirs && repeats_in_a_row(ring) && is_simple_ring(kept);
  if (only_repeats) return RingOutcome::kRepeatsInARow;
  return geos.misjudges_a_turn(ring) ? RingOutcome::kBelowDoubleDouble
                                     : RingOutcome::kUnexplainedGeos;
}

std::string ring_text(const Ring& ring, RingKind kind, std::uint64_t number) {
  std::ostringstream out;
  out << "ring " << number << " (" << to_string(kind) << "): POLYGON((" << std::setprecision(17);
  for (const Point p : ring) out << p.x << ' ' << p.y << ", ";
  out << ring.front().x << ' ' << ring.front().y << "))";
  return out.str();
}

}  // namespace

std::string_view to_string(RingOutcome outcome) {
  static constexpr std::array<std::string_view, kRingOutcomes> kNames{
      "all say valid",       "all say invalid",   "vertex twice in a row",
      "below double-double", "UNEXPLAINED: GEOS", "UNEXPLAINED: CGAL"};
  return kNames[static_cast<std::size_t>(outcome)];
}

RingAgreement compare_rings(std::uint64_t rings, std::uint64_t seed) {
  constexpr std::size_t kMostExamples = 20;
  const Geos geos;
  RingAgreement agreement;
  for (std::uint64_t i = 0; i < rings; ++i) {
    Random random(seed, i);
    const auto kind = static_cast<RingKind>(i % kRingKinds);
    const Ring ring = random_ring(kind, random);
    const RingOutcome outcome = compare(ring, geos);
    ++agreement.counts[static_cast<std::size_t>(kind)][static_cast<std::size_t>(outcome)];
    if (outcome < RingOutcome::kUnexplainedGeos) continue;
    ++agreement.unexplained;
    if (agreement.examples.size() < kMostExamples) {
      agreement.examples.push_back(ring_text(ring, kind, i));
    }
  }
  return agreement;
}

}  // namespace mapwright::bench
