// The options that say where a map lies: --origin, --origin-crs, --heading, --frame.
#pragma once

#include <boost/program_options.hpp>
#include <string>

#include "converter/frame/origin.hpp"

namespace mapwright::cli {

/// The options as they are typed, and what they mean.
class FrameArguments {
 public:
  /// `without`: what holds where no --origin is given, for the help.
  void declare(boost::program_options::options_description& options, const std::string& without);

  /// Throws Error (kUsage) for what makes no sense.
  converter::FrameOptions parse() const;

 private:
  std::string origin_, origin_crs_, heading_, frame_;
};

}  // namespace mapwright::cli
