#include "converter/detective/unstated_crs.hpp"

#include <algorithm>
#include <filesystem>

#include "converter/detective/crs_guesses.hpp"
#include "converter/detective/web_mercator.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLayers = 20;    // read
constexpr std::size_t kMostSiblings = 20;  // opened

bool has_places(const LayerInfo& layer) {
  return layer.geometry != GeometryKind::kNone;
}

// What is broken in a source is told when it is converted.
void collect(VectorSource& source, std::size_t layer, EvidenceCollector& collector) {
  const std::string& name = source.layers()[layer].name;
  ReadOptions reading;
  reading.keep_broken = true;
  const auto count = source.read(
      layer, reading, [&](SourceFeature& feature) { collector.add(name, feature.geometry); });
  (void)count;
}

DrawingEvidence evidence_of(const std::vector<std::unique_ptr<VectorSource>>& sources) {
  EvidenceCollector collector;
  std::size_t read = 0;
  for (const auto& source : sources) {
    for (std::size_t i = 0; i < source->layers().size() && read < kMostLayers; ++i) {
      const auto& layer = source->layers()[i];
      if (layer.crs.is_stated() || !has_places(layer)) continue;
      collect(*source, i, collector);
      ++read;
    }
  }
  return collector.evidence();
}

void append_stated(VectorSource& source, std::vector<Neighbour>& neighbours) {
  for (std::size_t i = 0; i < source.layers().size(); ++i) {
    const auto& layer = source.layers()[i];
    if (!layer.crs.is_stated() || !has_places(layer)) continue;
    const auto extent = source.extent(i);
    if (extent && *extent) neighbours.push_back({layer.name, layer.crs, **extent});
  }
}

// Shapefiles of the same folder, by name, but for the sources themselves.
std::vector<std::string> siblings_of(const std::vector<std::unique_ptr<VectorSource>>& sources) {
  std::vector<std::string> siblings;
  for (const auto& source : sources) {
    const fs::path path(source->path());
    std::error_code error;
    if (source->driver() != "ESRI Shapefile" || fs::is_directory(path, error)) continue;
    const auto folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const auto file = entry.path();
      auto reference = file;
      reference.replace_extension(".prj");
      if (file.extension() == ".shp" && file != path && fs::exists(reference, error)) {
        siblings.push_back(file.string());
      }
    }
  }
  std::sort(siblings.begin(), siblings.end());
  if (siblings.size() > kMostSiblings) siblings.resize(kMostSiblings);
  return siblings;
}

std::vector<Neighbour> neighbours_of(const std::vector<std::unique_ptr<VectorSource>>& sources) {
  std::vector<Neighbour> neighbours;
  for (const auto& source : sources) append_stated(*source, neighbours);
  for (const auto& path : siblings_of(sources)) {
    if (auto sibling = VectorSource::open(path, {})) append_stated(*sibling, neighbours);
  }
  return neighbours;
}

}  // namespace

std::string crs_advice(const std::vector<std::unique_ptr<VectorSource>>& sources) {
  const auto evidence = evidence_of(sources);
  return guesses_text(evidence, guess_crs(evidence, neighbours_of(sources)));
}

std::optional<std::string> doubt_about_stated_metres(VectorSource& source, const Crs& crs,
                                                     const Box& extent) {
  if (!may_be_utm(crs, extent)) return std::nullopt;
  EvidenceCollector collector;
  for (std::size_t i = 0; i < source.layers().size() && i < kMostLayers; ++i) {
    if (has_places(source.layers()[i])) collect(source, i, collector);
  }
  return doubt_about_web_mercator(extent, collector.evidence());
}

std::string crs_advice_instead(VectorSource& source, std::size_t layer) {
  EvidenceCollector collector;
  collect(source, layer, collector);
  const auto evidence = collector.evidence();
  auto text = guesses_text(evidence, guess_crs(evidence, {}));
  const std::string fallback = "--source-crs", instead = "--override-crs";
  for (auto at = text.find(fallback); at != text.npos; at = text.find(fallback, at)) {
    text.replace(at, fallback.size(), instead);
  }
  return text;
}

}  // namespace mapwright::converter
