#include "cli/support/frame_options.hpp"

#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"

namespace mapwright::cli {

namespace po = boost::program_options;

void FrameArguments::declare(po::options_description& options, const std::string& without) {
  const std::string origin =
      "LAT,LON[,HEIGHT] in degrees (WGS 84) and metres, or X,Y[,HEIGHT] of --origin-crs (" +
      without + ")";
  auto add = options.add_options();
  add("origin", po::value(&origin_), origin.c_str());
  add("origin-crs", po::value(&origin_crs_), "CRS of --origin, such as EPSG:25831");
  add("heading", po::value(&heading_)->default_value("0"),
      "degrees clockwise from north to the map's +y axis; true north, or the grid's north where "
      "--origin-crs is projected");
  add("frame", po::value(&frame_)->default_value("tmerc"),
      "tmerc: transverse Mercator with scale 1 at the origin; enu: local tangent plane");
}

converter::FrameOptions FrameArguments::parse() const {
  converter::FrameOptions frame;
  frame.origin_crs = origin_crs_;
  if (!origin_.empty()) frame.origin = parse_numbers("origin", origin_, 2, 3);
  if (frame.origin.empty() && !frame.origin_crs.empty()) {
    fail_usage("--origin-crs says in which CRS --origin is given: give --origin too");
  }
  frame.heading_deg = parse_number("heading", heading_);
  const auto projection = frame_projection(frame_);
  if (!projection) fail_usage("--frame: '" + frame_ + "' is neither tmerc nor enu");
  frame.projection = *projection;
  return frame;
}

}  // namespace mapwright::cli
