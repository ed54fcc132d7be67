#include "converter/isolation/wire.hpp"

#include <algorithm>
#include <utility>

namespace mapwright::converter {
namespace {

// By the variant's alternatives, which are the same for values of features and of rows.
template <class Text>
void put_value(WireWriter& wire,
               const std::variant<std::monostate, std::int64_t, double, Text>& value) {
  wire.put(static_cast<std::uint8_t>(value.index()));
  if (const auto* whole = std::get_if<std::int64_t>(&value)) wire.put(*whole);
  if (const auto* number = std::get_if<double>(&value)) wire.put(*number);
  if (const auto* text = std::get_if<Text>(&value)) wire.put(*text);
}

// A text keeps its memory from feature to feature.
void get_value(WireReader& wire, FieldValue& value) {
  std::uint8_t kind = 0;
  wire.get(kind);
  switch (kind) {
    case 1:
      return wire.get(value.emplace<std::int64_t>());
    case 2:
      return wire.get(value.emplace<double>());
    case 3:
      if (!std::holds_alternative<std::string>(value)) value.emplace<std::string>();
      return wire.get(std::get<std::string>(value));
    default:
      value.emplace<std::monostate>();
  }
}

void put_crs(WireWriter& wire, const Crs& crs) {
  wire.put(crs.code);
  wire.put(crs.name);
  wire.put(crs.wkt);
  wire.put(crs.geographic);
  wire.put(crs.metres_per_unit);
}

void get_crs(WireReader& wire, Crs& crs) {
  wire.get(crs.code);
  wire.get(crs.name);
  wire.get(crs.wkt);
  wire.get(crs.geographic);
  wire.get(crs.metres_per_unit);
}

// What a feature's bytes begin with. The rarely needed texts come last, and only if there are any.
struct FeatureHead {
  std::int64_t fid = 0;
  std::uint32_t values = 0, points = 0, paths = 0;
  bool has_heights = false;
  bool selected = true;
  bool has_remarks = false;
};

bool has_remarks(const SourceFeature& feature) {
  return !feature.geometry.unsupported.empty() || !feature.broken.empty() ||
         !feature.lost.empty() || !feature.warnings.empty() || !feature.reencoded.empty();
}

}  // namespace

void WireWriter::grow(std::size_t bytes) {
  constexpr std::size_t kLeast = std::size_t{1} << 16U;
  const std::size_t capacity = std::max({kLeast, 2 * capacity_, size_ + bytes});
  std::unique_ptr<char[]> larger(new char[capacity]);
  if (size_ > 0) std::memcpy(larger.get(), at_, size_);
  buffer_ = std::move(larger);
  at_ = buffer_.get();
  capacity_ = capacity;
}

std::vector<std::uint32_t> sent_values(const LayerInfo& layer, const ReadOptions& options) {
  const auto& names = options.fields;
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < layer.fields.size(); ++i) {
    const bool wanted =
        names.empty() || std::find(names.begin(), names.end(), layer.fields[i]) != names.end();
    if (wanted) values.push_back(i);
  }
  return values;
}

void put(WireWriter& wire, const SourceFeature& feature, const std::vector<std::uint32_t>& values) {
  const auto& geometry = feature.geometry;
  const FeatureHead head{feature.fid,
                         static_cast<std::uint32_t>(values.size()),
                         static_cast<std::uint32_t>(geometry.xs.size()),
                         static_cast<std::uint32_t>(geometry.paths.size()),
                         !geometry.zs.empty(),
                         feature.selected,
                         has_remarks(feature)};
  wire.put(head);
  wire.put_values(geometry.xs);
  wire.put_values(geometry.ys);
  wire.put_values(geometry.zs);
  wire.put_values(geometry.paths);
  wire.put(geometry.type);
  for (const auto i : values) put_value(wire, feature.values[i]);
  if (!head.has_remarks) return;
  wire.put(geometry.unsupported);
  wire.put(feature.broken);
  wire.put(feature.lost);
  wire.put(feature.warnings);
  wire.put(feature.reencoded);
}

