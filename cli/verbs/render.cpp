#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "cli/plan/places.hpp"
#include "cli/render/drawers.hpp"
#include "cli/render/overlays.hpp"
#include "cli/support/arguments.hpp"
#include "cli/support/common_options.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/laser_options.hpp"
#include "cli/support/map_files.hpp"
#include "cli/verb.hpp"
#include "converter/exporters/picture.hpp"
#include "mapcore/geometry/bounding_circle.hpp"
#include "mapcore/georeference.hpp"
#include "navcore/free_space.hpp"
#include "navcore/rays/culled_ray_caster.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;
using converter::Colour;
using converter::PictureLabels;

constexpr std::string_view kDescription =
    R"(Draws a map as SVG, PNG, PDF or WebP, by the extension of the file named with -o. Obstacles are
coloured by kind; short strokes show the free side of walls; numbers are heights in metres.

Answers of other verbs (written with --format json) are drawn over the map: scans, localization
with its particles, planned paths with their search trees, findings of validate and check.

Examples:
  mapwright render campus.txt -o campus.png
  mapwright render campus.txt -o corner.svg --bbox 40,38,95,65 --labels names
  mapwright render campus.txt -o scan.png --scan 62,38,90
  mapwright plan campus.txt --start 5,5 --goal 80,60 --format json --with-tree > plan.json
  mapwright render campus.txt -o plan.png --overlay plan.json
  mapwright localize campus.txt --pose 40,30,90 --with-particles --format json > loc.json
  mapwright render campus.txt -o loc.png --overlay loc.json --iteration all
  mapwright render campus.txt -o loc.webp --overlay loc.json --iteration all --frame-time 0.2
)";

PictureLabels parse_labels(const std::string& text) {
  if (text == "none") return PictureLabels::kNone;
  if (text == "heights") return PictureLabels::kHeights;
  if (text == "ids") return PictureLabels::kIds;
  if (text == "names") return PictureLabels::kNames;
  fail_usage("--labels: '" + text + "' is none of heights, ids, names, none");
}

Box parse_window(const std::string& text) {
  const auto n = parse_numbers("bbox", text, 4, 4);
  const Box window{n[0], n[1], n[2], n[3]};
  if (!(window.width() > 0.0 && window.height() > 0.0)) {
    fail_usage("--bbox: x1 must be less than x2 and y1 less than y2, got '" + text + "'");
  }
  return window;
}

// "all", or a number from 1.
std::optional<std::size_t> parse_iteration(const std::string& text) {
  if (text == "all") return std::nullopt;
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size() || number < 1) {
    fail_usage("--iteration: '" + text + "' is neither a number from 1 nor 'all'");
  }
  return number;
}

int frame_ms(const std::string& seconds) {
  const double ms = std::round(1e3 * parse_number("frame-time", seconds));
  if (ms >= 1.0 && ms <= 60000.0) return static_cast<int>(ms);
  fail_usage("--frame-time: must be from 0.001 to 60 seconds");
}

// out.png → out-07.png
std::string frame_path(const std::string& path, std::size_t number, std::size_t count) {
  const std::filesystem::path file(path);
  std::string digits = std::to_string(number);
  const std::size_t width = std::max<std::size_t>(2, std::to_string(count).size());
  digits.insert(0, width - std::min(width, digits.size()), '0');
  const std::string name = file.stem().string() + "-" + digits + file.extension().string();
  return (file.parent_path() / name).string();
}

void add_circles(const Map& map, converter::Overlay& overlay) {
  const converter::Stroke stroke{Colour::from_hex(0x7A3E9D, 0.8), 0.6, {2.5, 1.5}};
  for (const auto& obstacle : map.obstacles) {
    const Circle circle = min_bounding_circle(obstacle);
    if (circle.radius_m < 0.0) continue;
    overlay.items.emplace_back(converter::OverlayCircle{circle.center, circle.radius_m, stroke});
  }
  add_legend(overlay, converter::OverlayCircle{{}, 1.0, stroke}, "bounding circle");
}

void add_synthetic_scan(const Map& map, const Pose& pose, const navcore::LaserModel& laser,
                        converter::Overlay& overlay) {
  const navcore::FreeSpace space(map);
  const auto reason = why_not_standing(map, space, pose.position(), 0.0, "--scan");
  if (reason) fail_usage(*reason);
  std::vector<double> angles_deg(laser.rays);
  for (std::size_t i = 0; i < laser.rays; ++i) angles_deg[i] = ray_angle_deg(laser, i);
  std::vector<double> ranges_m(laser.rays);
  navcore::CulledRayCaster(map).cast(pose, laser, ranges_m);
  add_scan(overlay, pose, angles_deg, ranges_m, laser.max_range_m);
  add_robot(overlay, pose, 3.5, kRobotColour, "robot");
}

// Direction of true north in the map, where a sidecar tells.
std::optional<double> north_of(const std::string& map_path) {
  if (map_path == "-") return std::nullopt;
  const std::string path = sidecar_path(map_path);
  if (!std::filesystem::exists(path)) return std::nullopt;
  auto georeference = parse_georeference(read_file(path));
  if (!georeference) {
    throw Error(ExitStatus::kInput, path + ": " + georeference.error().message);
  }
  return 90.0 + georeference->heading_deg;
}

class Render : public Verb {
 public:
  std::string_view synopsis() const override { return "MAP -o PICTURE [OPTIONS]"; }
  std::string_view description() const override { return kDescription; }

