// Sources read in processes of their own: what arrives is what was read, and no end of the child is
// an end of ours.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <limits>

#include "converter/isolation/isolated_reader.hpp"

namespace mapwright::converter {
namespace {

// A reader that misbehaves on demand.
class FakeReader : public SourceReader {
 public:
  enum class Fault { kNone, kCrash, kHang, kSleep, kExit, kGreed, kThrow };

  explicit FakeReader(Fault fault) : fault_(fault) {
    LayerInfo layer;
    layer.name = "walls";
    layer.fields = {"height", "name"};
    layer.geometry = GeometryKind::kLine;
    layer.crs.code = "EPSG:25831";
    layer.crs.wkt = "PROJCRS[...]";
    layer.declared_features = 3000;
    layers_.push_back(layer);
  }

  const std::string& driver() const override { return driver_; }
  const std::vector<LayerInfo>& layers() const override { return layers_; }
  std::vector<std::string> take_warnings() override {
    return std::exchange(warnings_, std::vector<std::string>{});
  }
  Result<std::optional<Box>> extent(std::size_t) override { return Box{1.0, 2.0, 3.0, 4.0}; }

  Result<std::size_t> read(std::size_t, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    if (options.where == "wrong") return usage_failure("--where: wrong");
    SourceFeature feature;
    for (int i = 0; i < 3000; ++i) {
      if (i == 2000) misbehave();
      fill(feature, i);
      visit(feature);
    }
    warnings_.push_back("said at the end");
    return 3000;
  }

  static void fill(SourceFeature& feature, int i) {
    feature.fid = i - 10;
    feature.values = {FieldValue(0.25 * i), FieldValue(std::string("name ") + std::to_string(i))};
    if (i % 3 == 0) feature.values[0] = std::monostate();
    if (i % 3 == 1) feature.values[0] = std::int64_t{i};
    feature.geometry.clear();
    feature.geometry.type = "LINESTRING";
    feature.geometry.xs = {1.0 * i, std::numeric_limits<double>::infinity()};
    feature.geometry.ys = {-0.0, 1e300};
    feature.geometry.paths = {{0, 2, PathRole::kLine, true}};
    feature.warnings = i == 7 ? std::vector<std::string>{"a", ""} : std::vector<std::string>{};
    feature.reencoded = i == 8 ? std::vector<std::string>{"name"} : std::vector<std::string>{};
    feature.broken = i == 9 ? "cut" : "";
    feature.selected = i % 5 != 0;
  }

 private:
  void misbehave() const {
    switch (fault_) {
      case Fault::kNone:
        return;
      case Fault::kCrash:
        std::raise(SIGSEGV);
        return;
      case Fault::kHang:
        while (std::chrono::steady_clock::now().time_since_epoch().count() != 0) {
        }
        return;
      case Fault::kSleep:
        ::sleep(1000);
        return;
      case Fault::kExit:
        ::_exit(7);
      case Fault::kGreed: {
        std::vector<std::vector<char>> hoard;
        while (true) hoard.emplace_back(std::size_t{1} << 28U);
      }
      case Fault::kThrow:
        throw std::bad_alloc();
    }
  }

