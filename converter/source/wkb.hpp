// Well-known binary (ISO 19125) taken apart into paths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// A geometry's paths, where they lie in its bytes. Used again from geometry to geometry.
struct WkbPaths {
  struct Path {
    PathRole role = PathRole::kLine;
    std::uint32_t count = 0;
    const std::byte* points = nullptr;  ///< so many times `numbers` doubles
  };

  std::string_view type;  ///< "MULTIPOLYGON"
  std::vector<Path> paths;
  std::size_t numbers = 2;  ///< of a point: x, y, and what there is besides, height first
  bool has_heights = false;

  std::uint32_t point_count() const;
};

/// Finds the paths of a geometry, as append_paths does of the geometry that GDAL makes of it,
/// without making one. False, with `paths` half filled, for what only GDAL should judge: curves,
/// surfaces, collections of collections, empty parts, other byte orders, bytes that end too early.
bool find_paths(std::span<const std::byte> wkb, WkbPaths& paths);

/// Copies the number at that place (0: x, 1: y, 2: height) of each point to `to`, which need not be
/// aligned; returns where it ends.
char* copy_numbers(const WkbPaths& paths, std::size_t place, char* to);

}  // namespace mapwright::converter
