// The large integers of the Voronoi diagram, against another library's.
#include "navcore/exact/voronoi_numbers.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "mapcore/random.hpp"

namespace mapwright::navcore::exact {
namespace {

using Reference = boost::multiprecision::cpp_int;

struct Pair {
  VoronoiInteger ours;
  Reference reference;
};

Pair draw(Random& random) {
  const auto value = static_cast<std::int64_t>(random.below(1ULL << 62)) >> random.below(62);
  const std::int64_t with_sign = random.below(2) == 0 ? value : -value;
  return {VoronoiInteger(with_sign), Reference(with_sign)};
}

Pair combine(const Pair& p, const Pair& q, std::uint64_t operation) {
  if (operation == 0) return {p.ours + q.ours, p.reference + q.reference};
  if (operation == 1) return {p.ours - q.ours, p.reference - q.reference};
  return {p.ours * q.ours, p.reference * q.reference};
}

void compare(const Pair& p) {
  ASSERT_EQ(is_pos(p.ours), p.reference > 0);
  ASSERT_EQ(is_neg(p.ours), p.reference < 0);
  ASSERT_EQ(is_zero(p.ours), p.reference == 0);
  const double exact = p.reference.convert_to<double>();
  const double ours = VoronoiNumbers::to_fpt_converter_type()(p.ours);
  ASSERT_NEAR(ours, exact, 4e-16 * std::abs(exact));
}

TEST(VoronoiInteger, ComputesAsOthersDo) {
  Random random(41);
  for (int round = 0; round < 2000; ++round) {
    Pair number = draw(random);
    for (int i = 0; i < 14; ++i) {
      number = combine(number, draw(random), random.below(3));
      compare(number);
      compare(combine(number, number, 1));  // all cancels
      compare({-number.ours, -number.reference});
    }
    const Pair square = combine(number, number, 2);
    compare(combine(square, combine(number, {VoronoiInteger(1), Reference(1)}, 0), 1));
  }
}

}  // namespace
}  // namespace mapwright::navcore::exact
