#include "validators/profile/policy.hpp"

#include <algorithm>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/near_word.hpp"
#include "validators/profile/profile_reader.hpp"
#include "validators/profile/yaml_reading.hpp"

namespace mapwright::validators {
namespace {

/// Reads the list of suppressions.
class SuppressionReader {
 public:
  explicit SuppressionReader(YamlMistakes& mistakes) : mistakes_(mistakes) {}

  std::vector<Suppression> read(const YAML::Node& node) {
    std::vector<Suppression> all;
    if (node.IsNull()) return all;
    if (!node.IsSequence()) {
      mistakes_.add(node, "expected a list of suppressions here, each behind a '-'");
      return all;
    }
    for (const auto& item : node) all.push_back(one(item));
    return all;
  }

 private:
  Suppression one(const YAML::Node& node) {
    Suppression result;
    result.place = place_of(node);
    const auto text_into = [this](std::string& target) {
      return
          [this, &target](const YAML::Node& n) { target = yaml_text(n, mistakes_).value_or("-"); };
    };
    read_keys(
        node, mistakes_,
        {{"code", [&](const YAML::Node& n) { result.codes = codes(n); }},
         {"obstacle", [&](const YAML::Node& n) { result.obstacle = yaml_integer(n, mistakes_); }},
         {"segment", [&](const YAML::Node& n) { result.segment = segment(n); }},
         {"region", [&](const YAML::Node& n) { result.region = region(n); }},
         {"path", text_into(result.path)},
         {"fingerprint", text_into(result.fingerprint)},
         {"reason", text_into(result.reason)},
         {"until", [&](const YAML::Node& n) { result.until = date(n); }}});
    if (node.IsMap()) demand(node, result);
    return result;
  }

  void demand(const YAML::Node& node, const Suppression& suppression) {
    if (!node["code"].IsDefined()) {
      mistakes_.add(node, "the suppression names no code; write which finding it is about");
    }
    if (suppression.reason.find_first_not_of(" \t\r\n") == std::string::npos) {
      mistakes_.add(node, "the suppression gives no reason; write why the finding is accepted");
    }
    if (suppression.segment && !suppression.obstacle) {
      mistakes_.add(node["segment"], "a segment needs the obstacle it belongs to");
    }
  }

  std::vector<FindingCode> codes(const YAML::Node& node) {
    std::vector<FindingCode> codes;
    const auto add = [&](const YAML::Node& n) {
      if (const auto code = yaml_code(n, mistakes_)) codes.push_back(*code);
    };
    if (!node.IsSequence()) {
      add(node);
    } else if (node.size() == 0) {
      mistakes_.add(node, "the list holds no code");
    }
    if (node.IsSequence()) {
      for (const auto& item : node) add(item);
    }
    return codes;
  }

  std::optional<std::size_t> segment(const YAML::Node& node) {
    const auto number = yaml_integer(node, mistakes_);
    if (number && *number >= 1) return static_cast<std::size_t>(*number);
    if (number) mistakes_.add(node, "segments are numbered from 1 on");
    return std::nullopt;
  }

  std::optional<Box> region(const YAML::Node& node) {
    if (!node.IsSequence() || node.size() != 4) {
      mistakes_.add(node, "expected [x1, y1, x2, y2] in metres here, two opposite corners");
      return std::nullopt;
    }
    std::vector<double> numbers;
    for (const auto& item : node) {
      if (const auto number = yaml_number(item, -1e12, 1e12, mistakes_)) numbers.push_back(*number);
    }
    if (numbers.size() != 4) return std::nullopt;
    Box box = kEmptyBox;
    box.add({numbers[0], numbers[1]});
    box.add({numbers[2], numbers[3]});
    return box;
  }

  std::optional<Date> date(const YAML::Node& node) {
    const auto text = yaml_text(node, mistakes_);
    if (!text) return std::nullopt;
    const auto date = parse_date(*text);
    if (!date) mistakes_.add(node, text::quoted(*text) + " is no day; write it as 2027-01-31");
    return date;
  }

  YamlMistakes& mistakes_;
};

// What stands under the key `profiles`; null where nothing does.
YAML::Node profiles_of(const YAML::Node& root) {
  const bool is_there = root.IsMap() && root["profiles"].IsDefined();
  return is_there ? root["profiles"] : YAML::Node();
}

/// Reads the whole file.
class PolicyReader {
 public:
  PolicyReader(const YAML::Node& root, YamlMistakes& mistakes)
      : root_(root), mistakes_(mistakes), profiles_(profiles_of(root), mistakes) {}

  /// The profile of that name, or the file's choice; what stands outside of profiles comes on top.
  void read(const std::string& profile_name, Policy& policy) {
    profiles_.read_all();
    const std::string name = profile_name.empty() ? chosen() : profile_name;
    if (profiles_.knows(name)) policy.profile = profiles_.profile(name);
    auto keys = profiles_.setting_keys(policy.profile);
    keys.push_back({"profile", [](const YAML::Node&) {}});
    keys.push_back({"profiles", [](const YAML::Node&) {}});
    keys.push_back({"suppressions", [&](const YAML::Node& node) {
                      policy.suppressions = SuppressionReader(mistakes_).read(node);
                    }});
    if (!root_.IsNull()) read_keys(root_, mistakes_, keys);
  }

  bool knows(const std::string& name) const { return profiles_.knows(name); }
  std::vector<std::string_view> names() const { return profiles_.names(); }

 private:
  std::string chosen() {
    if (!root_.IsMap() || !root_["profile"].IsDefined()) return "default";
    const auto name = yaml_text(root_["profile"], mistakes_);
    if (!name) return "default";
    if (!profiles_.knows(*name)) {
      mistakes_.add_unknown(root_["profile"], "profile", *name, profiles_.names());
    }
    return *name;
  }

  YAML::Node root_;
  YamlMistakes& mistakes_;
  ProfileReader profiles_;
};

std::string unknown_profile(const std::string& name, const std::vector<std::string_view>& known) {
  std::string message = "there is no profile " + text::quoted(name);
  if (const auto meant = text::near_word(name, known)) {
    return message + "; did you mean " + std::string(*meant) + "?";
  }
  std::string all;
  for (const auto word : known) all += (all.empty() ? "" : ", ") + std::string(word);
  return message + "; there are " + all;
}

}  // namespace

Result<Policy> read_policy(std::string text, std::string path, std::string_view profile_name) {
  YamlMistakes mistakes(path);
  Policy policy;
  const std::string wanted(profile_name);
  try {
    PolicyReader reader(YAML::Load(text), mistakes);
    if (!wanted.empty() && !reader.knows(wanted)) {
      return usage_failure(unknown_profile(wanted, reader.names()));
    }
    reader.read(wanted, policy);
  } catch (const YAML::Exception& error) {
    mistakes.add(error.mark, error.msg);
  }
  if (!mistakes.empty()) return input_failure(mistakes.text());
  policy.path = std::move(path);
  policy.text = std::move(text);
  return policy;
}

}  // namespace mapwright::validators
