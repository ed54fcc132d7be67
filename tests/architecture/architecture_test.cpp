// The house keeps its plan: docs/architecture.md as tests.
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.hpp"

namespace mapwright::test {
namespace {

using Breaches = std::vector<std::string>;

const SourceTree& project() {
  static const SourceTree tree = read_source_tree(MAPWRIGHT_SOURCE_DIR);
  return tree;
}

SourceTree tree_of(const std::map<std::string, std::string>& texts) {
  SourceTree tree;
  for (const auto& [path, text] : texts) tree[path] = parse_source(text);
  return tree;
}

TEST(Architecture, TheTreeIsThere) {
  EXPECT_GT(project().size(), 50U);
  EXPECT_TRUE(project().count("mapcore/map.hpp"));
}

TEST(Architecture, ArrowsPointOneWay) {
  EXPECT_EQ(forbidden_arrows(project()), Breaches{});
}

TEST(Architecture, PublicHeadersNameNoThirdPartyType) {
  EXPECT_EQ(third_party_in_headers(project()), Breaches{});
}

TEST(Architecture, PrivateHeadersStayInTheirFolder) {
  EXPECT_EQ(leaked_private_headers(project()), Breaches{});
}

TEST(Architecture, NoIncludeGoesInACircle) {
  EXPECT_EQ(include_cycles(project()), Breaches{});
}

TEST(Architecture, IncludesNameFilesFromTheRoot) {
  EXPECT_EQ(unknown_includes(project()), Breaches{});
}

// The rules themselves, on small trees that break them.

TEST(ArchitectureRules, SeeAnArrowThatRunsBack) {
  const auto tree = tree_of({{"mapcore/a.cpp", "#include \"navcore/b.hpp\"\n"},
                             {"navcore/b.hpp", "#include \"mapcore/c.hpp\"\n"},
                             {"converter/d.cpp", "#include \"validators/e.hpp\"\n"}});
  EXPECT_EQ(
      forbidden_arrows(tree),
      (Breaches{"converter/d.cpp includes validators/e.hpp: converter must not use validators",
                "mapcore/a.cpp includes navcore/b.hpp: mapcore must not use navcore"}));
}

TEST(ArchitectureRules, LetArrowsRunForward) {
  const auto tree = tree_of({{"validators/a.cpp", "#include \"navcore/b.hpp\"\n"},
                             {"cli/b.cpp", "#include \"converter/c.hpp\"\n"}});
  EXPECT_EQ(forbidden_arrows(tree), Breaches{});
}

TEST(ArchitectureRules, SeeThirdPartyTypesInPublicHeaders) {
  const auto tree = tree_of({{"converter/a.hpp", "#include <gdal_priv.h>\n"},
                             {"converter/b.hpp", "class OGRLayer;\n"},
                             {"navcore/c.hpp", "boost::optional<int> i;\n"}});
  EXPECT_EQ(third_party_in_headers(tree),
            (Breaches{"converter/a.hpp includes <gdal_priv.h>", "converter/b.hpp names OGRLayer",
                      "navcore/c.hpp names boost::"}));
}

TEST(ArchitectureRules, LetSourcesPrivateHeadersAndCommentsNameThem) {
  const auto tree = tree_of({{"converter/a.cpp", "#include <gdal_priv.h>\n"},
                             {"converter/b.hpp", "// Private to this folder: x\nclass OGRLayer;\n"},
                             {"cli/verb.hpp", "#include <boost/program_options.hpp>\n"},
                             {"navcore/c.hpp", "/// Like boost::optional.\n"}});
  EXPECT_EQ(third_party_in_headers(tree), Breaches{});
}

TEST(ArchitectureRules, SeeCgalInAnyHeader) {
  const auto tree =
      tree_of({{"mapcore/a.hpp", "// Private to this folder: x\n#include <CGAL/Point_2.h>\n"}});
  EXPECT_EQ(third_party_in_headers(tree), Breaches{"mapcore/a.hpp includes <CGAL/Point_2.h>"});
}

TEST(ArchitectureRules, SeeAPrivateHeaderThatLeaks) {
  const std::string secret = "// Private to this folder: x\n";
  const auto tree = tree_of({{"converter/gdal/secret.hpp", secret},
                             {"converter/gdal/a.cpp", "#include \"converter/gdal/secret.hpp\"\n"},
                             {"converter/gdal/b.hpp", "#include \"converter/gdal/secret.hpp\"\n"},
                             {"converter/c.cpp", "#include \"converter/gdal/secret.hpp\"\n"}});
  EXPECT_EQ(leaked_private_headers(tree),
            (Breaches{"converter/c.cpp includes the private converter/gdal/secret.hpp",
                      "converter/gdal/b.hpp includes the private converter/gdal/secret.hpp"}));
}

TEST(ArchitectureRules, SeeACircle) {
  const auto tree = tree_of({{"mapcore/a.hpp", "#include \"mapcore/b.hpp\"\n"},
                             {"mapcore/b.hpp", "#include \"mapcore/c.hpp\"\n"},
                             {"mapcore/c.hpp", "#include \"mapcore/b.hpp\"\n"}});
  EXPECT_EQ(include_cycles(tree),
            Breaches{"cycle: mapcore/b.hpp -> mapcore/c.hpp -> mapcore/b.hpp"});
}

TEST(ArchitectureRules, SeeAnIncludeOfNoFile) {
  const auto tree = tree_of({{"mapcore/a.cpp", "#include \"a.hpp\"\n"}});
  EXPECT_EQ(unknown_includes(tree),
            Breaches{"mapcore/a.cpp includes \"a.hpp\", which is no file of the project"});
}

}  // namespace
}  // namespace mapwright::test
