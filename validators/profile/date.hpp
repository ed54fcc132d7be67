// Days of the calendar, as configuration files write them.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace mapwright::validators {

/// A day of the Gregorian calendar.
using Date = std::chrono::year_month_day;

/// "2027-01-31"; nothing for another form and for days there are not.
std::optional<Date> parse_date(std::string_view text);

std::string date_text(Date date);

}  // namespace mapwright::validators
