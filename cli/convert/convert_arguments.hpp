// The command line of `mapwright convert`.
#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "cli/support/frame_options.hpp"
#include "converter/pipeline/convert.hpp"

namespace mapwright::cli {

/// The options as they are typed, and what they mean.
class ConvertArguments {
 public:
  void declare(boost::program_options::options_description& options,
               boost::program_options::positional_options_description& positionals);

  /// Throws Error (kUsage) for what makes no sense.
  void check(const boost::program_options::variables_map& values);

  /// Reads the rules file; throws Error for one that cannot be read.
  converter::ConvertOptions options() const;

  const std::string& output() const { return output_; }
  const std::string& report() const { return report_; }
  bool explains_rules() const { return explain_rules_; }
  bool is_strict() const { return strict_; }
  bool watches() const { return watch_; }
  /// Map, sidecar and ledger, as far as they are files.
  std::vector<std::string> outputs() const;
  const std::vector<std::string>& sources() const { return options_.sources; }
  bool keeps_broken() const { return options_.keep_broken; }

 private:
  void check_frame();

  converter::ConvertOptions options_;
  std::string output_, report_;
  std::string rules_, bbox_, resolution_, local_unit_, snap_, simplify_;
  FrameArguments frame_;
  bool explain_rules_ = false;
  bool watch_ = false;
  bool strict_ = false;
  bool no_repair_ = false;
};

}  // namespace mapwright::cli
