#include "navcore/rays/ray_fan.hpp"

namespace mapwright::navcore {

RayFan::RayFan(const LaserModel& laser) : x_(laser.rays), y_(laser.rays) {
  for (std::size_t i = 0; i < laser.rays; ++i) {
    const Point direction = unit_vector_deg(ray_angle_deg(laser, i));
    x_[i] = direction.x;
    y_[i] = direction.y;
  }
}

void RayFan::turn(const RayFan& relative, Angle heading) {
  const Point ahead = unit_vector_deg(heading.degrees());
  x_.resize(relative.size());
  y_.resize(relative.size());
  for (std::size_t i = 0; i < relative.size(); ++i) {
    x_[i] = ahead.x * relative.x_[i] - ahead.y * relative.y_[i];
    y_[i] = ahead.y * relative.x_[i] + ahead.x * relative.y_[i];
  }
}

}  // namespace mapwright::navcore
