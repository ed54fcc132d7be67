// Obstacles that `export` wrote: they come back as what they were, with what was edited.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "converter/exchange/exchange_fields.hpp"
#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Features of kind obstacle. Geometry is taken as it is drawn, rounded to the map's resolution;
/// ids, order, heights and semantics come from the fields (docs/round-trip.md). A feature of which
/// another has the same position already (a copy) is a new obstacle.
class ExportedObstacles {
 public:
  explicit ExportedObstacles(Workspace& workspace) : workspace_(workspace) {}

  /// `place` names the file or folder: positions are unique only within one.
  void add(const FeatureTask& task, const ExchangeFields& fields, const std::string& place);

  /// Makes the obstacles.
  void finish();

 private:
  struct Piece {
    std::int64_t part = 0;
    std::vector<Segment> segments;
    std::size_t account = 0;
  };
  struct Hole {
    Draft draft;
    bool is_tied = true;  // by inner_of
  };
  struct Obstacle {
    Draft draft;
    std::vector<Piece> pieces;
    std::vector<Hole> holes;
    bool is_polygon = false;
  };
  using Key = std::pair<std::size_t, std::int64_t>;  // place, position

  void add_border(const FeatureTask& task);
  void add_polygons(const FeatureTask& task, const ExchangeFields& fields, Draft draft,
                    const Key& key);
  void add_holes(const FeatureTask& task, const ExchangeFields& fields, Obstacle& outline,
                 std::size_t first, const Key& key);
  void add_lines(const FeatureTask& task, const ExchangeFields& fields, Draft draft,
                 const Key& key);
  void add_piece(Draft draft, Piece piece, const Key& key);
  static void take_identity(const nlohmann::ordered_json& record, std::size_t place,
                            const Draft& outline, Hole& hole);
  void say(const FeatureTask& task, bool height_is_missing, bool altered);
  void write(Obstacle& obstacle);

  std::size_t place_number(const std::string& place);

  Workspace& workspace_;
  std::map<std::string, std::size_t> places_;
  std::map<Key, Obstacle> known_;
  std::vector<Obstacle> fresh_;
};

}  // namespace mapwright::converter
