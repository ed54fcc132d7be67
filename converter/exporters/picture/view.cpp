#include "converter/exporters/picture/view.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace mapwright::converter {

std::vector<Point> View::to_page(const std::vector<Point>& points) const {
  std::vector<Point> page;
  page.reserve(points.size());
  for (const Point p : points) page.push_back(to_page(p));
  return page;
}

double View::line_scale() const {
  const double m_per_pt = 1.0 / pt_per_m;
  return std::clamp(1.0 - 0.5 * std::log10(m_per_pt / 0.2), 0.3, 1.0);
}

double round_step(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / power;
  if (mantissa >= 5.0) return 5.0 * power;
  return mantissa >= 2.0 ? 2.0 * power : power;
}

std::string plain_number(double value) {
  const double rounded = std::round(value * 1000.0) / 1000.0;
  char buffer[32];
  const auto end =
      std::to_chars(std::begin(buffer), std::end(buffer), rounded == 0.0 ? 0.0 : rounded);
  return {std::begin(buffer), end.ptr};
}

}  // namespace mapwright::converter
