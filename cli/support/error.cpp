#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

ExitStatus status_of(FailureKind kind) {
  switch (kind) {
    case FailureKind::kUsage: return ExitStatus::kUsage;
    case FailureKind::kInput: return ExitStatus::kInput;
    case FailureKind::kOutput: return ExitStatus::kOutput;
  }
  return ExitStatus::kInternal;
}

}  // namespace

Error::Error(const Failure& failure) : Error(status_of(failure.kind), failure.message) {}

void fail_usage(const std::string& message) { throw Error(ExitStatus::kUsage, message); }

}  // namespace mapwright::cli
