#include "bench/embree_rays.hpp"

#include <embree3/rtcore.h>

#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>

namespace mapwright::bench {
namespace {

using navcore::LaserModel;

constexpr float kHalfHeight_m = 1.0F;

// The scene lies around the origin as far as it goes: single precision is all Embree has.
struct Corner {
  float x, y, z;
};

std::vector<Corner> corners(const Map& map, double laser_height_m) {
  std::vector<Corner> all;
  for (const Obstacle& obstacle : map.obstacles) {
    for (const Segment& s : obstacle.segments) {
      if (!(s.height_m > laser_height_m)) continue;
      const auto ax = static_cast<float>(s.a.x), ay = static_cast<float>(s.a.y);
      const auto bx = static_cast<float>(s.b.x), by = static_cast<float>(s.b.y);
      all.insert(all.end(), {{ax, ay, -kHalfHeight_m},
                             {bx, by, -kHalfHeight_m},
                             {bx, by, kHalfHeight_m},
                             {ax, ay, kHalfHeight_m}});
    }
  }
  return all;
}

/// Directions of a laser's rays, padded to 16.
struct Fan {
  explicit Fan(const LaserModel& laser) : x((laser.rays + 15) / 16 * 16), y(x.size()) {
    for (std::size_t i = 0; i < laser.rays; ++i) {
      const Point u = unit_vector_deg(navcore::ray_angle_deg(laser, i));
      x[i] = static_cast<float>(u.x);
      y[i] = static_cast<float>(u.y);
    }
  }
  std::vector<float> x, y;
};

struct Start {
  explicit Start(const Pose& pose)
      : x(static_cast<float>(pose.x)),
        y(static_cast<float>(pose.y)),
        c(static_cast<float>(std::cos(pose.theta.radians()))),
        s(static_cast<float>(std::sin(pose.theta.radians()))) {}
  float x, y, c, s;
};

template <class Packet, int N>
void set_up(Packet& packet, const Start& start, const Fan& fan, std::size_t first, float range) {
  for (int i = 0; i < N; ++i) {
    const std::size_t ray = first + static_cast<std::size_t>(i);
    packet.ray.org_x[i] = start.x;
    packet.ray.org_y[i] = start.y;
    packet.ray.org_z[i] = 0.0F;
    packet.ray.dir_x[i] = start.c * fan.x[ray] - start.s * fan.y[ray];
    packet.ray.dir_y[i] = start.s * fan.x[ray] + start.c * fan.y[ray];
    packet.ray.dir_z[i] = 0.0F;
    packet.ray.tnear[i] = 0.0F;
    packet.ray.tfar[i] = range;
    packet.ray.time[i] = 0.0F;
    packet.ray.mask[i] = ~0U;
    packet.ray.flags[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
}

void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit4* p) {
  rtcIntersect4(valid, scene, context, p);
}
void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* p) {
  rtcIntersect8(valid, scene, context, p);
}
void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* p) {
  rtcIntersect16(valid, scene, context, p);
}

template <class Packet, int N>
void cast_packets(RTCScene scene, RTCIntersectContext* context, const Start& start, const Fan& fan,
                  const LaserModel& laser, float* out) {
  alignas(64) Packet packet;
  alignas(64) std::array<int, N> valid;
  for (std::size_t first = 0; first < laser.rays; first += N) {
    for (std::size_t i = 0; i < N; ++i) valid[i] = first + i < laser.rays ? -1 : 0;
    set_up<Packet, N>(packet, start, fan, first, static_cast<float>(laser.max_range_m));
    intersect(valid.data(), scene, context, &packet);
    for (std::size_t i = 0; i < N && first + i < laser.rays; ++i) {
      out[first + i] = packet.ray.tfar[i];
    }
  }
}

void cast_single(RTCScene scene, RTCIntersectContext* context, const Start& start, const Fan& fan,
                 const LaserModel& laser, float* out) {
  for (std::size_t i = 0; i < laser.rays; ++i) {
    RTCRayHit hit{};
    hit.ray = {start.x,
               start.y,
               0.0F,
               0.0F,
               start.c * fan.x[i] - start.s * fan.y[i],
               start.s * fan.x[i] + start.c * fan.y[i],
               0.0F,
               0.0F,
               static_cast<float>(laser.max_range_m),
               ~0U,
               0,
               0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, context, &hit);
    out[i] = hit.ray.tfar;
  }
}

// All rays of a scan in one stream, component by component.
void cast_stream(RTCScene scene, RTCIntersectContext* context, const Start& start, const Fan& fan,
                 const LaserModel& laser, float* out) {
  const std::size_t n = fan.x.size();
  thread_local std::vector<float> f;
  thread_local std::vector<unsigned> u;
  f.assign(14 * n, 0.0F);
  u.assign(6 * n, ~0U);
  RTCRayHitNp p;
  p.ray = {&f[0],     &f[n],     &f[2 * n], &f[3 * n], &f[4 * n], &f[5 * n],
           &f[6 * n], &f[7 * n], &f[8 * n], &u[0],     &u[n],     &u[2 * n]};
  p.hit = {&f[9 * n],  &f[10 * n], &f[11 * n], &f[12 * n],
           &f[13 * n], &u[3 * n],  &u[4 * n],  {&u[5 * n]}};
  for (std::size_t i = 0; i < laser.rays; ++i) {
    p.ray.org_x[i] = start.x;
    p.ray.org_y[i] = start.y;
    p.ray.dir_x[i] = start.c * fan.x[i] - start.s * fan.y[i];
    p.ray.dir_y[i] = start.s * fan.x[i] + start.c * fan.y[i];
    p.ray.tfar[i] = static_cast<float>(laser.max_range_m);
    p.ray.flags[i] = 0;
  }
  rtcIntersectNp(scene, context, &p, static_cast<unsigned>(laser.rays));
  for (std::size_t i = 0; i < laser.rays; ++i) out[i] = p.ray.tfar[i];
}

}  // namespace

