#include "validators/profile/baseline.hpp"

#include <nlohmann/json.hpp>
#include <tuple>

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "mapwright.baseline/1";

Json to_json(const KnownFinding& known) {
  Json json;
  json["code"] = finding_type(known.code).id;
  json["place"] = known.name.place;
  json["subject"] = known.name.subject;
  json["message"] = known.message;
  return json;
}

// Findings of codes that a later release knows cannot come up here.
std::vector<KnownFinding> known_findings(const Json& json) {
  std::vector<KnownFinding> findings;
  for (const auto& item : json.at("findings")) {
    const auto code = finding_code(item.at("code").get<std::string>());
    if (!code) continue;
    findings.push_back(
        {*code,
         {item.at("place").get<std::string>(), item.at("subject").get<std::string>()},
         item.value("message", "")});
  }
  return findings;
}

using Key = std::tuple<FindingCode, std::string>;

/// Marks findings whose name is left among the known ones; each of those is used once.
class Matcher {
 public:
  Matcher(const std::vector<KnownFinding>& known, const std::vector<Finding>& findings,
          const std::vector<Fingerprint>& names)
      : known_(known), findings_(findings), names_(names) {
    is_known_.resize(findings.size());
    is_used_.resize(known.size());
  }

  void match(std::string Fingerprint::*name) {
    std::map<Key, std::size_t> unused;
    for (std::size_t k = known_.size(); k-- > 0;) {
      if (!is_used_[k]) unused[{known_[k].code, known_[k].name.*name}] = k;
    }
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      if (is_known_[i]) continue;
      const auto found = unused.find({findings_[i].code, names_[i].*name});
      if (found == unused.end()) continue;
      is_known_[i] = true;
      is_used_[found->second] = true;
      unused.erase(found);
    }
  }

  std::vector<bool> take() { return std::move(is_known_); }

 private:
  const std::vector<KnownFinding>& known_;
  const std::vector<Finding>& findings_;
  const std::vector<Fingerprint>& names_;
  std::vector<bool> is_known_, is_used_;
};

}  // namespace

Result<Baseline> Baseline::parse(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    if (json.value("schema", "") != kSchema) {
      return input_failure("is no baseline: its schema is not " + std::string(kSchema));
    }
    Baseline baseline;
    for (const auto& map : json.at("maps")) {
      baseline.add(map.at("path").get<std::string>(), known_findings(map));
    }
    return baseline;
  } catch (const Json::exception& error) {
    return input_failure("is no baseline: " + std::string(error.what()));
  }
}

void Baseline::add(const std::string& path, std::vector<KnownFinding> findings) {
  maps_[path] = std::move(findings);
}

const std::vector<KnownFinding>& Baseline::findings(const std::string& path) const {
  static const std::vector<KnownFinding> kNone;
  const auto found = maps_.find(path);
  return found == maps_.end() ? kNone : found->second;
}

std::string Baseline::text() const {
  Json maps = Json::array();
  for (const auto& [path, findings] : maps_) {
    Json list = Json::array();
    for (const auto& known : findings) list.push_back(to_json(known));
    maps.push_back({{"path", path}, {"findings", std::move(list)}});
  }
  const Json json{{"schema", kSchema}, {"maps", std::move(maps)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<bool> known_among(const std::vector<KnownFinding>& known,
                              const std::vector<Finding>& findings,
                              const std::vector<Fingerprint>& names) {
  Matcher matcher(known, findings, names);
  matcher.match(&Fingerprint::place);
  matcher.match(&Fingerprint::subject);
  return matcher.take();
}

}  // namespace mapwright::validators
