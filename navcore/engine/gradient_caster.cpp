#include "navcore/engine/gradient_caster.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include "navcore/engine/iso_line.hpp"
#include "navcore/engine/line_buffer.hpp"
#include "navcore/engine/scene.hpp"

namespace mapwright::navcore {
namespace {

using engine::BearingFan;
using engine::LineBuffer;
using engine::Scene;
using engine::SceneSegment;

// Poses that look for their walls together: so many at most, and no further apart.
constexpr std::size_t kMostTogether = 256;
constexpr double kTogether_m = 4.0;

struct Wall {
  Point a, b;
  bool one_sided = false;
};

/// What rays from some poses may meet at one height.
struct Nearby {
  std::vector<Wall> walls;
  std::vector<std::span<const SceneSegment>> stairs;
};

Nearby gather(const Scene& scene, const Box& box, double height_m) {
  std::vector<std::uint32_t> items;
  scene.bins().visit(box, [&](std::uint32_t item) { items.push_back(item); });
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  Nearby nearby;
  std::vector<std::uint32_t> stairs;
  for (const std::uint32_t item : items) {
    if (scene.is_ramp(item)) {
      for (const auto& line : engine::iso_lines(scene.ramp(item), height_m)) {
        nearby.walls.push_back({line.a, line.b, true});
      }
    } else if (scene.obstacles()[scene.obstacle_of(item)].stairs) {
      stairs.push_back(scene.obstacle_of(item));
    } else if (scene.segments()[item].height_m > height_m) {
      nearby.walls.push_back({scene.segments()[item].a, scene.segments()[item].b, false});
    }
  }
  stairs.erase(std::unique(stairs.begin(), stairs.end()), stairs.end());
  for (const std::uint32_t i : stairs) {
    nearby.stairs.push_back(scene.segments_of(scene.obstacles()[i]));
  }
  return nearby;
}

/// The scan of one pose after the other. Memory of one thread.
class Tracer {
 public:
  Tracer(const Nearby& nearby, const LaserModel& laser, const BearingFan& fan)
      : nearby_(nearby),
        laser_(laser),
        fan_(fan),
        nearest_(laser.rays),
        steps_(laser.rays),
        stops_(laser.rays),
        tops_(laser.rays) {}

  void trace(const Pose& pose, std::span<RangeGradient> gradients) {
    origin_ = pose.position();
    ahead_ = unit_vector_deg(pose.theta.degrees());
    nearest_.clear();
    const double reach = laser_.max_range_m * laser_.max_range_m;
    for (const Wall& wall : nearby_.walls) {
      const Point a = wall.a - origin_, b = wall.b - origin_;
      if (squared_length(closest_point_on_segment({}, a, b)) > reach) continue;
      nearest_.draw(fan_, in_sensor_frame(a), in_sensor_frame(b), wall.one_sided);
    }
    for (const auto& stairs : nearby_.stairs) draw_stairs(stairs);
    for (std::size_t i = 0; i < gradients.size(); ++i) gradients[i] = gradient(i);
  }

 private:
  Point in_sensor_frame(Point p) const { return {dot(ahead_, p), cross(ahead_, p)}; }

  // Report, figure 6: where the first segment met is the top, the staircase is crossed. Of a step
  // and the top met at the same place the step counts.
  void draw_stairs(std::span<const SceneSegment> stairs) {
    for (LineBuffer* buffer : {&steps_, &stops_, &tops_}) buffer->clear();
    for (const SceneSegment& s : stairs) {
      const Point a = in_sensor_frame(s.a - origin_), b = in_sensor_frame(s.b - origin_);
      (s.height_m > 0.0 ? steps_ : tops_).draw(fan_, a, b, false);
      if (s.height_m > laser_.height_m) stops_.draw(fan_, a, b, false);
    }
    for (std::size_t i = 0; i < laser_.rays; ++i) {
      if (tops_.inverse[i] <= steps_.inverse[i]) nearest_.take(i, stops_);
    }
  }

  RangeGradient gradient(std::size_t i) const {
    const double range_m = 1.0 / nearest_.inverse[i];
    if (!(range_m < laser_.max_range_m)) return {laser_.max_range_m, 0.0, 0.0, 0.0, false};
    const Point n{nearest_.normal_x[i], nearest_.normal_y[i]};
    const Point u = fan_.rays()[i];
    const Point by = -range_m * n;
    return {range_m, ahead_.x * by.x - ahead_.y * by.y, ahead_.y * by.x + ahead_.x * by.y,
            -range_m * range_m * cross(u, n), true};
  }

  const Nearby& nearby_;
  const LaserModel& laser_;
  const BearingFan& fan_;
  LineBuffer nearest_, steps_, stops_, tops_;
  Point origin_, ahead_;
};

// The first of the poses that belong together.
std::size_t together(std::span<const Pose> poses, Box& box) {
  std::size_t count = 0;
  for (const Pose& pose : poses.first(std::min(poses.size(), kMostTogether))) {
    Box grown = box;
    grown.add(pose.position());
    if (count > 0 && (grown.width() > kTogether_m || grown.height() > kTogether_m)) break;
    box = grown;
    ++count;
  }
  return count;
}

}  // namespace

struct GradientCaster::Impl {
  explicit Impl(const Map& map) : scene(map) {}
  Scene scene;
};

GradientCaster::GradientCaster(const Map& map) : impl_(std::make_unique<const Impl>(map)) {}
GradientCaster::GradientCaster(GradientCaster&&) noexcept = default;
GradientCaster& GradientCaster::operator=(GradientCaster&&) noexcept = default;
GradientCaster::~GradientCaster() = default;

void GradientCaster::cast(const Pose& pose, const LaserModel& laser,
                          std::span<RangeGradient> gradients) const {
  cast_all({&pose, 1}, laser, gradients);
}

void GradientCaster::cast_all(std::span<const Pose> poses, const LaserModel& laser,
                              std::span<RangeGradient> gradients) const {
  assert(gradients.size() == poses.size() * laser.rays);
  const BearingFan fan(laser);
  for (std::size_t first = 0; first < poses.size();) {
    Box box = kEmptyBox;
    const std::size_t count = together(poses.subspan(first), box);
    const Nearby nearby = gather(impl_->scene, box.inflated(laser.max_range_m), laser.height_m);
    Tracer tracer(nearby, laser, fan);
    for (std::size_t i = first; i < first + count; ++i) {
      tracer.trace(poses[i], gradients.subspan(i * laser.rays, laser.rays));
    }
    first += count;
  }
}

}  // namespace mapwright::navcore