void put(WireWriter& wire, const FeatureRow& row, const std::vector<std::uint32_t>& values) {
  const auto& geometry = row.geometry;
  const std::uint32_t points = geometry.point_count();
  wire.put(FeatureHead{row.fid, static_cast<std::uint32_t>(values.size()), points,
                       static_cast<std::uint32_t>(geometry.paths.size()), geometry.has_heights});
  const std::size_t places = geometry.has_heights ? 3 : 2;
  char* at = wire.take_room(places * points * sizeof(double));
  for (std::size_t place = 0; place < places; ++place) at = copy_numbers(geometry, place, at);
  std::uint32_t first = 0;
  for (const auto& path : geometry.paths) {
    wire.put(SourcePath{first, path.count, path.role, false});
    first += path.count;
  }
  wire.put(geometry.type);
  std::size_t next = 0;
  for (const auto field : values) {
    while (next < row.fields.size() && row.fields[next] < field) ++next;
    const bool is_read = next < row.fields.size() && row.fields[next] == field;
    put_value(wire, is_read ? row.values[next] : RowValue());
  }
}

void get(WireReader& wire, SourceFeature& feature, const std::vector<std::uint32_t>& values) {
  FeatureHead head;
  wire.get(head);
  feature.fid = head.fid;
  feature.selected = head.selected;
  auto& geometry = feature.geometry;
  wire.get_values(geometry.xs, head.points);
  wire.get_values(geometry.ys, head.points);
  wire.get_values(geometry.zs, head.has_heights ? head.points : 0);
  wire.get_values(geometry.paths, head.paths);
  wire.check(std::all_of(geometry.paths.begin(), geometry.paths.end(), [&](const SourcePath& path) {
    return path.first <= head.points && path.count <= head.points - path.first;
  }));
  wire.get(geometry.type);
  wire.check(head.values == values.size());
  for (const auto i : values) get_value(wire, feature.values[i]);
  geometry.unsupported.clear();
  feature.broken.clear();
  feature.lost.clear();
  feature.warnings.clear();
  feature.reencoded.clear();
  if (!head.has_remarks) return;
  wire.get(geometry.unsupported);
  wire.get(feature.broken);
  wire.get(feature.lost);
  wire.get(feature.warnings);
  wire.get(feature.reencoded);
}

void put(WireWriter& wire, const std::vector<LayerInfo>& layers) {
  wire.put(static_cast<std::uint32_t>(layers.size()));
  for (const auto& layer : layers) {
    wire.put(layer.name);
    wire.put(layer.fields);
    wire.put(layer.geometry);
    put_crs(wire, layer.crs);
    wire.put(layer.several_crs);
    wire.put(layer.declared_features);
    wire.put(layer.metres_per_local_unit);
    wire.put(layer.lacks_attributes);
    wire.put(layer.is_view);
    wire.put(layer.storey);
    wire.put(layer.chains_lines);
  }
}

void get(WireReader& wire, std::vector<LayerInfo>& layers) {
  std::uint32_t count = 0;
  wire.get(count);
  for (std::uint32_t i = 0; i < count && wire.good(); ++i) {
    auto& layer = layers.emplace_back();
    wire.get(layer.name);
    wire.get(layer.fields);
    wire.get(layer.geometry);
    get_crs(wire, layer.crs);
    wire.get(layer.several_crs);
    wire.get(layer.declared_features);
    wire.get(layer.metres_per_local_unit);
    wire.get(layer.lacks_attributes);
    wire.get(layer.is_view);
    wire.get(layer.storey);
    wire.get(layer.chains_lines);
  }
}

void put(WireWriter& wire, const ReadOptions& options) {
  wire.put(options.where);
  wire.put(options.sagitta_m);
  wire.put(options.fields);
  wire.put(options.keep_broken);
}

void get(WireReader& wire, ReadOptions& options) {
  wire.get(options.where);
  wire.get(options.sagitta_m);
  wire.get(options.fields);
  wire.get(options.keep_broken);
}

void put(WireWriter& wire, const Failure& failure) {
  wire.put(failure.kind);
  wire.put(failure.message);
}

void get(WireReader& wire, Failure& failure) {
  wire.get(failure.kind);
  wire.get(failure.message);
}

}  // namespace mapwright::converter
