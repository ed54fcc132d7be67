// The authoring template: what GDAL finds in it, and that styles and value lists agree.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <set>

#include "converter/authoring/site_template.hpp"
#include "converter/authoring/template_layers.hpp"
#include "converter/authoring/template_style.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

class Template : public testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    folder_ = fs::temp_directory_path() / ("mapwright_template_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    site_.georeference.origin_latitude_deg = 41.389;
    site_.georeference.origin_longitude_deg = 2.113;
    site_.georeference.heading_deg = 340.0;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string written(const char* name) {
    const std::string path = folder_ / name;
    const auto done = write_site_template(path, site_);
    EXPECT_TRUE(done) << done.error().message;
    return path;
  }

  static GDALDatasetUniquePtr opened(const std::string& path) {
    return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  }

  static std::string bytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
  SiteTemplate site_;
};

TEST_F(Template, HoldsItsLayersWithDefaultsAndDomains) {
  const auto dataset = opened(written("site.gpkg"));
  ASSERT_NE(dataset, nullptr);
  for (const auto& layer : template_layers()) {
    auto* found = dataset->GetLayerByName(std::string(layer.name).c_str());
    ASSERT_NE(found, nullptr) << layer.name;
    for (const auto& field : layer.fields) {
      const int i = found->GetLayerDefn()->GetFieldIndex(std::string(field.name).c_str());
      ASSERT_GE(i, 0) << layer.name << "." << field.name;
      const auto* definition = found->GetLayerDefn()->GetFieldDefn(i);
      if (field.domain != nullptr) {
        EXPECT_EQ(definition->GetDomainName(), field.domain->name);
        EXPECT_NE(dataset->GetFieldDomain(definition->GetDomainName()), nullptr);
      }
      EXPECT_EQ(definition->GetDefault() != nullptr, !field.initial.empty()) << field.name;
    }
  }
}

TEST_F(Template, DrawsTheBorderTurnedAndSaysWhereTheMapLies) {
  site_.width_m = 300.0;
  site_.height_m = 100.0;
  const auto dataset = opened(written("site.gpkg"));
  const OGRFeatureUniquePtr border(dataset->GetLayerByName("border")->GetNextFeature());
  ASSERT_NE(border, nullptr);
  EXPECT_DOUBLE_EQ(border->GetFieldAsDouble("origin_lat"), 41.389);
  EXPECT_DOUBLE_EQ(border->GetFieldAsDouble("heading"), 340.0);
  EXPECT_STREQ(border->GetFieldAsString("frame"), "tmerc");
  const auto& ring = *border->GetGeometryRef()->toPolygon()->getExteriorRing();
  // +y points 20 degrees west of north, so the lower right corner is (150, -50) turned by 20.
  EXPECT_NEAR(ring.getX(1), 150 * std::cos(20 * M_PI / 180) + 50 * std::sin(20 * M_PI / 180), 1e-6);
  EXPECT_NEAR(ring.getY(1), 150 * std::sin(20 * M_PI / 180) - 50 * std::cos(20 * M_PI / 180), 1e-6);
  EXPECT_NEAR(border->GetGeometryRef()->toPolygon()->get_Area(), 30000.0, 1e-3);
}

TEST_F(Template, IsTheSameBytesEveryTime) {
  EXPECT_EQ(bytes(written("one.gpkg")), bytes(written("two.gpkg")));
}

TEST_F(Template, IsDrawnInTheCrsAskedFor) {
  const auto crs = parse_crs("EPSG:25831");
  ASSERT_TRUE(crs);
  site_.crs = *crs;
  const auto dataset = opened(written("site.gpkg"));
  const auto* reference = dataset->GetLayerByName("walls")->GetSpatialRef();
  EXPECT_STREQ(reference->GetAuthorityCode(nullptr), "25831");
  OGREnvelope box;
  ASSERT_EQ(dataset->GetLayerByName("border")->GetExtent(&box), OGRERR_NONE);
  EXPECT_NEAR(0.5 * (box.MinX + box.MaxX), 425844.0, 50.0);
}

TEST_F(Template, FailsWhereNothingCanBeWritten) {
  const auto done = write_site_template(folder_ / "missing" / "site.gpkg", site_);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().kind, FailureKind::kOutput);
}

TEST(TemplateStyle, HasASymbolForEveryListedKindAndOneForOthers) {
  for (const auto& layer : template_layers()) {
    pugi::xml_document style;
    ASSERT_TRUE(style.load_string(template_style(layer).c_str())) << layer.name;
    const auto renderer = style.child("qgis").child("renderer-v2");
    if (renderer.attribute("type").value() != std::string("categorizedSymbol")) continue;
    std::set<std::string> categories;
    for (const auto category : renderer.child("categories")) {
      categories.insert(category.attribute("value").value());
    }
    for (const auto& field : layer.fields) {
      if (field.name != renderer.attribute("attr").value()) continue;
      ASSERT_NE(field.domain, nullptr);
      EXPECT_EQ(categories.size(), field.domain->values.size() + 1) << layer.name;
      for (const auto& listed : field.domain->values) {
        EXPECT_EQ(categories.count(std::string(listed.value)), 1u) << layer.name << listed.value;
      }
      EXPECT_EQ(categories.count(""), 1u) << "what no list knows must be drawn too";
    }
  }
}

TEST(TemplateStyle, OffersValueListsAndLimitsInTheForm) {
  for (const auto& layer : template_layers()) {
    pugi::xml_document style;
    ASSERT_TRUE(style.load_string(template_style(layer).c_str()));
    const auto form = style.child("qgis").child("fieldConfiguration");
    for (const auto& field : layer.fields) {
      const auto widget =
          form.find_child_by_attribute("name", std::string(field.name).c_str()).child("editWidget");
      const std::string expected = field.domain == nullptr         ? "TextEdit"
                                   : !field.domain->values.empty() ? "ValueMap"
                                                                   : "Range";
      EXPECT_EQ(widget.attribute("type").value(), expected) << layer.name << "." << field.name;
    }
  }
}

}  // namespace
}  // namespace mapwright::converter
