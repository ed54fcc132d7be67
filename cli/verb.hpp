// What a verb of the program is.
#pragma once

#include <boost/program_options.hpp>
#include <iosfwd>
#include <memory>
#include <string_view>
#include <vector>

#include "cli/support/console.hpp"

namespace mapwright::cli {

/// docs/cli.md states these for every verb.
enum class ExitStatus : int {
  kSuccess = 0,
  kNegative = 1,  ///< findings of severity error, or a negative answer
  kUsage = 2,
  kInput = 3,
  kOutput = 4,
  kInternal = 5,
};

/// One verb. `declare` and `configure` do no work: a wrong command line costs nothing.
class Verb {
 public:
  virtual ~Verb() = default;

  /// The synopsis behind the verb's name, for example "MAP --start X,Y --goal X,Y".
  virtual std::string_view synopsis() const = 0;

  /// What `--help` says between the synopsis and the options: what the verb does and examples.
  virtual std::string_view description() const = 0;

  /// Adds options, and names for the positional arguments.
  virtual void declare(boost::program_options::options_description& options,
                       boost::program_options::positional_options_description& positionals) = 0;

  /// Takes the values over; throws Error (kUsage) for what makes no sense.
  virtual void configure(const boost::program_options::variables_map& values) = 0;

  /// Does the job. Throws Error for what cannot be done.
  virtual ExitStatus run(Console& console) = 0;
};

struct VerbEntry {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<Verb> (*make)();
};

/// All verbs, in the order `mapwright --help` shows them (verbs.def).
const std::vector<VerbEntry>& verbs();

}  // namespace mapwright::cli
