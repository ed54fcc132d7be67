#include "converter/gdal/geojson_shapes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

// The bytes of a file, a piece at a time. Those beyond ASCII matter to no shape, and files that are
// not UTF-8 are read as well: an x stands for each.
class AsciiBytes {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  AsciiBytes() = default;
  explicit AsciiBytes(const std::string& path) : source_(std::make_shared<Source>(path)) { fill(); }

  char operator*() const {
    const char byte = source_->bytes[at_];
    return static_cast<signed char>(byte) < 0 ? 'x' : byte;
  }
  AsciiBytes& operator++() {
    if (++at_ == size_) fill();
    return *this;
  }
  AsciiBytes operator++(int) {
    const AsciiBytes before = *this;
    ++*this;
    return before;
  }
  bool operator==(const AsciiBytes& other) const {
    return size_ == other.size_ && at_ == other.at_;
  }
  bool operator!=(const AsciiBytes& other) const { return !(*this == other); }

 private:
  struct Source {
    explicit Source(const std::string& path) : file(path) {}
    StoredFile file;
    std::array<char, 1U << 16U> bytes;
    std::uint64_t offset = 0;
  };

  // At the file's end it equals an iterator without a file.
  void fill() {
    at_ = 0;
    size_ = source_->file.read(source_->offset, source_->bytes.data(), source_->bytes.size());
    source_->offset += size_;
  }

  std::shared_ptr<Source> source_;
  std::size_t at_ = 0;
  std::size_t size_ = 0;
};

struct ShapeType {
  std::string_view name;
  int nesting;  // of the arrays around a position's numbers
};
constexpr std::array<ShapeType, 6> kTypes{{{"Point", 1},
                                           {"MultiPoint", 2},
                                           {"LineString", 2},
                                           {"MultiLineString", 3},
                                           {"Polygon", 3},
                                           {"MultiPolygon", 4}}};
constexpr std::string_view kCollection = "GeometryCollection";

// As GDAL does, whatever the case.
bool is_same(std::string_view p, std::string_view q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  });
}

enum class Key : std::uint8_t { kOther, kType, kFeatures, kGeometry, kCoordinates, kGeometries };
constexpr std::array<std::string_view, 6> kKeys{"",         "type",        "features",
                                                "geometry", "coordinates", "geometries"};

// An array or object whose end has not come. The outermost one may be a collection of features, a
// feature, or a shape.
struct Nest {
  enum Kind : std::uint8_t { kOther, kRoot, kFeatures, kFeature, kShapes, kShape, kCoordinates };
  Kind kind = kOther;
  Key key = Key::kOther;                  // of the member that comes, in an object
  std::uint32_t numbers = 0, arrays = 0;  // in an array of coordinates
};

// What the coordinates of a shape are like.
struct Shape {
  std::string type;
  bool has_coordinates = false;
  bool is_askew = false;  // not arrays of numbers, evenly nested
  int nesting = 0;        // of the positions, which are the innermost arrays; 0: there are none
  int of_empty = 0;       // greatest nesting of an array without anything
};

