// What a run of `mapwright check` was asked, as far as its findings depend on it.
#pragma once

#include <boost/program_options.hpp>
#include <map>
#include <string>

namespace mapwright::cli {

/// Runs with equal settings say the same of the same map; those with equal limits also of maps
/// that take too much.
struct RunSettings {
  std::string program;                         ///< version of mapwright
  std::map<std::string, std::string> options;  ///< by name; with files goes a digest of them
  std::map<std::string, std::string> limits;   ///< by name

  /// Digest of program and options.
  std::string fingerprint() const;

  friend bool operator==(const RunSettings&, const RunSettings&) = default;
};

/// All options but those that say which maps, how many at once and where the report goes: an option
/// that comes new counts. Throws Error (kInput) for a file that cannot be read.
RunSettings run_settings(const boost::program_options::variables_map& values);

}  // namespace mapwright::cli
