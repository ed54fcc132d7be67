// What GDAL says, caught before it reaches standard error.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mapwright::converter {

/// A message of GDAL without places in GDAL's own source code and advice on GDAL's own options.
std::string plain_message(std::string message);

/// Catches GDAL's messages on this thread for as long as it lives. They may be nested.
class GdalMessages {
 public:
  GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;
  ~GdalMessages();

  bool has_error() const { return !first_error_.empty(); }
  const std::string& first_error() const { return first_error_; }

  /// Distinct warnings since the last call, in order; of a flood only the first hundred.
  std::vector<std::string> take_warnings();
  void clear_error() { first_error_.clear(); }

  /// Adds a message; called by the handler GDAL knows.
  void add(bool is_error, const char* said);

 private:
  std::vector<std::string> warnings_;
  std::string first_error_;
};

}  // namespace mapwright::converter