class ShapeScan : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return value(false, true); }
  bool boolean(bool) override { return value(false, false); }
  bool number_integer(number_integer_t) override { return value(true, false); }
  bool number_unsigned(number_unsigned_t) override { return value(true, false); }
  bool number_float(number_float_t, const string_t&) override { return value(true, false); }
  bool binary(binary_t&) override { return value(false, false); }
  bool string(string_t& text) override {
    const bool is_type =
        !nests_.empty() && nests_.back().key == Key::kType && is_shape(nests_.back());
    if (is_type) shapes_.back().type = text;
    return value(false, false);
  }
  bool key(string_t& name) override {
    const auto found = std::find(kKeys.begin() + 1, kKeys.end(), name);
    const auto place = found == kKeys.end() ? 0 : found - kKeys.begin();
    nests_.back().key = static_cast<Key>(place);
    return true;
  }
  bool start_object(std::size_t) override { return begin(kind_of_object()); }
  bool start_array(std::size_t) override { return begin(kind_of_array()); }
  bool end_object() override {
    const Nest ended = leave();
    if (is_shape(ended)) {
      const bool is_one = ended.kind == Nest::kShape || shapes_.back().has_coordinates;
      if (is_one) judge(shapes_.back());
      shapes_.pop_back();
    }
    if (ended.kind == Nest::kFeature) ++feature_;
    return true;
  }
  bool end_array() override {
    const Nest ended = leave();
    if (ended.kind != Nest::kCoordinates) return true;
    add_array(ended, shapes_.back());
    --depth_;
    return true;
  }
  // What is no JSON is GDAL's to say.
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

  std::map<std::size_t, std::string> broken;

 private:
  static bool is_shape(const Nest& nest) {
    return nest.kind == Nest::kShape || nest.kind == Nest::kRoot;
  }

  Nest::Kind kind_of_object() const {
    if (nests_.empty()) return Nest::kRoot;
    const Nest& around = nests_.back();
    const bool holds_feature = around.kind == Nest::kRoot || around.kind == Nest::kFeature;
    if (holds_feature && around.key == Key::kGeometry) return Nest::kShape;
    if (around.kind == Nest::kFeatures) return Nest::kFeature;
    return around.kind == Nest::kShapes ? Nest::kShape : Nest::kOther;
  }

  Nest::Kind kind_of_array() const {
    if (nests_.empty()) return Nest::kOther;
    const Nest& around = nests_.back();
    if (around.kind == Nest::kCoordinates) return Nest::kCoordinates;
    if (around.kind == Nest::kRoot && around.key == Key::kFeatures) return Nest::kFeatures;
    if (!is_shape(around)) return Nest::kOther;
    if (around.key == Key::kGeometries) return Nest::kShapes;
    return around.key == Key::kCoordinates ? Nest::kCoordinates : Nest::kOther;
  }

  bool begin(Nest::Kind kind) {
    if (!nests_.empty() && nests_.back().kind == Nest::kCoordinates) {
      ++nests_.back().arrays;
      if (kind != Nest::kCoordinates) shapes_.back().is_askew = true;
    }
    nests_.push_back({kind});
    if (is_shape(nests_.back())) shapes_.emplace_back();
    if (kind == Nest::kCoordinates && ++depth_ == 1) shapes_.back().has_coordinates = true;
    return true;
  }

  Nest leave() {
    const Nest ended = nests_.back();
    nests_.pop_back();
    return ended;
  }

  bool value(bool is_number, bool is_null) {
    if (nests_.empty()) return true;
    Nest& around = nests_.back();
    if (around.kind == Nest::kCoordinates) {
      is_number ? ++around.numbers : shapes_.back().is_askew = true;
    } else if (around.kind == Nest::kShapes) {
      tell("a part of its GeometryCollection is no geometry");
    } else if (around.kind == Nest::kFeature && around.key == Key::kGeometry && !is_null) {
      tell("its geometry is no object");
    }
    return true;
  }

  void add_array(const Nest& array, Shape& shape) const {
    if (array.numbers > 0) {
      const bool is_even = shape.nesting == 0 || shape.nesting == depth_;
      if (array.arrays > 0 || array.numbers < 2 || !is_even) shape.is_askew = true;
      shape.nesting = depth_;
    } else if (array.arrays == 0) {
      shape.of_empty = std::max(shape.of_empty, depth_);
    }
  }

  void judge(const Shape& shape) {
    if (is_same(shape.type, kCollection)) return;
    const auto type = std::find_if(kTypes.begin(), kTypes.end(), [&](const ShapeType& known) {
      return is_same(known.name, shape.type);
    });
    if (type == kTypes.end()) {
      tell(shape.type.empty() ? "its geometry has no type"
                              : "GeoJSON has no geometry of type '" + shape.type + "'");
    } else if (shape.is_askew || (shape.nesting > 0 && (shape.nesting != type->nesting ||
                                                        shape.of_empty >= type->nesting))) {
      tell("the coordinates of its geometry are not those of a " + std::string(type->name));
    }
  }

  void tell(std::string why) { broken.try_emplace(feature_, std::move(why)); }

  std::vector<Nest> nests_;
  std::vector<Shape> shapes_;
  int depth_ = 0;  // of arrays of coordinates, in each other
  std::size_t feature_ = 0;
};

}  // namespace

std::map<std::size_t, std::string> broken_shapes(const std::string& path) {
  ShapeScan scan;
  nlohmann::json::sax_parse(AsciiBytes(path), AsciiBytes(), &scan);
  return std::move(scan.broken);
}

}  // namespace mapwright::converter
