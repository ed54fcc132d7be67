// GeoPackages read by columns: what arrives is what GDAL's features hold.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "converter/gdal/vector_source.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

struct Read {
  std::vector<std::int64_t> ids;
  std::vector<std::vector<FieldValue>> values;
  std::vector<SourceGeometry> geometries;
};

// A condition is asked of GDAL's features, so with one they are made.
Read read_all(const std::string& path, const std::string& where,
              std::vector<std::string> fields = {}) {
  auto source = VectorSource::open(path, {});
  EXPECT_TRUE(source) << source.error().message;
  Read all;
  ReadOptions options;
  options.where = where;
  options.fields = std::move(fields);
  const auto count = source->read(0, options, [&](SourceFeature& feature) {
    all.ids.push_back(feature.fid);
    all.values.push_back(feature.values);
    all.geometries.push_back(feature.geometry);
  });
  EXPECT_TRUE(count) << count.error().message;
  return all;
}

void expect_same(const Read& columns, const Read& features) {
  EXPECT_EQ(columns.ids, features.ids);
  EXPECT_EQ(columns.values, features.values);
  ASSERT_EQ(columns.geometries.size(), features.geometries.size());
  for (std::size_t i = 0; i < columns.geometries.size(); ++i) {
    const auto& p = columns.geometries[i];
    const auto& q = features.geometries[i];
    EXPECT_EQ(p.type, q.type) << i;
    EXPECT_EQ(p.xs, q.xs) << i;
    EXPECT_EQ(p.ys, q.ys) << i;
    EXPECT_EQ(p.zs, q.zs) << i;
    ASSERT_EQ(p.paths.size(), q.paths.size()) << i;
    for (std::size_t k = 0; k < p.paths.size(); ++k) {
      EXPECT_EQ(p.paths[k].first, q.paths[k].first);
      EXPECT_EQ(p.paths[k].count, q.paths[k].count);
      EXPECT_EQ(p.paths[k].role, q.paths[k].role);
      EXPECT_EQ(p.paths[k].curved, q.paths[k].curved);
    }
  }
}

class Columns : public testing::Test {
 protected:
  Columns() : folder_(fs::path(testing::TempDir()) / ("columns_test_" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Columns() override { fs::remove_all(folder_); }

  std::string written(const std::vector<test::GisFeature>& features) const {
    const auto path = (folder_ / "site.gpkg").string();
    test::write_gis(path, "GPKG", {{"things", "EPSG:25831", features}});
    return path;
  }

  fs::path folder_;
};

const std::vector<test::GisFeature> kPlain{
    {"POINT (1 2)", {{"name", "a"}, {"height", "3.25"}}},
    {"LINESTRING (0 0,1 1,2 0.1)", {{"name", "Alçada"}}},
    {"POLYGON ((0 0,9 0,9 9,0 9,0 0),(1 1,1 2,2 2,1 1))", {{"height", "7"}, {"name", ""}}},
    {"MULTIPOINT (1 2,3 4)", {}},
    {"MULTILINESTRING ((0 0,1 1),(5 5,6 6,7 5))", {{"name", "two"}}},
    {"MULTIPOLYGON (((0 0,1 0,1 1,0 0)),((5 5,9 5,9 9,5 5),(6 5.5,8 5.5,8 7,6 5.5)))", {}},
    {"POLYGON Z ((0 0 1,9 0 2,9 9 3,0 0 1))", {{"height", "1"}}},
    {"LINESTRING M (0 0 5,1 1 6)", {}},
    {"POINT ZM (1 2 3 4)", {{"name", "last"}}}};

TEST_F(Columns, HoldWhatFeaturesHold) {
  const auto path = written(kPlain);
  const auto columns = read_all(path, "");
  EXPECT_EQ(columns.ids.size(), kPlain.size());
  expect_same(columns, read_all(path, "fid > 0"));
}

TEST_F(Columns, ReadOnlyTheFieldsAskedFor) {
  const auto path = written(kPlain);
  const auto columns = read_all(path, "", {"height"});
  EXPECT_EQ(columns.values[0][0], FieldValue(3.25));
  EXPECT_TRUE(is_null(columns.values[0][1])) << "nobody asked for the name";
}

// More rows than a batch, among them what columns leave to features: the rest is read as features,
// each once and in order.
TEST_F(Columns, GiveWayToFeaturesWhereTheyMust) {
  const std::vector<test::GisFeature> odd{
      {"", {{"name", "nowhere"}}},
      {"CURVEPOLYGON (CIRCULARSTRING (0 0,4 0,4 4,0 4,0 0))", {}},
      {"POLYGON EMPTY", {}},
      {"POINT EMPTY", {}},
      {"GEOMETRYCOLLECTION (POINT (1 2),LINESTRING (0 0,1 1))", {}},
      {"TIN (((0 0,1 0,0 1,0 0)))", {}}};
  for (const auto& one : odd) {
    std::vector<test::GisFeature> features;
    for (int i = 0; i < 500; ++i) features.insert(features.end(), kPlain.begin(), kPlain.end());
    features.insert(features.begin() + 4300, one);
    const auto path = written(features);
    const auto columns = read_all(path, "");
    EXPECT_EQ(columns.ids.size(), features.size());
    expect_same(columns, read_all(path, "fid > 0"));
    fs::remove(path);
  }
}

void execute(const std::string& path, const std::vector<std::string>& statements) {
  const GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr, nullptr, nullptr));
  for (const auto& statement : statements) {
    dataset->ReleaseResultSet(dataset->ExecuteSQL(statement.c_str(), nullptr, nullptr));
  }
}