  void declare(po::options_description& options,
               po::positional_options_description& positionals) override {
    declare_map_argument(options, positionals, map_path_);
    auto add = options.add_options();
    add("output,o", po::value(&output_)->required(), "the picture: .svg, .png, .pdf or .webp");
    add("overlay", po::value(&overlay_paths_)->composing(),
        "JSON answer of scan, localize, plan, validate or check to draw over the map; may be given "
        "several times");
    add("iteration", po::value<std::string>(),
        "which iteration of a localization to draw, from 1 (default: the last); 'all' draws each "
        "into a file of its own: X.png becomes X-01.png, X-02.png ...; X.webp is one picture that "
        "moves");
    add("frame-time", po::value<std::string>(),
        "seconds that each frame of a picture that moves is shown [0.2]");
    add("scan", po::value<std::string>(),
        "draw a synthetic scan from pose x,y,deg (metres, degrees counter-clockwise from +x), by "
        "the laser of the last options below");
    add("circles", "draw each obstacle's minimum bounding circle");
    add("bbox", po::value<std::string>(),
        "part to draw: x1,y1,x2,y2 in metres (default: border and all obstacles)");
    add("width", po::value(&options_.width_px)->default_value(options_.width_px),
        "width of a PNG or WebP in pixels, 200 to 20000; SVG and PDF are width/2 points wide");
    add("labels", text_value("heights"),
        "what to write beside obstacles where there is room: heights, ids, names or none");
    add("ticks", "draw orientation strokes on the free side of segments (the default)");
    add("no-ticks", "draw none");
    add("title", po::value(&options_.title), "a title above the map");
    declare_laser_options(options);
  }

  void configure(const po::variables_map& values) override {
    const auto format = converter::picture_format(output_);
    if (!format) fail_usage("-o: '" + output_ + "' ends in none of .svg, .png, .pdf, .webp");
    format_ = *format;
    if (options_.width_px < 200 || options_.width_px > 20000) {
      fail_usage("--width: must be from 200 to 20000 pixels");
    }
    if (values.count("ticks") > 0 && values.count("no-ticks") > 0) {
      fail_usage("--ticks and --no-ticks exclude each other");
    }
    options_.orientation_ticks = values.count("no-ticks") == 0;
    options_.labels = parse_labels(values["labels"].as<std::string>());
    circles_ = values.count("circles") > 0;
    if (values.count("bbox") > 0) options_.window = parse_window(values["bbox"].as<std::string>());
    laser_ = laser_model(values);
    if (values.count("scan") > 0) scan_ = parse_pose("scan", values["scan"].as<std::string>());
    if (values.count("iteration") > 0) {
      iteration_ = parse_iteration(values["iteration"].as<std::string>());
      all_iterations_ = !iteration_;
    }
    const bool moves = all_iterations_ && format_ == converter::PictureFormat::kWebp;
    if (values.count("frame-time") == 0) return;
    if (!moves) fail_usage("--frame-time needs --iteration all and a .webp");
    frame_ms_ = frame_ms(values["frame-time"].as<std::string>());
  }

  ExitStatus run(Console& console) override {
    const MapDocument document = read_map_file(map_path_);
    if (document.map.obstacles.empty() && has_errors(document.findings)) {
      throw Error(ExitStatus::kInput, map_path_ + ": " + document.findings.front().message);
    }
    if (has_errors(document.findings)) {
      console.warning(map_path_ +
                      ": has defects; what could be read of it is drawn; 'mapwright "
                      "validate' names them");
    }
    for (const auto& path : overlay_paths_) answers_.emplace_back(path);
    options_.north_deg = north_of(map_path_);
    if (all_iterations_ && format_ == converter::PictureFormat::kWebp) {
      draw_moving(document.map, console);
    } else if (all_iterations_) {
      draw_frames(document.map, console);
    } else {
      draw(document.map, iteration_, output_, console);
    }
    return ExitStatus::kSuccess;
  }

 private:
  void draw(const Map& map, std::optional<std::size_t> iteration, const std::string& path,
            Console& console) const {
    write(value_or_throw(draw_picture(map, overlay(map, iteration), options_, format_)), path,
          console);
  }

  converter::Overlay overlay(const Map& map, std::optional<std::size_t> iteration) const {
    converter::Overlay overlay;
    if (circles_) add_circles(map, overlay);
    for (const auto& answer : answers_) answer.draw(overlay, iteration);
    if (scan_) add_synthetic_scan(map, *scan_, laser_, overlay);
    return overlay;
  }

  static void write(const std::string& picture, const std::string& path, Console& console) {
    write_file(path, [&](std::ostream& out) { out << picture; });
    console.note("wrote " + path);
  }

  std::size_t iterations() const {
    std::size_t count = 0;
    for (const auto& answer : answers_) count = std::max(count, answer.iterations());
    if (count == 0) fail_usage("--iteration all: no overlay holds a localization");
    return count;
  }

  void draw_moving(const Map& map, Console& console) const {
    std::vector<converter::Overlay> overlays;
    const std::size_t count = iterations();
    for (std::size_t i = 1; i <= count; ++i) overlays.push_back(overlay(map, i));
    write(value_or_throw(draw_animation(map, overlays, options_, frame_ms_)), output_, console);
  }

  void draw_frames(const Map& map, Console& console) const {
    const std::size_t count = iterations();
    for (std::size_t i = 1; i <= count; ++i) {
      draw(map, i, frame_path(output_, i, count), console);
    }
  }

  std::string map_path_;
  std::string output_;
  converter::PictureFormat format_ = converter::PictureFormat::kPng;
  std::vector<std::string> overlay_paths_;
  std::vector<Answer> answers_;
  converter::PictureOptions options_;
  std::optional<std::size_t> iteration_;
  bool all_iterations_ = false;
  int frame_ms_ = 200;
  std::optional<Pose> scan_;
  navcore::LaserModel laser_;
  bool circles_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_render() {
  return std::make_unique<Render>();
}

}  // namespace mapwright::cli
