// Private to this folder: Large integers for Boost.Polygon's Voronoi diagram. For .cpp files only.
#pragma once

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

namespace mapwright::navcore::exact {

/// A signed integer of up to 2048 bits, as many as Boost.Polygon's own, in limbs of 64 bits where
/// that has 32: half as many, so a product takes a quarter of the steps.
class VoronoiInteger {
 public:
  VoronoiInteger() = default;
  VoronoiInteger(std::int64_t value) : count_(value == 0 ? 0 : 1), is_negative_(value < 0) {
    const auto bits = static_cast<std::uint64_t>(value);
    limbs_[0] = value < 0 ? ~bits + 1 : bits;
  }
  VoronoiInteger(std::int32_t value) : VoronoiInteger(std::int64_t{value}) {}
  VoronoiInteger(const VoronoiInteger& other)
      : count_(other.count_), is_negative_(other.is_negative_) {
    for (int i = 0; i < count_; ++i) limbs_[i] = other.limbs_[i];
  }
  VoronoiInteger& operator=(const VoronoiInteger& other) {
    count_ = other.count_;
    is_negative_ = other.is_negative_;
    for (int i = 0; i < count_; ++i) limbs_[i] = other.limbs_[i];
    return *this;
  }

  VoronoiInteger operator-() const {
    VoronoiInteger result = *this;
    result.is_negative_ = !is_negative_;
    return result;
  }
  friend VoronoiInteger operator+(const VoronoiInteger& p, const VoronoiInteger& q) {
    return sum(p, q, q.is_negative_);
  }
  friend VoronoiInteger operator-(const VoronoiInteger& p, const VoronoiInteger& q) {
    return sum(p, q, !q.is_negative_);
  }
  friend VoronoiInteger operator*(const VoronoiInteger& p, const VoronoiInteger& q) {
    VoronoiInteger result;
    if (p.count_ == 0 || q.count_ == 0) return result;
    assert(p.count_ + q.count_ <= kMostLimbs + 1);
    result.is_negative_ = p.is_negative_ != q.is_negative_;
    result.limbs_[q.count_] = times(p.limbs_[0], q, result.limbs_, false);
    for (int i = 1; i < p.count_; ++i) {
      result.limbs_[i + q.count_] = times(p.limbs_[i], q, result.limbs_ + i, true);
    }
    result.count_ = p.count_ + q.count_;
    result.drop_leading_zeros();
    return result;
  }
  friend bool is_pos(const VoronoiInteger& p) { return p.count_ > 0 && !p.is_negative_; }
  friend bool is_neg(const VoronoiInteger& p) { return p.count_ > 0 && p.is_negative_; }
  friend bool is_zero(const VoronoiInteger& p) { return p.count_ == 0; }

  /// The value as a double times a power of two, from the three highest limbs.
  std::pair<double, int> scaled() const {
    constexpr double kLimb = 18446744073709551616.0;
    double value = 0.0;
    const int lowest = std::max(0, count_ - 3);
    for (int i = count_ - 1; i >= lowest; --i) {
      value = value * kLimb + static_cast<double>(limbs_[i]);
    }
    return {is_negative_ ? -value : value, 64 * lowest};
  }

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr int kMostLimbs = 32;

  static VoronoiInteger sum(const VoronoiInteger& p, const VoronoiInteger& q, bool q_is_negative) {
    const bool p_is_longer = has_greater_size(p, q);
    const VoronoiInteger &longer = p_is_longer ? p : q, &shorter = p_is_longer ? q : p;
    VoronoiInteger result;
    result.is_negative_ = p_is_longer ? p.is_negative_ : q_is_negative;
    if (p.is_negative_ == q_is_negative) {
      result.add_sizes(longer, shorter);
    } else {
      result.subtract_sizes(longer, shorter);
    }
    return result;
  }

  // Sets `to` to limb · q, or adds it; gives what is carried beyond.
  static std::uint64_t times(std::uint64_t limb, const VoronoiInteger& q, std::uint64_t* to,
                             bool adds) {
    std::uint64_t carry = 0;
    for (int k = 0; k < q.count_; ++k) {
      const Wide step = Wide{limb} * q.limbs_[k] + (adds ? to[k] : 0) + carry;
      to[k] = static_cast<std::uint64_t>(step);
      carry = static_cast<std::uint64_t>(step >> 64);
    }
    return carry;
  }

  static bool has_greater_size(const VoronoiInteger& p, const VoronoiInteger& q) {
    if (p.count_ != q.count_) return p.count_ > q.count_;
    for (int i = p.count_ - 1; i >= 0; --i) {
      if (p.limbs_[i] != q.limbs_[i]) return p.limbs_[i] > q.limbs_[i];
    }
    return true;
  }

  void add_sizes(const VoronoiInteger& longer, const VoronoiInteger& shorter) {
    std::uint64_t carry = 0;
    for (int i = 0; i < longer.count_; ++i) {
      const Wide step =
          Wide{longer.limbs_[i]} + (i < shorter.count_ ? shorter.limbs_[i] : 0) + carry;
      limbs_[i] = static_cast<std::uint64_t>(step);
      carry = static_cast<std::uint64_t>(step >> 64);
    }
    count_ = longer.count_;
    if (carry != 0) limbs_[count_++] = carry;
  }

  void subtract_sizes(const VoronoiInteger& longer, const VoronoiInteger& shorter) {
    std::uint64_t borrow = 0;
    for (int i = 0; i < longer.count_; ++i) {
      const Wide step =
          Wide{longer.limbs_[i]} - (i < shorter.count_ ? shorter.limbs_[i] : 0) - borrow;
      limbs_[i] = static_cast<std::uint64_t>(step);
      borrow = static_cast<std::uint64_t>(step >> 64) & 1U;
    }
    count_ = longer.count_;
    drop_leading_zeros();
  }

  void drop_leading_zeros() {
    while (count_ > 0 && limbs_[count_ - 1] == 0) --count_;
  }

  std::uint64_t limbs_[kMostLimbs + 1];  // lowest first; only count_ of them are set
  int count_ = 0;
  bool is_negative_ = false;
};

/// What Boost.Polygon computes with, for 32-bit input: its own choice but for the large integers.
struct VoronoiNumbers {
  using Usual = boost::polygon::detail::voronoi_ctype_traits<std::int32_t>;
  using int_type = Usual::int_type;
  using int_x2_type = Usual::int_x2_type;
  using uint_x2_type = Usual::uint_x2_type;
  using big_int_type = VoronoiInteger;
  using fpt_type = Usual::fpt_type;
  using efpt_type = Usual::efpt_type;
  using ulp_cmp_type = Usual::ulp_cmp_type;

  struct to_fpt_converter_type : Usual::to_fpt_converter_type {
    using Usual::to_fpt_converter_type::operator();
    double operator()(const VoronoiInteger& value) const {
      const auto [significand, exponent] = value.scaled();
      return std::ldexp(significand, exponent);
    }
  };
  struct to_efpt_converter_type {
    efpt_type operator()(const VoronoiInteger& value) const {
      const auto [significand, exponent] = value.scaled();
      return {significand, exponent};
    }
  };
};

}  // namespace mapwright::navcore::exact