  Fault fault_;
  std::string driver_ = "FAKE";
  std::vector<LayerInfo> layers_;
  std::vector<std::string> warnings_{"said at the start"};
};

OpenedReader open(FakeReader::Fault fault) {
  return open_isolated("site.fake", 1000, [fault](const DriverNotice& notice) -> OpenedReader {
    notice("FAKE");
    return std::make_unique<FakeReader>(fault);
  });
}

// Only what is asked for goes from process to process.
TEST(IsolatedReader, HandsOverTheFieldsAskedFor) {
  auto reader = open(FakeReader::Fault::kNone);
  ASSERT_TRUE(reader);
  ReadOptions options;
  options.fields = {"name"};
  for (int round = 0; round < 2; ++round) {
    int i = 0;
    const auto count = (*reader)->read(0, options, [&](SourceFeature& feature) {
      SourceFeature expected;
      FakeReader::fill(expected, i++);
      ASSERT_EQ(feature.values.size(), 2U);
      EXPECT_EQ(feature.values[0].index(), 0U);
      EXPECT_EQ(feature.values[1], expected.values[1]);
    });
    EXPECT_EQ(count.value_or(0), 3000U);
    // What one reading asked for is not left to the next.
    ASSERT_TRUE((*reader)->read(0, {}, [](SourceFeature&) {}));
  }
}

TEST(IsolatedReader, HandsOverWhatTheReaderReads) {
  auto reader = open(FakeReader::Fault::kNone);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ((*reader)->driver(), "FAKE");
  EXPECT_EQ((*reader)->take_warnings(), std::vector<std::string>{"said at the start"});
  ASSERT_EQ((*reader)->layers().size(), 1U);
  const auto& layer = (*reader)->layers().front();
  EXPECT_EQ(layer.fields, (std::vector<std::string>{"height", "name"}));
  EXPECT_EQ(layer.geometry, GeometryKind::kLine);
  EXPECT_EQ(layer.crs.code, "EPSG:25831");
  EXPECT_EQ(layer.declared_features, 3000);
  const auto box = (*reader)->extent(0);
  ASSERT_TRUE(box && *box);
  EXPECT_EQ((*box)->max_y, 4.0);
  for (int round = 0; round < 2; ++round) {
    int i = 0;
    const auto count = (*reader)->read(0, {}, [&](SourceFeature& feature) {
      SourceFeature expected;
      FakeReader::fill(expected, i++);
      EXPECT_EQ(feature.fid, expected.fid);
      EXPECT_EQ(feature.values, expected.values);
      EXPECT_EQ(feature.geometry.xs, expected.geometry.xs);
      EXPECT_EQ(feature.geometry.ys, expected.geometry.ys);
      ASSERT_EQ(feature.geometry.paths.size(), 1U);
      EXPECT_TRUE(feature.geometry.paths[0].curved);
      EXPECT_EQ(feature.geometry.type, expected.geometry.type);
      EXPECT_EQ(feature.warnings, expected.warnings);
      EXPECT_EQ(feature.reencoded, expected.reencoded);
      EXPECT_EQ(feature.broken, expected.broken);
      EXPECT_EQ(feature.selected, expected.selected);
    });
    ASSERT_TRUE(count) << count.error().message;
    EXPECT_EQ(*count, 3000U);
    EXPECT_EQ((*reader)->take_warnings(), std::vector<std::string>{"said at the end"});
  }
}

// Features of every size: many in one batch, one that fills several.
class SizesReader : public FakeReader {
 public:
  SizesReader() : FakeReader(Fault::kNone) {}
  Result<std::size_t> read(std::size_t, const ReadOptions&, const FeatureVisitor& visit) override {
    SourceFeature feature;
    for (int i = 0; i < kCount; ++i) {
      fill(feature, i);
      visit(feature);
    }
    return kCount;
  }

  static constexpr int kCount = 400;

