// Writing decimal numbers at a resolution.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mapwright::text {

/// Rounds numbers to multiples of a resolution and writes them with the fewest decimals that name
/// the multiple: 12.1, 58, -0.5; never "-0".
///
/// Numbers of 2^50 multiples and more have no more digits than the resolution asks for, nearly;
/// they are left as they are and written with the fewest digits that read back as the same double.
class DecimalFormat {
 public:
  /// Most characters one number takes.
  static constexpr std::size_t kMaxCharacters = 352;

  /// `resolution` in [1e-9, 1e6], taken with its first nine significant digits.
  explicit DecimalFormat(double resolution);

  /// Writes a finite number and returns the end; kMaxCharacters must be writable.
  char* write(char* out, double value) const;

  /// The double that reading the written number gives.
  double rounded(double value) const;
  /// The same for many values, in place.
  void round(std::span<double> values) const;

  /// Writes the number of so many units of the last decimal; 12 characters at most are written.
  char* write_units(char* out, std::int32_t units) const {
    return write_units(out, std::int64_t{units});
  }
  /// The double that reading the written number gives.
  double of_units(std::int32_t units) const { return static_cast<double>(units) / scale_; }
  /// The units of numbers that are rounded already. False, with `units` half filled, where one is
  /// not, or where that many are no std::int32_t.
  bool units_of(std::span<const double> values, std::int32_t* units) const;
  /// `round` and `units_of` at once. False, with `units` half filled, where that many are no
  /// std::int32_t; the values are rounded all the same.
  bool round(std::span<double> values, std::int32_t* units) const;

  int decimals() const { return decimals_; }

 private:
  struct Multiple {
    bool fits = false;
    std::int64_t units = 0;  ///< the multiple in units of the last decimal
  };
  Multiple nearest_multiple(double value) const;
  char* write_units(char* out, std::int64_t units) const;

  int decimals_ = 0;  ///< the resolution is step_ · 10^-decimals_
  std::int64_t step_ = 1;
  std::uint64_t units_per_one_ = 1;  ///< 10^decimals_
  double scale_ = 1.0;               ///< the same
};

}  // namespace mapwright::text