struct EmbreeRays::Impl {
  Impl(const Map& map, double laser_height_m) : device(rtcNewDevice("threads=1")) {
    rtcSetDeviceMemoryMonitorFunction(
        device,
        [](void* self, ssize_t more, bool) {
          static_cast<Impl*>(self)->bytes += more;
          return true;
        },
        this);
    scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    const std::vector<Corner> points = corners(map, laser_height_m);
    RTCGeometry quads = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    auto* const vertices = static_cast<Corner*>(rtcSetNewGeometryBuffer(
        quads, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Corner), points.size()));
    std::copy(points.begin(), points.end(), vertices);
    auto* const indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(quads, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                                4 * sizeof(unsigned), points.size() / 4));
    for (unsigned i = 0; i < points.size(); ++i) indices[i] = i;
    rtcCommitGeometry(quads);
    rtcAttachGeometry(scene, quads);
    rtcReleaseGeometry(quads);
    rtcCommitScene(scene);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  std::atomic<std::int64_t> bytes{0};
  RTCDevice device;
  RTCScene scene = nullptr;
};

bool EmbreeRays::is_available() {
  return true;
}

std::string EmbreeRays::name(Mode mode) {
  switch (mode) {
    case Mode::kSingle:
      return "rtcIntersect1";
    case Mode::kPacket4:
      return "rtcIntersect4";
    case Mode::kPacket8:
      return "rtcIntersect8";
    case Mode::kPacket16:
      return "rtcIntersect16";
    case Mode::kStream:
      break;
  }
  return "rtcIntersectNp";
}

EmbreeRays::EmbreeRays(const Map& map, double laser_height_m)
    : impl_(std::make_unique<Impl>(map, laser_height_m)) {}
EmbreeRays::~EmbreeRays() = default;

std::size_t EmbreeRays::memory_bytes() const {
  return static_cast<std::size_t>(impl_->bytes.load());
}

void EmbreeRays::cast(Mode mode, std::span<const Pose> poses, const LaserModel& laser,
                      std::span<float> ranges) const {
  assert(ranges.size() == poses.size() * laser.rays);
  const Fan fan(laser);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Start start(poses[i]);
    float* const out = ranges.data() + i * laser.rays;
    switch (mode) {
      case Mode::kSingle:
        cast_single(impl_->scene, &context, start, fan, laser, out);
        break;
      case Mode::kPacket4:
        cast_packets<RTCRayHit4, 4>(impl_->scene, &context, start, fan, laser, out);
        break;
      case Mode::kPacket8:
        cast_packets<RTCRayHit8, 8>(impl_->scene, &context, start, fan, laser, out);
        break;
      case Mode::kPacket16:
        cast_packets<RTCRayHit16, 16>(impl_->scene, &context, start, fan, laser, out);
        break;
      case Mode::kStream:
        cast_stream(impl_->scene, &context, start, fan, laser, out);
        break;
    }
  }
}

}  // namespace mapwright::bench
