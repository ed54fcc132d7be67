// A map as the page's script draws it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// Obstacles or marks that are shown and hidden together.
struct SceneLayer {
  std::string name;
  std::string style;  ///< of the style sheet's colours --kind-STYLE-fill and -line
};

/// A line more in what the page tells of an obstacle.
using SceneFacts = std::vector<std::pair<std::string, std::string>>;

/// Collects what one picture shows and writes it as JSON:
///
///     {"border": [mx1, my1, mx4, my4], "layers": [{"name", "style"}], "texts": ["…"],
///      "obstacles": [[layer, id, shape type, semantic, paths, area, heights, in/out, semantics of
///                     the segments, facts]],
///      "holes": [[inner, outer]], "marks": [{"layer", "line" | "box" | "dot", "arrow"}]}
///
/// Paths are runs of segments that join, as [x, y, x, y, …]; semantics are numbers in "texts"; what
/// all segments share is one value, else an array. The area to fill is 0 (none), 1 (the first path)
/// or a ring. Numbers keep every digit. Later layers are drawn over earlier ones.
class SceneWriter {
 public:
  SceneWriter(const Border& border, std::vector<SceneLayer> layers);

  /// Returns the number of the obstacle in the scene.
  std::size_t obstacle(const Obstacle& obstacle, std::size_t layer, const SceneFacts& facts = {});

  /// The ring `inner` is cut out of the area of `outer`.
  void hole(std::size_t inner, std::size_t outer);

  void line(std::size_t layer, std::span<const Point> points, bool arrow = false);
  void box(std::size_t layer, const Box& box);
  void dot(std::size_t layer, Point at);

  std::string json() const;

 private:
  std::size_t text_number(const Semantic& semantic);

  Border border_;
  std::vector<SceneLayer> layers_;
  std::vector<std::string> texts_;
  std::unordered_map<std::string, std::size_t> text_numbers_;
  std::size_t obstacles_ = 0;
  std::string rows_, holes_, marks_;
};

/// The obstacles of a map, a layer a kind, in the order in which they are drawn; inner rings are
/// cut out. The layers are `kind_layers()`, first of the writer's.
void add_map(SceneWriter& scene, const Map& map);
std::vector<SceneLayer> kind_layers();

}  // namespace mapwright::validators
