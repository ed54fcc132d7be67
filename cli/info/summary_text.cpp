#include <array>
#include <iomanip>
#include <sstream>

#include "cli/info/summary_output.hpp"
#include "cli/support/findings_text.hpp"

namespace mapwright::cli {
namespace {

constexpr std::array<std::string_view, kShapeTypes> kShapeNames{
    "closed polygon", "opened polygon", "closed curve", "opened curve", "stairs", "ramp"};

std::ostream& line(std::ostream& out, std::string_view what) {
  return out << "  " << std::left << std::setw(18) << what;
}

// Up to `decimals` decimals, none that say nothing.
std::string decimal(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  std::string digits = text.str();
  if (digits.find('.') == digits.npos) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

// "1 segment", "2 segments".
std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string metres(double value) {
  return decimal(value, 3);
}

std::string spread_text(const Spread& spread) {
  return metres(spread.min) + " to " + metres(spread.max) + ", median " + metres(spread.median) +
         ", mean " + metres(spread.mean) + ", 95 % within " + metres(spread.p95);
}

void write_counts(std::ostream& out, const MapSummary& summary) {
  line(out, "obstacles") << summary.obstacles << " with " << counted(summary.segments, "segment")
                         << ", " << metres(summary.length_m) << " m in all\n";
  for (std::size_t i = 0; i < kShapeNames.size(); ++i) {
    const auto& count = summary.by_shape_type[i];
    if (count.obstacles == 0) continue;
    line(out, "") << "ST " << i + 1 << ' ' << kShapeNames[i] << ": " << count.obstacles << " with "
                  << counted(count.segments, "segment") << '\n';
  }
  line(out, "in/out") << counted(summary.indoor, "segment") << " indoor, " << summary.outdoor
                      << " outdoor\n";
}

void write_extents(std::ostream& out, const MapSummary& summary) {
  const Border& border = summary.border;
  line(out, "border") << '(' << metres(border.left) << ", " << metres(border.top) << ") to ("
                      << metres(border.right) << ", " << metres(border.bottom) << "), "
                      << metres(border.right - border.left) << " m x "
                      << metres(border.top - border.bottom)
                      << " m = " << decimal(border.area_m2(), 1) << " m2\n";
  const Box& box = summary.extent;
  if (box.is_empty()) return;
  line(out, "extent") << "x " << metres(box.min_x) << " to " << metres(box.max_x) << ", y "
                      << metres(box.min_y) << " to " << metres(box.max_y) << '\n';
}

void write_compactness(std::ostream& out, const MapSummary& summary) {
  line(out, "size") << summary.bytes << " bytes";
  if (const auto per_m2 = summary.bytes_per_m2()) {
    out << ", " << decimal(*per_m2, 3) << " bytes/m2 (" << decimal(8.0 * *per_m2, 2)
        << " bits/m2); the report's map has " << decimal(kReportBytesPerM2, 1) << " bytes/m2";
  }
  out << '\n';
}

void write_circles(std::ostream& out, const MapSummary& summary) {
  if (!summary.largest_circle) return;
  const auto& [id, circle] = *summary.largest_circle;
  line(out, "bounding circles") << "radius " << spread_text(summary.circle_radii_m) << " m\n";
  line(out, "") << "largest: obstacle " << id << " around (" << metres(circle.center.x) << ", "
                << metres(circle.center.y) << ")\n";
}

void write_georeference(std::ostream& out, const std::optional<Georeference>& georeference) {
  if (!georeference) {
    line(out, "georeference") << "none: plain local metres\n";
    return;
  }
  const auto& g = *georeference;
  line(out, "georeference") << "origin " << decimal(g.origin_latitude_deg, 9) << ", "
                            << decimal(g.origin_longitude_deg, 9) << " (WGS 84), height "
                            << metres(g.origin_height_m) << " m, +y points to "
                            << decimal(g.heading_deg, 6) << " deg from north, "
                            << to_string(g.projection) << '\n';
  for (const auto& source : g.sources) {
    line(out, "") << "from " << source.path;
    if (!source.layer.empty()) out << ", layer " << source.layer;
    out << (source.crs.empty() ? "" : ", " + source.crs) << '\n';
  }
}

}  // namespace

void write_summary_text(std::ostream& out, std::string_view path, const MapSummary& summary,
                        const std::optional<Georeference>& georeference) {
  out << display_path(path) << '\n';
  write_counts(out, summary);
  write_extents(out, summary);
  write_compactness(out, summary);
  if (summary.segments > 0) {
    line(out, "heights") << spread_text(summary.heights_m) << " m; "
                         << counted(summary.zero_heights, "segment") << " of height 0\n";
  }
  write_circles(out, summary);
  line(out, "semantics") << counted(summary.distinct_semantics, "different string") << '\n';
  write_georeference(out, georeference);
  line(out, "findings") << counted(summary.findings[2], "error") << ", "
                        << counted(summary.findings[1], "warning") << " in the text\n";
}

}  // namespace mapwright::cli
