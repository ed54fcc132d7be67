// Private to this folder: YAML with every mistake and its place.
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"

namespace mapwright::validators {

/// The mistakes of one file, in the order they are found; each once.
class YamlMistakes {
 public:
  explicit YamlMistakes(std::string path) : path_(std::move(path)) {}

  void add(const YAML::Mark& mark, const std::string& message);
  void add(const YAML::Node& node, const std::string& message) { add(node.Mark(), message); }

  /// "there is no KIND 'WORD'", with the known word that was meant or all of them.
  void add_unknown(const YAML::Node& node, std::string_view kind, std::string_view word,
                   const std::vector<std::string_view>& known);

  bool empty() const { return mistakes_.empty(); }

  /// "PATH:LINE:COLUMN: error: …", by place.
  std::string text() const;

 private:
  struct Mistake {
    TextPlace place;
    std::string message;
  };
  std::string path_;
  std::vector<Mistake> mistakes_;
};

TextPlace place_of(const YAML::Node& node);

// Each reports what is wrong and answers nothing then.
std::optional<std::string> yaml_text(const YAML::Node& node, YamlMistakes& mistakes);
std::optional<double> yaml_number(const YAML::Node& node, double least, double most,
                                  YamlMistakes& mistakes);
std::optional<std::int64_t> yaml_integer(const YAML::Node& node, YamlMistakes& mistakes);

/// What to do with the value of a key.
struct YamlKey {
  std::string_view key;
  std::function<void(const YAML::Node&)> read;
};

/// Reads `key: value` lines, each key one of `keys` and there once.
void read_keys(const YAML::Node& node, YamlMistakes& mistakes, const std::vector<YamlKey>& keys);

/// Calls `read(key, value)` for `key: value` lines with keys of any name, each there once.
void read_entries(
    const YAML::Node& node, YamlMistakes& mistakes,
    const std::function<void(const std::string&, const YAML::Node&, const YAML::Node&)>& read);

}  // namespace mapwright::validators
