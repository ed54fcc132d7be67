// Private to this folder: places where the robot can stand in both of two maps.
#pragma once

#include <optional>

#include "mapcore/random.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

class CommonPlaces {
 public:
  CommonPlaces(const Map& before, const Map& after, RampPolicy ramps, double radius_m);

  /// Uniform over the ground that both leave free; nothing where none was found.
  std::optional<Point> sample(Random& random) const;

  /// The same within a box.
  std::optional<Point> sample_in(const Box& box, Random& random) const;

 private:
  bool is_free(Point p) const;

  FreeSpace before_, after_;
  double radius_m_;
};

}  // namespace mapwright::navcore
