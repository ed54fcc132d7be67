#include "converter/frame/transform_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "converter/frame/patch_polynomial.hpp"

namespace mapwright::converter {
namespace {

using Coefficient = PatchPolynomial::Coefficient;

constexpr std::size_t kNodes = PatchPolynomial::kNodes;
constexpr std::size_t kCoefficients = PatchPolynomial::kCoefficients;
constexpr std::size_t kProbes = 6;        // a side
constexpr std::size_t kMostCells = 4096;  // beyond: points strewn over the Earth
constexpr double kFarthestCell = 1.0e9;   // what a cell number can hold

using Polynomials = std::array<double, kNodes>;  // T0 to T4 at one place

Polynomials chebyshev(double t) {
  const double t2 = 2.0 * t * t - 1.0;
  const double t3 = 2.0 * t * t2 - t;
  return {1.0, t, t2, t3, 2.0 * t * t3 - t2};
}

double node(std::size_t k) {
  return std::cos(std::numbers::pi * (2.0 * static_cast<double>(k) + 1.0) / (2.0 * kNodes));
}

double probe(std::size_t k) {
  return -1.0 + 2.0 * static_cast<double>(k) / (kProbes - 1);
}

// Values of one target coordinate at the nodes to coefficients of the tensor product.
using Grid = std::array<std::array<double, kNodes>, kNodes>;

Grid coefficients(std::span<const double> values) {
  std::array<Polynomials, kNodes> basis;
  for (std::size_t k = 0; k < kNodes; ++k) basis[k] = chebyshev(node(k));
  Grid grid{};
  for (std::size_t m = 0; m < kNodes; ++m) {
    for (std::size_t n = 0; n < kNodes; ++n) {
      double sum = 0.0;
      for (std::size_t i = 0; i < kNodes; ++i) {
        for (std::size_t j = 0; j < kNodes; ++j) {
          sum += values[i * kNodes + j] * basis[i][m] * basis[j][n];
        }
      }
      grid[m][n] = sum * (m == 0 ? 1.0 : 2.0) * (n == 0 ? 1.0 : 2.0) / (kNodes * kNodes);
    }
  }
  return grid;
}

// Keeps the coefficients of total degree 4; the sum of what is left out is added to `rest`.
std::array<Coefficient, kCoefficients> kept(const Grid& x, const Grid& y, double& rest) {
  std::array<Coefficient, kCoefficients> all;
  std::size_t next = 0;
  for (std::size_t m = 0; m < kNodes; ++m) {
    for (std::size_t n = 0; n < kNodes; ++n) {
      if (m + n < kNodes)
        all[next++] = {x[m][n], y[m][n]};
      else
        rest += std::abs(x[m][n]) + std::abs(y[m][n]);
    }
  }
  return all;
}

// Chebyshev's polynomials stay within 1; what rounding adds is less than their sum once more.
double reach_of(const std::array<Coefficient, kCoefficients>& coefficients) {
  double x = 0.0, y = 0.0;
  for (const auto& c : coefficients) {
    x += std::abs(c.x);
    y += std::abs(c.y);
  }
  return 2.0 * std::max(x, y);
}

}  // namespace

struct TransformPatches::Patch : PatchPolynomial {
  double left_out = 0.0;
  double reach = 0.0;  // no image of the cell lies farther from either axis
};

namespace {

bool is_power_of_two(double value) {
  int exponent = 0;
  return std::frexp(value, &exponent) == 0.5;
}

}  // namespace

TransformPatches::TransformPatches(PlaneTransform exact, double cell)
    : exact_(std::move(exact)), cell_(cell), has_exact_edges_(is_power_of_two(cell)) {}
TransformPatches::TransformPatches(TransformPatches&&) noexcept = default;
TransformPatches& TransformPatches::operator=(TransformPatches&&) noexcept = default;
TransformPatches::~TransformPatches() = default;

std::size_t TransformPatches::CellHash::operator()(const CellKey& key) const {
  const auto column = static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.column));
  const auto row = static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.row));
  return static_cast<std::size_t>((column << 32 | row) * 0x9E3779B97F4A7C15ULL >> 16);
}

