// Looking at processes through /proc.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace mapwright::test {

struct ProcessState {
  char state = 'X';  ///< as in proc(5): R, S, D, Z (dead, not buried) …; X: there is none
  pid_t parent = 0;
};

inline ProcessState process_state(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  const auto end_of_name = text.rfind(')');
  if (end_of_name == text.npos) return {};
  ProcessState state;
  std::istringstream(text.substr(end_of_name + 1)) >> state.state >> state.parent;
  return state;
}

inline bool is_alive(pid_t process) {
  const char state = process_state(process).state;
  return state != 'X' && state != 'Z';
}

inline std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const pid_t process = std::atoi(entry.path().filename().c_str());
    if (process > 0 && process_state(process).parent == parent) children.push_back(process);
  }
  return children;
}

/// Waits up to a minute; false if it never came true.
inline bool wait_until(const std::function<bool()>& condition) {
  for (int i = 0; i < 6000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace mapwright::test
