// The map that a conversion makes, before it is text.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <vector>

#include "converter/pipeline/plain_obstacles.hpp"
#include "mapcore/map.hpp"
#include "mapcore/progress.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::converter {

/// A hole's semantic string, made to name the outline it lies in.
Semantic tied_to(std::int64_t outer, const Semantic& semantic);

/// A map a good deal smaller than a Map: obstacles that are chains of one style are kept as such.
class ConvertedMap {
 public:
  /// Obstacles that follow each other in the map: of PlainObstacles, or of the others.
  struct Run {
    bool plain = false;
    std::size_t first = 0, end = 0;
  };

  ConvertedMap() = default;
  explicit ConvertedMap(Map map)
      : border(map.border), others_(std::move(map.obstacles)), runs_{{false, 0, others_.size()}} {}
  /// `runs` is the order of the map. Ids are those that the obstacles have.
  ConvertedMap(PlainObstacles plain, std::vector<Obstacle> others, std::vector<Run> runs)
      : plain_(std::move(plain)), others_(std::move(others)), runs_(std::move(runs)) {}

  Border border;

  bool is_empty() const { return obstacle_count() == 0; }
  std::size_t obstacle_count() const { return plain_.all().size() + others_.size(); }
  std::size_t segment_count() const;
  /// Smallest box around all segments; kEmptyBox where there is none.
  Box extent() const;
  /// Those that are no plain chains, in no order: stairs among them.
  const std::vector<Obstacle>& others() const { return others_; }

  /// The text of the map: what write_map writes of `whole()`.
  void write(std::ostream& out, WriteOptions options, const Progress& progress = {}) const;
  Map whole() const;

 private:
  using PlainVisitor = std::function<void(const PlainObstacle&, std::string_view semantic)>;
  void visit_plain(const Run& run, const PlainVisitor& visit) const;

  PlainObstacles plain_;
  std::vector<Obstacle> others_;
  std::vector<Run> runs_;
};

}  // namespace mapwright::converter