TransformPatches::CellKey TransformPatches::cell_of(double x, double y) const {
  return {static_cast<std::int32_t>(std::floor(x / cell_)),
          static_cast<std::int32_t>(std::floor(y / cell_))};
}

// Points from `i` on that lie in the cell of the last one. Where cells are a power of two wide,
// their edges are numbers, and comparing says what dividing would.
std::size_t TransformPatches::count_in_last_cell(std::span<const double> xs,
                                                 std::span<const double> ys, std::size_t i) const {
  if (last_ == nullptr || !has_exact_edges_) return 0;
  const double left = last_key_.column * cell_, right = left + cell_;
  const double bottom = last_key_.row * cell_, top = bottom + cell_;
  const std::size_t first = i;
  while (i < xs.size() && xs[i] >= left && xs[i] < right && ys[i] >= bottom && ys[i] < top) ++i;
  return i - first;
}

void TransformPatches::apply(std::span<double> xs, std::span<double> ys) {
  for (std::size_t i = 0; i < xs.size(); ++i) {
    if (const std::size_t count = count_in_last_cell(xs, ys, i); count > 0) {
      last_->apply(&xs[i], &ys[i], count);
      i += count - 1;
      continue;
    }
    const bool has_cell =
        std::abs(xs[i] / cell_) < kFarthestCell && std::abs(ys[i] / cell_) < kFarthestCell;
    const Patch* patch = has_cell ? patch_of(cell_of(xs[i], ys[i])) : nullptr;
    if (patch == nullptr) {
      exact_(xs.subspan(i, 1), ys.subspan(i, 1));
      continue;
    }
    patch->apply(&xs[i], &ys[i], 1);
  }
}

bool TransformPatches::apply_in_last_cell(std::span<double> xs, std::span<double> ys,
                                          double reach) const {
  if (count_in_last_cell(xs, ys, 0) != xs.size() || !(last_->reach <= reach)) return false;
  last_->apply(xs.data(), ys.data(), xs.size());
  return true;
}

const TransformPatches::Patch* TransformPatches::patch_of(const CellKey& key) {
  if (has_last_ && key == last_key_) return last_;
  auto found = cells_.find(key);
  if (found == cells_.end()) {
    if (cells_.size() >= kMostCells) return nullptr;
    found = cells_.emplace(key, fit(key)).first;
    ++(found->second ? patches_ : refused_);
  }
  last_key_ = key;
  last_ = found->second.get();
  has_last_ = true;
  return last_;
}

std::unique_ptr<TransformPatches::Patch> TransformPatches::fit(const CellKey& key) {
  auto patch = std::make_unique<Patch>();
  const double half = 0.5 * cell_;
  patch->inverse_half = 1.0 / half;
  patch->center = {(key.column + 0.5) * cell_, (key.row + 0.5) * cell_};
  std::array<double, kNodes * kNodes> xs, ys;
  for (std::size_t i = 0; i < kNodes * kNodes; ++i) {
    xs[i] = patch->center.x + half * node(i / kNodes);
    ys[i] = patch->center.y + half * node(i % kNodes);
  }
  exact_(xs, ys);
  patch->coefficients = kept(coefficients(xs), coefficients(ys), patch->left_out);
  patch->reach = reach_of(patch->coefficients);
  return holds(*patch) ? std::move(patch) : nullptr;
}

// Written so that NaN, where the projection covers not all of the cell, does not hold.
bool TransformPatches::holds(const Patch& patch) const {
  if (!(patch.left_out <= kBound_m)) return false;
  std::array<double, kProbes * kProbes> xs, ys;
  std::array<Point, kProbes * kProbes> mine;
  const double half = 0.5 * cell_;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    xs[i] = patch.center.x + half * probe(i / kProbes);
    ys[i] = patch.center.y + half * probe(i % kProbes);
    mine[i] = {xs[i], ys[i]};
    patch.apply(&mine[i].x, &mine[i].y, 1);
  }
  exact_(xs, ys);
  for (std::size_t i = 0; i < mine.size(); ++i) {
    if (!(std::hypot(mine[i].x - xs[i], mine[i].y - ys[i]) <= kBound_m)) return false;
  }
  return true;
}

}  // namespace mapwright::converter
