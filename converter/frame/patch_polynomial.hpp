// Private to this folder: two polynomials of degree 4 over a square cell.
#pragma once

#include <array>
#include <cstddef>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// Coefficients of both target coordinates in Chebyshev's basis, m + n <= 4, those of one m
/// together.
struct PatchPolynomial {
  static constexpr std::size_t kNodes = 5;  ///< a side; degrees 0 to 4
  static constexpr std::size_t kCoefficients = 15;
  struct Coefficient {
    double x = 0.0, y = 0.0;
  };

  Point center;
  double inverse_half = 1.0;
  std::array<Coefficient, kCoefficients> coefficients;

  /// In place. Several points at a time, as many as the processor has lanes for, each by the same
  /// operations in the same order: the same bits from every processor.
  void apply(double* xs, double* ys, std::size_t count) const;
};

}  // namespace mapwright::converter