  static void fill(SourceFeature& feature, int i) {
    FakeReader::fill(feature, i);
    const std::size_t points = i % 50 == 0 ? 60000 : i % 10 == 0 ? 7500 : 1 + i % 7;
    feature.geometry.xs.assign(points, 0.5 * i);
    feature.geometry.ys.assign(points, -1.0 * i);
    feature.geometry.zs.assign(i % 3 == 0 ? points : 0, 2.0 * i);
    feature.geometry.paths = {{0, static_cast<std::uint32_t>(points), PathRole::kLine, false}};
  }
};

TEST(IsolatedReader, HandsOverFeaturesOfAnySize) {
  auto reader = open_isolated("site.fake", 1000, [](const DriverNotice&) -> OpenedReader {
    return std::make_unique<SizesReader>();
  });
  ASSERT_TRUE(reader) << reader.error().message;
  for (int round = 0; round < 3; ++round) {
    int i = 0;
    const auto count = (*reader)->read(0, {}, [&](SourceFeature& feature) {
      SourceFeature expected;
      SizesReader::fill(expected, i++);
      EXPECT_EQ(feature.fid, expected.fid);
      EXPECT_EQ(feature.values, expected.values);
      EXPECT_TRUE(feature.geometry.xs == expected.geometry.xs) << i;
      EXPECT_TRUE(feature.geometry.ys == expected.geometry.ys) << i;
      EXPECT_TRUE(feature.geometry.zs == expected.geometry.zs) << i;
      EXPECT_EQ(feature.warnings, expected.warnings);
    });
    ASSERT_TRUE(count) << count.error().message;
    EXPECT_EQ(i, SizesReader::kCount);
  }
}

TEST(IsolatedReader, HandsOverFailures) {
  auto reader = open(FakeReader::Fault::kNone);
  ASSERT_TRUE(reader);
  ReadOptions options;
  options.where = "wrong";
  const auto count = (*reader)->read(0, options, [](SourceFeature&) {});
  ASSERT_FALSE(count);
  EXPECT_EQ(count.error().kind, FailureKind::kUsage);
  EXPECT_EQ(count.error().message, "--where: wrong");
  EXPECT_TRUE((*reader)->read(0, {}, [](SourceFeature&) {})) << "it is still there";
}

std::string failure_of(FakeReader::Fault fault) {
  auto reader = open(fault);
  if (!reader) return reader.error().message;
  const auto count = (*reader)->read(0, {}, [](SourceFeature&) {});
  EXPECT_FALSE(count);
  if (count) return {};
  EXPECT_EQ(count.error().kind, FailureKind::kInput);
  EXPECT_FALSE((*reader)->extent(0)) << "a reader that is gone stays gone";
  return count.error().message;
}

TEST(IsolatedReader, SurvivesACrash) {
  const auto message = failure_of(FakeReader::Fault::kCrash);
  EXPECT_NE(message.find("site.fake: the driver FAKE was killed by signal 11"), message.npos)
      << message;
  EXPECT_NE(message.find("layer walls"), message.npos) << message;
}

TEST(IsolatedReader, SurvivesAnExit) {
  EXPECT_NE(failure_of(FakeReader::Fault::kExit).find("ended with status 7"), std::string::npos);
}

TEST(IsolatedReader, StopsAHang) {
  const auto begin = std::chrono::steady_clock::now();
  const auto message = failure_of(FakeReader::Fault::kHang);
  EXPECT_NE(message.find("the driver FAKE was stopped"), message.npos) << message;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 60.0);
}

TEST(IsolatedReader, SaysThatMemoryDoesNotSuffice) {
  EXPECT_NE(failure_of(FakeReader::Fault::kThrow).find("more memory"), std::string::npos);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(IsolatedReader, BoundsMemory) {
  EXPECT_NE(failure_of(FakeReader::Fault::kGreed).find("more memory"), std::string::npos);
}
#endif

TEST(IsolatedReader, SaysWhyASourceDoesNotOpen) {
  const auto refused = open_isolated(
      "a.fake", 0, [](const DriverNotice&) -> OpenedReader { return input_failure("is no fake"); });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "a.fake: is no fake");
  const auto crashed = open_isolated("a.fake", 0, [](const DriverNotice& notice) -> OpenedReader {
    notice("FAKE");
    std::raise(SIGABRT);
    return input_failure("never said");
  });
  ASSERT_FALSE(crashed);
  EXPECT_NE(crashed.error().message.find("a.fake: the driver FAKE was killed by signal 6"),
            std::string::npos)
      << crashed.error().message;
}

}  // namespace
}  // namespace mapwright::converter
