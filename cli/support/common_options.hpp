// Options that many verbs have, one wording for all.
#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <string>

namespace mapwright::cli {

/// The value of an option that is text with a default. Numbers are text too, so that what is said
/// of a wrong one is ours (number_options.hpp).
boost::program_options::typed_value<std::string>* text_value(const char* default_value);

/// Adds MAP, the one map of a verb, as its first argument.
void declare_map_argument(boost::program_options::options_description& options,
                          boost::program_options::positional_options_description& positionals,
                          std::string& path);

/// Adds --format, text (the default) or json.
void declare_answer_format(boost::program_options::options_description& options);

/// True if --format says json, false if text. Throws Error (kUsage) for anything else.
bool json_wanted(const boost::program_options::variables_map& values);

/// Adds --seed, 1 if it is not given; `help` says what of.
void declare_seed(boost::program_options::options_description& options, const char* help);
/// What it says. Throws Error (kUsage) if it is no whole number.
std::uint64_t seed_option(const boost::program_options::variables_map& values);

/// Adds --threads, as many as the machine has if it is not given.
void declare_threads(boost::program_options::options_description& options);
/// What it says; 0: as many as the machine has. Throws Error (kUsage) for nonsense.
unsigned threads_option(const boost::program_options::variables_map& values);

}  // namespace mapwright::cli
