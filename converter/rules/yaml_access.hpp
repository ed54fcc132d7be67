// Private to this folder: YAML with places in its errors.
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <string>
#include <vector>

namespace mapwright::converter {

/// A mistake at a place of a rules file; caught by read_rules.
struct RuleMistake {
  YAML::Mark mark;
  std::string message;
};

[[noreturn]] void fail_at(const YAML::Node& node, const std::string& message);

std::string yaml_text(const YAML::Node& node);                ///< a scalar
double yaml_number(const YAML::Node& node);                   ///< a finite number
std::vector<std::string> yaml_texts(const YAML::Node& node);  ///< a scalar or a list of them

/// What to do with the value of a key.
struct KeyReader {
  std::string key;
  std::function<void(const YAML::Node&)> read;
};

/// Reads a map whose every key must be one of `keys`.
void read_keys(const YAML::Node& node, const std::string& what, const std::vector<KeyReader>& keys);

}  // namespace mapwright::converter
