#include "cli/support/arguments.hpp"

#include <charconv>
#include <cmath>

#include "cli/support/error.hpp"

namespace mapwright::cli {

double parse_number(const std::string& option, const std::string& text) {
  std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) first = text.size();
  if (first < text.size() && text[first] == '+') ++first;
  const std::size_t last = text.find_last_not_of(" \t");
  const char* begin = text.data() + first;
  const char* end = text.data() + (last == std::string::npos ? text.size() : last + 1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) {
    fail_usage("--" + option + ": '" + text + "' is not a finite number");
  }
  return value;
}

std::uint64_t parse_integer(const std::string& option, const std::string& text, std::uint64_t least,
                            std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_read = error == std::errc{} && stop == text.data() + text.size();
  if (is_read && least <= value && value <= most) return value;
  const std::string range = most == UINT64_MAX
                                ? "of " + std::to_string(least) + " or more"
                                : "from " + std::to_string(least) + " to " + std::to_string(most);
  fail_usage("--" + option + ": '" + text + "' is no whole number " + range);
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (true) {
    const auto comma = text.find(',', begin);
    numbers.push_back(parse_number(option, text.substr(begin, comma - begin)));
    if (comma == std::string::npos) break;
    begin = comma + 1;
  }
  if (numbers.size() < least || numbers.size() > most) {
    const std::string count = least == most ? std::to_string(least)
                                            : std::to_string(least) + " to " + std::to_string(most);
    fail_usage("--" + option + ": expected " + count + " numbers with commas between them, got '" +
               text + "'");
  }
  return numbers;
}

Point parse_point(const std::string& option, const std::string& text) {
  const auto numbers = parse_numbers(option, text, 2, 2);
  return {numbers[0], numbers[1]};
}

Pose parse_pose(const std::string& option, const std::string& text) {
  const auto numbers = parse_numbers(option, text, 3, 3);
  return {numbers[0], numbers[1], Angle::from_degrees(numbers[2])};
}

std::vector<std::string> with_negative_values_joined(std::vector<std::string> arguments) {
  const auto is_long_option = [](const std::string& word) {
    return word.size() > 2 && word.compare(0, 2, "--") == 0 && word.find('=') == word.npos;
  };
  const auto is_negative_number = [](const std::string& word) {
    return word.size() > 1 && word[0] == '-' &&
           (word[1] == '.' || (word[1] >= '0' && word[1] <= '9'));
  };
  std::vector<std::string> joined;
  for (auto& word : arguments) {
    if (!joined.empty() && is_long_option(joined.back()) && is_negative_number(word)) {
      joined.back() += "=" + word;
    } else {
      joined.push_back(std::move(word));
    }
  }
  return joined;
}

}  // namespace mapwright::cli
