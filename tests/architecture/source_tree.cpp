#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace mapwright::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kFolders = {"mapcore", "navcore", "validators", "converter", "cli"};

// The architecture: which folder may include from which.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"mapcore", {"mapcore"}},
    {"navcore", {"navcore", "mapcore"}},
    {"converter", {"converter", "mapcore"}},
    {"validators", {"validators", "navcore", "mapcore"}},
    {"cli", {"cli", "converter", "validators", "navcore", "mapcore"}}};

// Made while building, so not in the tree.
const std::set<std::string> kGenerated = {"cli/version.hpp"};

const std::regex kThirdPartyHeader("(gdal|ogr|cpl_|CGAL/|GeographicLib/|boost/|cairo|yaml-cpp/).*",
                                   std::regex::optimize);
const std::regex kThirdPartyName(
    "\\b(OGR[A-Z]\\w*|GDAL[A-Z]\\w*|CGAL::|GeographicLib::|boost::|cairo_\\w+|YAML::)",
    std::regex::optimize);

std::string top_folder(const std::string& path) {
  return path.substr(0, path.find('/'));
}
std::string folder(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}
bool is_header(const std::string& path) {
  return path.size() > 4 && path.ends_with(".hpp");
}

// Comments may name a library; code may not.
std::string without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::string code;
  for (std::string line; std::getline(lines, line);) code += line.substr(0, line.find("//")) + '\n';
  return code;
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_source(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".hpp" || extension == ".cpp" || extension == ".def";
}

class CycleFinder {
 public:
  explicit CycleFinder(const SourceTree& tree) : tree_(tree) {}

  std::vector<std::string> find() {
    for (const auto& [path, file] : tree_) visit(path);
    return breaches_;
  }

 private:
  void visit(const std::string& path) {
    const auto file = tree_.find(path);
    if (file == tree_.end() || done_.count(path) > 0) return;
    const auto open = std::find(chain_.begin(), chain_.end(), path);
    if (open != chain_.end()) {
      std::string cycle;
      for (auto link = open; link != chain_.end(); ++link) cycle += *link + " -> ";
      breaches_.push_back("cycle: " + cycle + path);
      return;
    }
    chain_.push_back(path);
    for (const auto& include : file->second.project_includes) visit(include);
    chain_.pop_back();
    done_.insert(path);
  }

  const SourceTree& tree_;
  std::vector<std::string> chain_;
  std::set<std::string> done_;
  std::vector<std::string> breaches_;
};

}  // namespace

bool SourceFile::is_private() const {
  return text.starts_with("// Private to this folder");
}

SourceFile parse_source(const std::string& text) {
  static const std::regex include("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]");
  SourceFile file{text, {}, {}};
  std::istringstream lines(text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_search(line, match, include)) continue;
    auto& includes = match[1] == "\"" ? file.project_includes : file.system_includes;
    includes.push_back(match[2]);
  }
  return file;
}

SourceTree read_source_tree(const fs::path& root) {
  SourceTree tree;
  for (const auto& name : kFolders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / name)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      tree[fs::relative(entry.path(), root).generic_string()] =
          parse_source(read_text(entry.path()));
    }
  }
  return tree;
}

std::vector<std::string> forbidden_arrows(const SourceTree& tree) {
  std::vector<std::string> breaches;
  for (const auto& [path, file] : tree) {
    const auto& allowed = kMayInclude.at(top_folder(path));
    for (const auto& include : file.project_includes) {
      if (allowed.count(top_folder(include)) > 0) continue;
      breaches.push_back(path + " includes " + include + ": " + top_folder(path) +
                         " must not use " + top_folder(include));
    }
  }
  return breaches;
}

std::vector<std::string> third_party_in_headers(const SourceTree& tree) {
  std::vector<std::string> breaches;
  for (const auto& [path, file] : tree) {
    if (!is_header(path) || top_folder(path) == "cli") continue;
    for (const auto& include : file.system_includes) {
      const bool is_cgal = include.starts_with("CGAL/");
      if (!std::regex_match(include, kThirdPartyHeader) || (file.is_private() && !is_cgal))
        continue;
      breaches.push_back(path + " includes <" + include + ">");
    }
    std::smatch name;
    const std::string code = without_comments(file.text);
    if (!file.is_private() && std::regex_search(code, name, kThirdPartyName)) {
      breaches.push_back(path + " names " + name.str());
    }
  }
  return breaches;
}

std::vector<std::string> leaked_private_headers(const SourceTree& tree) {
  std::vector<std::string> breaches;
  for (const auto& [path, file] : tree) {
    for (const auto& include : file.project_includes) {
      const auto header = tree.find(include);
      if (header == tree.end() || !header->second.is_private()) continue;
      const bool leaks = folder(include) != folder(path);
      const bool is_public_header = is_header(path) && !file.is_private();
      if (leaks || is_public_header) breaches.push_back(path + " includes the private " + include);
    }
  }
  return breaches;
}

std::vector<std::string> include_cycles(const SourceTree& tree) {
  return CycleFinder(tree).find();
}

std::vector<std::string> unknown_includes(const SourceTree& tree) {
  std::vector<std::string> breaches;
  for (const auto& [path, file] : tree) {
    for (const auto& include : file.project_includes) {
      if (tree.count(include) > 0 || kGenerated.count(include) > 0) continue;
      breaches.push_back(path + " includes \"" + include + "\", which is no file of the project");
    }
  }
  return breaches;
}

}  // namespace mapwright::test
