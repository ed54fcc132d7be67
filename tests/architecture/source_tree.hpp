// The project's sources as a graph of includes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mapwright::test {

struct SourceFile {
  std::string text;
  std::vector<std::string> project_includes;  ///< between quotes, as paths from the project's root
  std::vector<std::string> system_includes;   ///< between angle brackets

  /// Headers that begin with "// Private to this folder" are not installed, and only files of their
  /// own folder include them.
  bool is_private() const;
};

/// Path from the root, with '/', to file.
using SourceTree = std::map<std::string, SourceFile>;

SourceFile parse_source(const std::string& text);

/// All .hpp, .cpp and .def files of the product's folders below `root`.
SourceTree read_source_tree(const std::filesystem::path& root);

// Each returns one sentence a breach; none if the tree keeps the rule.

/// Folders include only what the architecture lets them (docs/architecture.md).
std::vector<std::string> forbidden_arrows(const SourceTree& tree);

/// Headers of the libraries that are not private name no type of GDAL, CGAL, GeographicLib, Boost,
/// Cairo or yaml-cpp; CGAL is included by .cpp files only.
std::vector<std::string> third_party_in_headers(const SourceTree& tree);

/// Private headers are included from their own folder only.
std::vector<std::string> leaked_private_headers(const SourceTree& tree);

/// No file includes itself by way of others.
std::vector<std::string> include_cycles(const SourceTree& tree);

/// Every include between quotes is a file of the project, named by its path from the root.
std::vector<std::string> unknown_includes(const SourceTree& tree);

}  // namespace mapwright::test