Result<std::size_t> count_of(const std::string& path, std::vector<std::int64_t>& ids) {
  auto source = VectorSource::open(path, {});
  EXPECT_TRUE(source);
  return source->read(0, {}, [&](SourceFeature& feature) { ids.push_back(feature.fid); });
}

// Where rows are fewer than the database's own count of them, which programs without its triggers
// leave behind, GDAL takes them for numbered without holes and hands the last one out again.
TEST_F(Columns, ReadNoRowTwice) {
  const auto path = written(kPlain);
  execute(path,
          {"DELETE FROM things WHERE fid = 3", "UPDATE gpkg_ogr_contents SET feature_count = 9"});
  std::vector<std::int64_t> ids;
  const auto count = count_of(path, ids);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2, 4, 5, 6, 7, 8, 9}));
  ASSERT_FALSE(count);
  EXPECT_NE(count.error().message.find("declares 9 features"), std::string::npos)
      << count.error().message;
}

// As many rows as the last one's number, and one of them is 0.
TEST_F(Columns, LeaveNoRowOut) {
  const auto path = written(kPlain);
  execute(path, {"UPDATE things SET fid = 0 WHERE fid = 3"});
  std::vector<std::int64_t> ids;
  EXPECT_TRUE(count_of(path, ids));
  EXPECT_EQ(ids, (std::vector<std::int64_t>{0, 1, 2, 4, 5, 6, 7, 8, 9}));
}

// With holes in the numbering of rows GDAL fills the columns by another query.
TEST_F(Columns, DoNotMindMissingRows) {
  std::vector<test::GisFeature> features;
  for (int i = 0; i < 500; ++i) features.insert(features.end(), kPlain.begin(), kPlain.end());
  const auto path = written(features);
  {
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(
        path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr, nullptr, nullptr));
    for (const GIntBig id : {1, 700, 701, 4300}) {
      ASSERT_EQ(dataset->GetLayer(0)->DeleteFeature(id), OGRERR_NONE);
    }
  }
  const auto columns = read_all(path, "");
  EXPECT_EQ(columns.ids.size(), features.size() - 4);
  expect_same(columns, read_all(path, "fid > 0"));
}

}  // namespace
}  // namespace mapwright::converter
