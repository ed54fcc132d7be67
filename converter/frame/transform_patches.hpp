// A smooth transformation of the plane by checked local polynomials.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// Takes points of one plane to another, in place; NaN where there is no way.
using PlaneTransform = std::function<void(std::span<double> xs, std::span<double> ys)>;

/// Carries out a transformation that costs much a point (a map projection by way of WGS 84) by
/// polynomials of total degree 4, one for each square cell of a fixed grid over the source plane,
/// in Chebyshev's basis and interpolated at Chebyshev's nodes (Trefethen, Approximation Theory and
/// Approximation Practice, ch. 3-4).
///
/// A cell's polynomial is used only if it holds kBound_m at 36 places over the whole closed cell,
/// corners included, and its left-out coefficients add up to less than that; elsewhere (datum grids
/// with kinks, cells that reach beyond what the projection covers) the exact transformation is
/// used. Which way a point goes depends on its cell alone, so points that are equal in the source
/// are equal in the map. Not safe to use from several threads: cells are made when first met.
class TransformPatches {
 public:
  /// Greatest difference from the exact transformation that a cell may show, in target units.
  static constexpr double kBound_m = 1.0e-7;

  /// `cell`: side of a cell, in source units. 8 km hold the bound for every common projection.
  TransformPatches(PlaneTransform exact, double cell);
  TransformPatches(TransformPatches&&) noexcept;
  TransformPatches& operator=(TransformPatches&&) noexcept;
  ~TransformPatches();

  /// In place; NaN where the exact transformation has no way.
  void apply(std::span<double> xs, std::span<double> ys);

  /// The same where all points lie in the cell of the last one and their images, whatever they
  /// are, no farther than `reach` from either axis. Else false, and nothing is done.
  bool apply_in_last_cell(std::span<double> xs, std::span<double> ys, double reach) const;

  std::size_t patches() const { return patches_; }  ///< cells with a polynomial
  std::size_t refused() const { return refused_; }  ///< cells whose polynomial did not hold

 private:
  struct Patch;
  struct CellKey {
    std::int32_t column = 0, row = 0;
    friend bool operator==(const CellKey&, const CellKey&) = default;
  };
  struct CellHash {
    std::size_t operator()(const CellKey& key) const;
  };

  CellKey cell_of(double x, double y) const;
  const Patch* patch_of(const CellKey& key);
  std::size_t count_in_last_cell(std::span<const double> xs, std::span<const double> ys,
                                 std::size_t i) const;
  std::unique_ptr<Patch> fit(const CellKey& key);
  bool holds(const Patch& patch) const;

  PlaneTransform exact_;
  double cell_;
  bool has_exact_edges_;  // a cell's are multiples of `cell_` without rounding
  std::unordered_map<CellKey, std::unique_ptr<Patch>, CellHash> cells_;
  CellKey last_key_;
  const Patch* last_ = nullptr;
  bool has_last_ = false;
  std::size_t patches_ = 0;
  std::size_t refused_ = 0;
};

}  // namespace mapwright::converter
