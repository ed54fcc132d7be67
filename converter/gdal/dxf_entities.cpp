#include "converter/gdal/dxf_entities.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>

#include "converter/gdal/dxf_lines.hpp"
#include "converter/gdal/stored_file.hpp"

namespace mapwright::converter {
namespace {

// Those that GDAL 3.6 makes features of (ogr/ogrsf_frmts/dxf), and what belongs to another entity.
constexpr std::array<std::string_view, 27> kRead{
    "POINT",     "LINE",   "LWPOLYLINE", "POLYLINE",    "VERTEX", "SEQEND", "MLINE",
    "CIRCLE",    "ARC",    "ELLIPSE",    "SPLINE",      "HELIX",  "SOLID",  "TRACE",
    "3DFACE",    "HATCH",  "TEXT",       "MTEXT",       "ATTDEF", "ATTRIB", "INSERT",
    "DIMENSION", "LEADER", "MLEADER",    "MULTILEADER", "BLOCK",  "ENDBLK"};

// Lettering, images, views, lights and construction lines without end.
constexpr std::array<std::string_view, 20> kHarmless{"VIEWPORT",
                                                     "WIPEOUT",
                                                     "IMAGE",
                                                     "RAY",
                                                     "XLINE",
                                                     "OLEFRAME",
                                                     "OLE2FRAME",
                                                     "ACAD_TABLE",
                                                     "TOLERANCE",
                                                     "LIGHT",
                                                     "SUN",
                                                     "SECTION",
                                                     "CAMERA",
                                                     "PDFUNDERLAY",
                                                     "DWFUNDERLAY",
                                                     "RTEXT",
                                                     "DGNUNDERLAY",
                                                     "ARC_DIMENSION",
                                                     "LARGE_RADIAL_DIMENSION",
                                                     "POSITIONMARKER"};

template <std::size_t N>
bool is_in(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct Entity {
  std::string_view type, layer = "0", block = {};  // `block`: that an INSERT inserts
  bool on_paper = false;
};

struct Block {
  bool is_external = false;  // lies in another file
  std::vector<Entity> entities;
};

constexpr long kExternalBits = 4 + 8;  // of a block's flags: reference, overlay

class Drawing {
 public:
  explicit Drawing(std::string_view text) : lines_(text) {
    while (const auto pair = lines_.next()) take(*pair);
  }

  UnreadEntities unread() {
    UnreadEntities found;
    std::map<std::string_view, std::size_t> passed_over;
    for (const auto& entity : entities_) {
      if (entity.on_paper) continue;
      if (is_in(kHarmless, entity.type)) ++passed_over[entity.type];
      if (auto why = loss_of(entity, 0)) {
        found.lost.push_back({std::string(entity.layer), *std::move(why)});
      }
    }
    for (const auto& [type, count] : passed_over) {
      found.passed_over.push_back(std::to_string(count) + " " + std::string(type));
    }
    return found;
  }

 private:
  void take(const DxfPair& pair) {
    if (pair.code == 0) return begin(pair.value);
    if (section_.empty() && pair.code == 2 && begins_section_) {
      section_ = pair.value;
    } else if (entity_ == nullptr) {
      take_of_block(pair);
    } else if (pair.code == 8) {
      entity_->layer = pair.value;
    } else if (pair.code == 2 && entity_->type == "INSERT") {
      entity_->block = pair.value;
    } else if (pair.code == 67) {
      entity_->on_paper = pair.value == "1";
    }
  }

  void take_of_block(const DxfPair& pair) {
    if (!begins_block_) return;
    if (pair.code == 2) block_ = &blocks_[std::string(pair.value)];
    if (pair.code == 70) flags_ = std::strtol(std::string(pair.value).c_str(), nullptr, 10);
    if (block_ != nullptr && (flags_ & kExternalBits) != 0) block_->is_external = true;
  }

  void begin(std::string_view name) {
    begins_section_ = name == "SECTION";
    begins_block_ = section_ == "BLOCKS" && name == "BLOCK";
    entity_ = nullptr;
    if (begins_section_ || name == "ENDSEC") section_ = {};
    if (begins_block_ || name == "ENDBLK") {
      block_ = nullptr;
      flags_ = 0;
    } else if (section_ == "ENTITIES") {
      entity_ = &entities_.emplace_back(Entity{name});
    } else if (section_ == "BLOCKS" && block_ != nullptr) {
      entity_ = &block_->entities.emplace_back(Entity{name});
    }
  }

  // Why something of it is missing; nothing if all of it is read. Blocks insert blocks.
  std::optional<std::string> loss_of(const Entity& entity, int depth) {
    if (is_in(kHarmless, entity.type)) return std::nullopt;
    if (!is_in(kRead, entity.type)) {
      return "a " + std::string(entity.type) +
             " cannot be read: explode it, or draw its outline with lines";
    }
    constexpr int kDeepest = 16;  // of blocks within each other, which GDAL limits too
    if (entity.type != "INSERT" || depth == kDeepest) return std::nullopt;
    const std::string name(entity.block);
    const bool is_new = losses_.try_emplace(name).second;  // ends circles too
    if (is_new) losses_[name] = loss_of_block(name, depth);
    return losses_[name];
  }

  std::optional<std::string> loss_of_block(const std::string& name, int depth) {
    const auto found = blocks_.find(name);
    if (found == blocks_.end() || found->second.is_external) {
      return "the block '" + name +
             "' that it inserts is not in the drawing: bind external references";
    }
    for (const auto& part : found->second.entities) {
      if (auto why = loss_of(part, depth + 1)) return "in the block '" + name + "' " + *why;
    }
    return std::nullopt;
  }

  DxfLines lines_;
  std::string_view section_;
  bool begins_section_ = false, begins_block_ = false;
  std::map<std::string, Block> blocks_;
  std::map<std::string, std::optional<std::string>> losses_;  // of blocks that were looked into
  std::vector<Entity> entities_;
  Block* block_ = nullptr;
  Entity* entity_ = nullptr;  // the one that pairs belong to
  long flags_ = 0;
};

}  // namespace

UnreadEntities unread_dxf_entities(const std::string& path) {
  const auto content = stored_content(path);
  return content ? Drawing(*content).unread() : UnreadEntities{};
}

}  // namespace mapwright::converter
