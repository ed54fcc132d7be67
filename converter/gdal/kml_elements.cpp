#include "converter/gdal/kml_elements.hpp"

#include <string_view>
#include <utility>

#include "converter/gdal/xml_walk.hpp"

namespace mapwright::converter {
namespace {

bool is_container(std::string_view name) {
  return name == "kml" || name == "Document" || name == "Folder";
}

class ElementScan : public XmlWalk {
 public:
  KmlElements find(const std::string& path) {
    walk(path);
    return std::move(found_);
  }

 private:
  void begin(std::string_view element, Attributes) override {
    const auto name = local_name(element);
    if (is_container(name)) {
      holders_.push_back(found_.containers.size());
      found_.containers.emplace_back();
    } else if (!holders_.empty()) {
      take(name);
    }
    open_.emplace_back(name);
    text_.clear();
  }

  void take(std::string_view name) {
    auto& holder = container();
    if (name == "Placemark") holder.features.push_back(KmlFeature::kPlain);
    if (name == "GroundOverlay") holder.features.push_back(KmlFeature::kPicture);
    if (name == "Model" && !holder.features.empty()) holder.features.back() = KmlFeature::kModel;
    if (name == "NetworkLink") holder.links.emplace_back();
    if (name == "ScreenOverlay" || name == "PhotoOverlay") ++found_.passed_over[std::string(name)];
  }

  void end(std::string_view element) override {
    const auto name = local_name(element);
    open_.pop_back();
    if (holders_.empty()) return;
    if (is_container(name)) return holders_.pop_back();
    if (name == "name" && !open_.empty() && is_container(open_.back())) container().name = text_;
    if (name == "href" && is_within("NetworkLink")) container().links.back() = text_;
  }

  void text(std::string_view piece) override { text_ += piece; }

  bool is_within(std::string_view name) const {
    for (const auto& element : open_) {
      if (element == name) return true;
    }
    return false;
  }

  KmlContainer& container() { return found_.containers[holders_.back()]; }

  KmlElements found_;
  std::vector<std::size_t> holders_;  // positions of the containers that are open
  std::vector<std::string> open_;
  std::string text_;
};

}  // namespace

KmlElements kml_elements(const std::string& path) {
  return ElementScan().find(path);
}

}  // namespace mapwright::converter
