#include "tests/sources/suites.hpp"

#include <geos_c.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

namespace mapwright::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_areal(const std::string& wkt) {
  return wkt.rfind("POLYGON", 0) == 0 || wkt.rfind("MULTIPOLYGON", 0) == 0;
}

// One line, no blanks at the ends.
std::string tidy(const std::string& text) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
}

// Faces are laid out in rows, so that none covers another: all but a few are smaller.
constexpr double kSpacing = 256.0;
constexpr std::size_t kColumns = 300;

// A vertex of a polyhedron, and a face as rings of vertices.
using Vertex = std::array<double, 3>;
using Face = std::vector<std::vector<Vertex>>;

// The pair of axes in which the face's outer ring is largest (Newell's normal).
std::pair<std::size_t, std::size_t> axes_of(const Face& face) {
  std::array<double, 3> normal{};
  const auto& ring = face.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& p = ring[i];
    const auto& q = ring[(i + 1) % ring.size()];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] += (p[u] - q[u]) * (p[v] + q[v]);
    }
  }
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(normal[k]) > std::abs(normal[largest])) largest = k;
  }
  return {(largest + 1) % 3, (largest + 2) % 3};
}

std::string wkt_of(const Face& face, std::size_t number) {
  const auto [u, v] = axes_of(face);
  const double right = kSpacing * static_cast<double>(number % kColumns);
  const double up = kSpacing * static_cast<double>(number / kColumns);
  std::ostringstream out;
  out.precision(12);
  out << "POLYGON (";
  for (std::size_t r = 0; r < face.size(); ++r) {
    out << (r == 0 ? "(" : ",(");
    for (std::size_t i = 0; i <= face[r].size(); ++i) {
      const auto& p = face[r][i % face[r].size()];
      out << (i == 0 ? "" : ",") << right + (p[u] - face[0][0][u]) << " "
          << up + (p[v] - face[0][0][v]);
    }
    out << ")";
  }
  out << ")";
  return out.str();
}

// TetGen's .poly: vertices; then for each facet its polygons and holes, of which the outer ring
// comes first.
std::vector<Face> faces_of(const fs::path& poly) {
  std::istringstream in(std::regex_replace(text_of(poly), std::regex("#[^\n]*"), ""));
  std::size_t vertices = 0, ignored = 0, facets = 0;
  in >> vertices >> ignored >> ignored >> ignored;
  std::map<std::size_t, Vertex> places;
  for (std::size_t i = 0; i < vertices; ++i) {
    std::size_t id = 0;
    in >> id;
    for (auto& coordinate : places[id]) in >> coordinate;
  }
  in >> facets >> ignored;
  std::vector<Face> faces;
  for (std::size_t f = 0; f < facets && in; ++f) {
    std::string line;
    while (std::getline(in >> std::ws, line) && line.empty()) {
    }
    std::istringstream head(line);
    std::size_t polygons = 0, holes = 0;
    head >> polygons >> holes;
    Face face;
    for (std::size_t p = 0; p < polygons && in; ++p) {
      std::size_t corners = 0;
      in >> corners;
      auto& ring = face.emplace_back();
      for (std::size_t c = 0; c < corners && in; ++c) {
        std::size_t id = 0;
        in >> id;
        ring.push_back(places[id]);
      }
    }
    std::getline(in, line);
    for (std::size_t h = 0; h < holes; ++h) std::getline(in, line);
    if (!face.empty() && face.front().size() > 2) faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace

bool is_valid_by_geos(const std::string& wkt) {
  auto* context = GEOS_init_r();
  auto* reader = GEOSWKTReader_create_r(context);
  auto* geometry = GEOSWKTReader_read_r(context, reader, wkt.c_str());
  const bool valid = geometry != nullptr && GEOSisValid_r(context, geometry) == 1;
  if (geometry != nullptr) GEOSGeom_destroy_r(context, geometry);
  GEOSWKTReader_destroy_r(context, reader);
  GEOS_finish_r(context);
  return valid;
}

std::vector<SuiteCase> geos_validity_cases(const fs::path& xml) {
  pugi::xml_document document;
  document.load_file(xml.c_str());
  std::vector<SuiteCase> cases;
  for (const auto& found : document.select_nodes("//case[test/op/@name='isValid']")) {
    const auto node = found.node();
    const auto wkt = tidy(node.child("a").text().get());
    if (!is_areal(wkt)) continue;
    const auto verdict = tidy(node.select_node("test/op[@name='isValid']").node().text().get());
    cases.push_back({tidy(node.child("desc").text().get()), wkt, verdict == "true"});
  }
  return cases;
}

// "select 3, valid, … ('POLYGON …'" asks; "3|f|…" answers.
std::vector<SuiteCase> postgis_validity_cases(const fs::path& folder) {
  std::map<std::string, bool> verdicts;
  std::istringstream answers(text_of(folder / "isvaliddetail_expected"));
  for (std::string line; std::getline(answers, line);) {
    const auto bar = line.find('|');
    if (bar != line.npos) verdicts.try_emplace(line.substr(0, bar), line[bar + 1] == 't');
  }
  std::vector<SuiteCase> cases;
  const std::string sql = text_of(folder / "isvaliddetail.sql");
  const std::regex question(R"(select (\d+), valid[^;]*?'((?:MULTI)?POLYGON[^']*)'([^;]*);)",
                            std::regex::icase);
  for (std::sregex_iterator found(sql.begin(), sql.end(), question), end; found != end; ++found) {
    const bool esri = std::regex_search((*found)[3].str(), std::regex(R"(,\s*1\s)"));
    const auto verdict = verdicts.find((*found)[1]);
    if (esri || verdict == verdicts.end()) continue;  // the flag asks for another standard
    cases.push_back({"select " + (*found)[1].str(), tidy((*found)[2]), verdict->second});
  }
  return cases;
}

std::vector<SuiteCase> val3dity_faces(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".poly") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<SuiteCase> cases;
  for (const auto& file : files) {
    std::size_t number = 0;
    for (const auto& face : faces_of(file)) {
      const auto wkt = wkt_of(face, cases.size());
      cases.push_back(
          {file.stem().string() + " face " + std::to_string(number++), wkt, is_valid_by_geos(wkt)});
    }
  }
  return cases;
}

}  // namespace mapwright::test
