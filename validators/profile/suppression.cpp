#include "validators/profile/suppression.hpp"

#include <fnmatch.h>

#include <algorithm>

namespace mapwright::validators {
namespace {

bool matches_part(const std::string& glob, const std::string& path) {
  return ::fnmatch(glob.c_str(), path.c_str(), FNM_PATHNAME) == 0;
}

// "**/rest": at the path itself, or below any of its folders.
bool matches_from(std::string_view glob, std::string_view path) {
  const auto stars = glob.find("**/");
  if (stars == glob.npos) return matches_part(std::string(glob), std::string(path));
  const auto head = glob.substr(0, stars);
  const auto head_folders = static_cast<std::size_t>(std::count(head.begin(), head.end(), '/'));
  std::size_t at = 0;
  for (std::size_t i = 0; i < head_folders && at != path.npos; ++i) {
    at = path.find('/', at);
    if (at != path.npos) ++at;
  }
  if (at == path.npos) return false;
  if (!matches_part(std::string(head), std::string(path.substr(0, at)))) return false;
  while (true) {
    if (matches_from(glob.substr(stars + 3), path.substr(at))) return true;
    at = path.find('/', at);
    if (at == path.npos) return false;
    ++at;
  }
}

}  // namespace

bool glob_matches(std::string_view glob, std::string_view path) {
  if (glob.find('/') == glob.npos) path = path.substr(path.rfind('/') + 1);
  return matches_from(glob, path);
}

bool covers(const Suppression& suppression, const Candidate& candidate) {
  const auto& [finding, name, path] = candidate;
  const auto& codes = suppression.codes;
  if (std::find(codes.begin(), codes.end(), finding.code) == codes.end()) return false;
  if (suppression.obstacle && suppression.obstacle != finding.obstacle) return false;
  if (suppression.segment && suppression.segment != finding.segment) return false;
  if (suppression.region && !(finding.at && suppression.region->contains(*finding.at))) {
    return false;
  }
  const auto& wanted = suppression.fingerprint;
  if (!wanted.empty() && wanted != name.place && wanted != name.subject) return false;
  return suppression.path.empty() || glob_matches(suppression.path, path);
}

bool has_expired(const Suppression& suppression, Date today) {
  return suppression.until && *suppression.until < today;
}

}  // namespace mapwright::validators
