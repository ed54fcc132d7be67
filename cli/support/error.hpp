// What stops a verb.
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "cli/verb.hpp"
#include "mapcore/result.hpp"

namespace mapwright::cli {

/// Ends a verb with a message and an exit status.
class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  explicit Error(const Failure& failure);
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

[[noreturn]] void fail_usage(const std::string& message);

/// The value, or the failure as an Error.
template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw Error(result.error());
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

}  // namespace mapwright::cli
