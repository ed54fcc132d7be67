// What a check gets to see, and where it reports.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"
#include "validators/shape/edge_finder.hpp"
#include "validators/shape/nesting.hpp"
#include "validators/shape/outline.hpp"
#include "validators/survey/survey.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// Two obstacles by their positions in Map::obstacles, first < second.
struct ObstaclePair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// The map under validation, and what several checks derive from it: computed when first asked for,
/// then shared. One thread at a time. The document must outlive the context.
class CheckContext {
 public:
  CheckContext(const MapDocument& document, const ValidationOptions& options,
               Proofs proofs = Proofs::kAll);
  /// With a survey of the document's map that was made before.
  CheckContext(const MapDocument& document, const ValidationOptions& options, Survey survey);
  CheckContext(const CheckContext&) = delete;
  CheckContext& operator=(const CheckContext&) = delete;
  ~CheckContext();

  const Map& map() const { return document_.map; }
  const MapDocument& document() const { return document_; }
  const ValidationOptions& options() const { return options_; }

  /// True if the map has a border record that could be read (else family F tells).
  bool border_was_read() const;

  /// True if a border could be read and its corners stand right (else G101 or family F tells).
  bool has_usable_border() const;

  /// False where the reader had to leave out segments of the obstacle: then nothing can be said
  /// about how its segments follow each other, and family F has said why.
  bool is_complete(std::size_t obstacle) const;

  /// What one look at each obstacle showed.
  const Survey& survey() const;

  /// The obstacles that a check must look at, ascending: see Doubt.
  const Positions& in_doubt(Doubt doubt) const { return survey().in_doubt(doubt); }

  /// Box around an obstacle; empty where it has no segments.
  const Box& box(std::size_t obstacle) const { return survey().boxes()[obstacle]; }

  /// What kind of shape an obstacle is.
  const Outline& outline(std::size_t obstacle) const;

  /// Pairs of obstacles whose boxes meet, in ascending order.
  const std::vector<ObstaclePair>& meeting_pairs() const;

  /// Pairs of obstacles that may come as near to each other as `near_miss_m`, in ascending order.
  const std::vector<ObstaclePair>& near_pairs() const;

  /// Which ring holds which obstacle.
  const Nesting& nesting() const;

  /// The segments of an obstacle, by place.
  const EdgeFinder& edges(std::size_t obstacle) const;

 private:
  struct Derived;
  const MapDocument& document_;
  const ValidationOptions& options_;
  std::unique_ptr<Derived> derived_;
};

/// Collects findings and adds their places.
class FindingSink {
 public:
  explicit FindingSink(const MapDocument& document) : document_(document) {}

  void border(FindingCode code, std::string message);

  /// About the obstacle at position `obstacle`; stands at its first point and shows all of it.
  void obstacle(FindingCode code, std::size_t obstacle, ObstacleField field, std::string message);

  /// About a segment (0-based); `at` is where on the map. Shows the segment, and `at` where that is
  /// not its beginning.
  void segment(FindingCode code, std::size_t obstacle, std::size_t segment, SegmentField field,
               Point at, std::string message);

  /// About a segment as a whole; stands at its first point.
  void segment(FindingCode code, std::size_t obstacle, std::size_t segment, std::string message);

  /// What the last finding shows; checks that know better than the defaults change it.
  DefectGeometry& geometry() { return findings_.back().geometry; }

  /// Gives the last finding a proven repair.
  void fix(TextEdit edit) { findings_.back().fix.push_back(std::move(edit)); }

  /// Gives the last finding another severity than the catalogue's.
  void soften(Severity severity) { findings_.back().severity = severity; }

  std::vector<Finding> take() { return std::move(findings_); }

 private:
  const MapDocument& document_;
  std::vector<Finding> findings_;
};

/// Every check is a function of this kind, `check_<defect>` in checks/<defect>.cpp, and a line in
/// checks.def.
using Check = void(const CheckContext&, FindingSink&);

#define MAPWRIGHT_CHECK(name) Check check_##name;
#include "validators/checks.def"
#undef MAPWRIGHT_CHECK

}  // namespace mapwright::validators
