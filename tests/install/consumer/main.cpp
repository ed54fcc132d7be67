// Reads a map, measures a range in it and draws it: one call into each kind of library.
#include <iostream>
#include <vector>

#include "converter/exporters/picture.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/text/reader.hpp"
#include "navcore/rays/culled_ray_caster.hpp"

namespace {

const char* const kMap =
    "border;\n0;10;\n10;0;\n#\n"
    "obstacle;\n1;1;4;column;\n#\n"
    "4;4;\n6;4;\n2;1;;\n#\n6;4;\n6;6;\n2;1;;\n#\n6;6;\n4;6;\n2;1;;\n#\n4;6;\n4;4;\n2;1;;\n#\n";

}  // namespace

int main() {
  const auto document = mapwright::read_map(kMap);
  const auto& map = document.map;
  const auto ring = mapwright::chain_points(map.obstacles.at(0));
  const mapwright::navcore::LaserModel laser{1, 180.0, 15.0, 0.5};
  std::vector<double> range_m(1);
  mapwright::navcore::CulledRayCaster(map).cast({1.0, 5.0, {}}, laser, range_m);
  const auto picture =
      mapwright::converter::draw_picture(map, {}, {}, mapwright::converter::PictureFormat::kSvg);
  std::cout << "findings " << document.findings.size() << ", area "
            << mapwright::signed_area_m2(ring) << ", range " << range_m[0] << ", picture "
            << (picture ? "drawn" : picture.error().message) << '\n';
}
