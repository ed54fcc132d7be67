// The answer of an operation that may not be possible: a value, or what went wrong.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace mapwright {

/// What stood in the way. Callers map it to an exit status (docs/cli.md).
enum class FailureKind {
  kUsage,   ///< what was asked makes no sense: a bad option value, options that exclude each other
  kInput,   ///< an input cannot be read
  kOutput,  ///< an output cannot be written
};

/// Why an operation could not be done: a sentence that says what is wrong, where, and what to do.
struct Failure {
  FailureKind kind = FailureKind::kInput;
  std::string message;
};

template <class T>
using Result = tl::expected<T, Failure>;

inline tl::unexpected<Failure> usage_failure(std::string message) {
  return tl::unexpected(Failure{FailureKind::kUsage, std::move(message)});
}
inline tl::unexpected<Failure> input_failure(std::string message) {
  return tl::unexpected(Failure{FailureKind::kInput, std::move(message)});
}
inline tl::unexpected<Failure> output_failure(std::string message) {
  return tl::unexpected(Failure{FailureKind::kOutput, std::move(message)});
}

}  // namespace mapwright
