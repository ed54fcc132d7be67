#include "cli/support/common_options.hpp"

#include "cli/support/error.hpp"
#include "cli/support/number_options.hpp"

namespace mapwright::cli {

namespace po = boost::program_options;

po::typed_value<std::string>* text_value(const char* default_value) {
  return po::value<std::string>()->default_value(default_value);
}

void declare_map_argument(po::options_description& options,
                          po::positional_options_description& positionals, std::string& path) {
  options.add_options()("map", po::value(&path)->required(), "the map; - reads standard input");
  positionals.add("map", 1);
}

void declare_answer_format(po::options_description& options) {
  options.add_options()("format", text_value("text"), "of the answer: text or json");
}

bool json_wanted(const po::variables_map& values) {
  const auto& format = values["format"].as<std::string>();
  if (format != "text" && format != "json") {
    fail_usage("--format: '" + format + "' is neither text nor json");
  }
  return format == "json";
}

void declare_seed(po::options_description& options, const char* help) {
  options.add_options()("seed", text_value("1"), help);
}

std::uint64_t seed_option(const po::variables_map& values) {
  return integer_option(values, "seed");
}

void declare_threads(po::options_description& options) {
  options.add_options()("threads", text_value("0"),
                        "0: as many as the machine has. The answer is the same");
}

unsigned threads_option(const po::variables_map& values) {
  constexpr std::uint64_t kMostThreads = 1024;
  return static_cast<unsigned>(integer_option(values, "threads", 0, kMostThreads));
}

}  // namespace mapwright::cli
