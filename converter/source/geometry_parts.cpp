#include "converter/source/geometry_parts.hpp"

#include <array>

namespace mapwright::converter {
namespace {

struct Kind {
  const char* type;
  std::array<PathRole, 2> roles;
};

constexpr std::array<Kind, 3> kKinds{
    {{"MULTIPOLYGON", {PathRole::kOuterRing, PathRole::kInnerRing}},
     {"MULTILINESTRING", {PathRole::kLine, PathRole::kLine}},
     {"MULTIPOINT", {PathRole::kPoint, PathRole::kPoint}}}};

void append_path(const SourceGeometry& from, const SourcePath& path, SourceGeometry& to) {
  const auto copy = [&](const std::vector<double>& source, std::vector<double>& target) {
    if (source.empty()) return;
    target.insert(target.end(), source.begin() + path.first,
                  source.begin() + path.first + path.count);
  };
  to.paths.push_back(path);
  to.paths.back().first = static_cast<std::uint32_t>(to.xs.size());
  copy(from.xs, to.xs);
  copy(from.ys, to.ys);
  copy(from.zs, to.zs);
}

}  // namespace

std::vector<SourceGeometry> parts_by_kind(const SourceGeometry& geometry) {
  std::vector<SourceGeometry> parts;
  for (const auto& kind : kKinds) {
    SourceGeometry part;
    for (const auto& path : geometry.paths) {
      if (path.role == kind.roles[0] || path.role == kind.roles[1])
        append_path(geometry, path, part);
    }
    if (part.paths.empty()) continue;
    part.type = kind.type;
    if (parts.empty()) part.unsupported = geometry.unsupported;
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace mapwright::converter
