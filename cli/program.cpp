#include "cli/program.hpp"

#include <algorithm>
#include <exception>
#include <iomanip>
#include <new>
#include <ostream>

#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"
#include "cli/version.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

void print_program_help(std::ostream& out) {
  out << "mapwright turns GIS vector layers into maps a robot can navigate by, and proves them "
         "fit.\n"
         "\n"
         "Usage: mapwright VERB [OPTIONS] ...\n"
         "\n"
         "Verbs:\n";
  for (const auto& verb : verbs()) {
    out << "  " << std::left << std::setw(10) << verb.name << ' ' << verb.summary << '\n';
  }
  out << "\n"
         "mapwright help VERB or mapwright VERB --help says more; mapwright --version the "
         "version.\n"
         "\n"
         "Exit status: 0 success; 1 findings of severity error or a negative answer; 2 wrong "
         "usage;\n"
         "3 an input cannot be read; 4 an output cannot be written; 5 internal error.\n";
}

const VerbEntry& find_verb(const std::string& name) {
  const auto& all = verbs();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const VerbEntry& verb) { return verb.name == name; });
  if (found == all.end()) {
    fail_usage("there is no verb '" + name + "'; 'mapwright --help' lists them");
  }
  return *found;
}

po::options_description common_options() {
  po::options_description common("Common options");
  common.add_options()("help,h", "show this help")("quiet,q", "say nothing but errors")("verbose,v",
                                                                                        "say more");
  return common;
}

void print_verb_help(const VerbEntry& entry, const Verb& verb, const po::options_description& own,
                     std::ostream& out) {
  out << "Usage: mapwright " << entry.name << ' ' << verb.synopsis() << "\n\n"
      << verb.description() << '\n'
      << own << '\n'
      << common_options();
}

// Boost speaks of the option --map where a person left out the argument MAP.
void notify_values(po::variables_map& values, const po::positional_options_description& positionals,
                   std::string_view verb, std::string_view synopsis) {
  try {
    po::notify(values);
  } catch (const po::required_option& missing) {
    const std::string name = missing.get_option_name().substr(2);
    if (positionals.max_total_count() == 0 || positionals.name_for_position(0) != name) throw;
    fail_usage("the " + name + " is missing; usage: mapwright " + std::string(verb) + " " +
               std::string(synopsis));
  }
}

// Positional arguments are options without a name of their own: help shows those that have a text.
ExitStatus run_verb(const VerbEntry& entry, std::vector<std::string> arguments, Console& console) {
  const auto verb = entry.make();
  po::options_description own("Options", 100, 60);
  po::positional_options_description positionals;
  verb->declare(own, positionals);

  po::options_description all;
  all.add(own).add(common_options());
  // No guessing of abbreviated names: a script must not change its meaning when an option is added.
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::variables_map values;
  po::store(po::command_line_parser(with_negative_values_joined(std::move(arguments)))
                .options(all)
                .positional(positionals)
                .style(style)
                .run(),
            values);
  if (values.count("help") > 0) {
    print_verb_help(entry, *verb, own, console.out());
    return ExitStatus::kSuccess;
  }
  notify_values(values, positionals, entry.name, verb->synopsis());
  if (values.count("quiet") > 0) console.set_verbosity(Verbosity::kQuiet);
  if (values.count("verbose") > 0) console.set_verbosity(Verbosity::kVerbose);
  verb->configure(values);
  return verb->run(console);
}

ExitStatus dispatch(const std::vector<std::string>& arguments, Console& console) {
  if (arguments.empty()) {
    print_program_help(console.out());
    return ExitStatus::kUsage;
  }
  const std::string& first = arguments.front();
  std::vector<std::string> rest(arguments.begin() + 1, arguments.end());
  if (first == "--version") {
    console.out() << "mapwright " << kVersion << '\n';
    return ExitStatus::kSuccess;
  }
  if (first == "--help" || first == "-h" || (first == "help" && rest.empty())) {
    print_program_help(console.out());
    return ExitStatus::kSuccess;
  }
  if (first == "help") return run_verb(find_verb(rest.front()), {"--help"}, console);
  return run_verb(find_verb(first), std::move(rest), console);
}

}  // namespace

ExitStatus run_program(const std::vector<std::string>& arguments, Console& console) {
  const std::string hint =
      arguments.empty() ? "" : "; 'mapwright help " + arguments.front() + "' shows the options";
  try {
    return dispatch(arguments, console);
  } catch (const Error& error) {
    console.error(error.what());
    return error.status();
  } catch (const po::error& error) {
    console.error(error.what() + hint);
    return ExitStatus::kUsage;
  } catch (const std::bad_alloc&) {
    console.error("out of memory");
    return ExitStatus::kInternal;
  } catch (const std::exception& error) {
    console.error(std::string("internal error: ") + error.what());
    return ExitStatus::kInternal;
  }
}

}  // namespace mapwright::cli
