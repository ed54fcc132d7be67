#include <cmath>

#include "cli/diff/diff_answer.hpp"
#include "cli/diff/diff_wording.hpp"
#include "cli/render/drawers.hpp"
#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

using converter::Colour;
using converter::Overlay;
using converter::OverlayDots;
using converter::OverlayPath;
using converter::OverlaySegments;
using converter::Stroke;

const Colour kGreen = Colour::from_hex(0x1A7F37);
const Colour kRed = Colour::from_hex(0xC62828);
const Colour kAmber = Colour::from_hex(0x9A6700);
const Colour kBlue = Colour::from_hex(0x0B62C4);
const Colour kViolet = Colour::from_hex(0x8250DF);
const Colour kPink = Colour::from_hex(0xBF3989);

constexpr std::size_t kMostMarkers = 25;  // more words than that hide the map

struct Look {
  Colour colour;
  std::vector<double> dash_pt;
  double opacity;
  const char* meaning;
};

const Look kAddedLook{kGreen, {}, 0.35, "added"};
const Look kRemovedLook{kRed, {}, 0.3, "removed"};
const Look kOldLook{kAmber, {4.0, 2.0}, 0.0, "before it moved or was reshaped"};
const Look kNewLook{kBlue, {}, 0.25, "after"};
const Look kChangedLook{kViolet, {}, 0.3, "other attributes"};

void add_obstacle(const Obstacle& obstacle, const Look& look, Overlay& overlay) {
  const Stroke stroke{look.colour, 1.6, look.dash_pt};
  OverlayPath sample{{{0.0, 0.0}, {1.0, 0.0}}, stroke, false, {}};
  add_legend(overlay, sample, look.meaning);
  if (is_closed(obstacle.shape_type)) {
    const Colour fill{look.colour.red, look.colour.green, look.colour.blue, look.opacity};
    overlay.items.emplace_back(OverlayPath{chain_points(obstacle), stroke, true, fill});
    return;
  }
  OverlaySegments lines{{}, stroke};
  for (const auto& segment : obstacle.segments) lines.segments.emplace_back(segment.a, segment.b);
  overlay.items.emplace_back(std::move(lines));
}

// A line with a head that takes a quarter of it.
void add_arrow(Point from, Point to, Overlay& overlay) {
  const Stroke stroke{kBlue, 1.2, {}};
  const Point back = 0.25 * (from - to);
  const Point side{-0.4 * back.y, 0.4 * back.x};
  overlay.items.emplace_back(OverlayPath{{from, to}, stroke, false, {}});
  overlay.items.emplace_back(
      OverlayPath{{to, to + back + side, to + back - side}, stroke, true, kBlue});
}

const Look& look_of(const ObstacleChange& change) {
  if (change.added()) return kAddedLook;
  if (change.moved || change.reshaped) return kNewLook;
  return kChangedLook;
}

void add_change(const DiffAnswer& answer, const ObstacleChange& change, Overlay& overlay) {
  if (!change.is_difference()) return;
  if (change.removed()) {
    add_obstacle(answer.before.obstacles[*change.before], kRemovedLook, overlay);
    return;
  }
  const Obstacle& now = answer.after.obstacles[*change.after];
  if (change.moved || change.reshaped) {
    add_obstacle(answer.before.obstacles[*change.before], kOldLook, overlay);
  }
  add_obstacle(now, look_of(change), overlay);
  const auto at = place_of(now);
  if (change.moved && at) add_arrow(*at - change.offset, *at, overlay);
}

void add_markers(const DiffAnswer& answer, Overlay& overlay) {
  std::size_t count = 0;
  for (const auto& change : answer.obstacles.changes) count += change.is_difference() ? 1 : 0;
  if (count > kMostMarkers) return;
  for (const auto& change : answer.obstacles.changes) {
    const auto at = place_of(obstacle_of(answer, change));
    if (!change.is_difference() || !at) continue;
    const Colour colour = change.removed() ? kRed : look_of(change).colour;
    overlay.items.emplace_back(
        converter::OverlayMarker{*at, std::string(change_kinds(change).front()), colour});
  }
}

void add_navigation(const navcore::NavigationDiff& navigation, Overlay& overlay) {
  const auto add_route = [&](const std::vector<Point>& path, const Stroke& stroke,
                             const char* meaning) {
    if (path.empty()) return;
    const OverlayPath route{path, stroke, false, {}};
    overlay.items.emplace_back(route);
    add_legend(overlay, route, meaning);
  };
  for (const auto& route : navigation.routes.changed) {
    add_route(route.before, {kAmber, 1.0, {3.0, 2.0}}, "route before");
    add_route(route.after, {kBlue, 1.0, {}}, "route after");
  }
  OverlayDots dots{{}, 1.8, kPink};
  for (const auto& scan : navigation.scans.changed) dots.centres.push_back(scan.pose.position());
  if (dots.centres.empty()) return;
  overlay.items.emplace_back(dots);
  add_legend(overlay, dots, "scan differs");
}

}  // namespace

std::string draw_diff(const DiffAnswer& answer, converter::PictureFormat format) {
  Overlay overlay;
  for (const auto& change : answer.obstacles.changes) add_change(answer, change, overlay);
  if (answer.navigation) add_navigation(*answer.navigation, overlay);
  add_markers(answer, overlay);
  converter::PictureOptions options;
  options.labels = converter::PictureLabels::kNone;
  options.orientation_ticks = false;
  options.title = answer.path_before + " → " + answer.path_after;
  return value_or_throw(draw_picture(answer.after, overlay, options, format));
}

}  // namespace mapwright::cli
