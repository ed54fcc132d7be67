#include "cli/render/drawers.hpp"

namespace mapwright::cli {
namespace {

using converter::Colour;

struct SeverityStyle {
  std::string_view severity;
  Colour colour;
};

constexpr SeverityStyle kStyles[] = {{"note", Colour::from_hex(0x0072B2)},
                                     {"warning", Colour::from_hex(0xC77700)},
                                     {"error", Colour::from_hex(0xC00020)}};

bool has_place(const Json& finding) {
  return finding.contains("x") && finding.contains("y") && finding.at("x").is_number() &&
         finding.at("y").is_number();
}

void add_marker(const Json& finding, const SeverityStyle& style, converter::Overlay& overlay) {
  const converter::OverlayMarker marker{
      {finding.at("x").get<double>(), finding.at("y").get<double>()},
      finding.at("code").get<std::string>(),
      style.colour};
  add_legend(overlay, marker, std::string(style.severity));
  overlay.items.emplace_back(marker);
}

}  // namespace

// Errors come last, on top of the rest.
void draw_findings(const Json& answer, converter::Overlay& overlay) {
  for (const auto& style : kStyles) {
    for (const auto& map : answer.at("maps")) {
      for (const auto& finding : map.at("findings")) {
        if (finding.at("severity") == style.severity && has_place(finding)) {
          add_marker(finding, style, overlay);
        }
      }
    }
  }
}

}  // namespace mapwright::cli
