// Runs the program as a process of its own, as a script does.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program_run.hpp"

namespace mapwright::test {

struct ProcessOptions {
  std::string standard_input;          ///< what the program reads there
  std::string standard_output;         ///< a file to send it to; empty: kept for the test
  std::size_t largest_file_bytes = 0;  ///< 0: no limit; beyond it writing fails
};

/// Starts the program's executable. Files of the run stand in `folder`, one run at a time.
inline pid_t start_process(const TemporaryFolder& folder, std::vector<std::string> arguments,
                           const ProcessOptions& options = {}) {
  const std::string in = folder.file(".stdin", options.standard_input);
  const std::string err = folder.file(".stderr", "");
  const std::string out =
      options.standard_output.empty() ? folder.file(".stdout", "") : options.standard_output;
  arguments.insert(arguments.begin(), MAPWRIGHT_PROGRAM);

  const pid_t child = ::fork();
  if (child == 0) {
    const auto redirect = [](const std::string& path, int flags, int descriptor) {
      const int file = ::open(path.c_str(), flags);
      if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(127);
    };
    redirect(in, O_RDONLY, STDIN_FILENO);
    redirect(out, O_WRONLY, STDOUT_FILENO);
    redirect(err, O_WRONLY, STDERR_FILENO);
    if (options.largest_file_bytes > 0) {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{options.largest_file_bytes, options.largest_file_bytes};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> words;
    for (auto& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  return child;
}

/// Waits for a run to end; a signal that killed it is status 128 + its number.
inline ProgramRun wait_for_process(const TemporaryFolder& folder, pid_t child,
                                   const ProcessOptions& options = {}) {
  int status = 0;
  ::waitpid(child, &status, 0);
  const auto text_of = [](const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          options.standard_output.empty() ? text_of(folder.path(".stdout")) : "",
          text_of(folder.path(".stderr"))};
}

/// Both.
inline ProgramRun run_process(const TemporaryFolder& folder, std::vector<std::string> arguments,
                              const ProcessOptions& options = {}) {
  return wait_for_process(folder, start_process(folder, std::move(arguments), options), options);
}

}  // namespace mapwright::test
