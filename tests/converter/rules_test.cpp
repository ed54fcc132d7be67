#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "converter/rules/absent_fields.hpp"
#include "converter/rules/layer_rules.hpp"
#include "converter/rules/length_text.hpp"
#include "converter/rules/rule_fields.hpp"
#include "converter/rules/rule_reader.hpp"

namespace mapwright::converter {
namespace {

std::string mistake(const std::string& rules) {
  const auto set = read_rules(rules, "r.yaml");
  return set ? "" : set.error().message;
}

TEST(Rules, NameThePlaceOfMistakes) {
  EXPECT_EQ(mistake("mapwright_rules: 1\nrules: a: b\n").rfind("r.yaml:2:9: error:", 0), 0U);
  EXPECT_NE(mistake("rules:\n- kind: wall\n").find("mapwright_rules: 1"), std::string::npos);
  EXPECT_EQ(mistake("mapwright_rules: 1\nrules:\n- kind: wal\n")
                .rfind("r.yaml:3:9: error: there is no kind 'wal'", 0),
            0U);
  EXPECT_EQ(mistake("mapwright_rules: 1\nrules:\n- kind: wall\n  hight: 3\n")
                .rfind("r.yaml:4:3: error: a rule: there is no key 'hight'", 0),
            0U);
  EXPECT_EQ(mistake("mapwright_rules: 1\nrules:\n- kind: wall\n  height: {field: h, unit: yd}\n")
                .rfind("r.yaml:4:28: error: there is no unit 'yd'", 0),
            0U);
  EXPECT_EQ(mistake("mapwright_rules: 1\nrules:\n- name: x\n")
                .rfind("r.yaml:3:3: error: a rule without 'kind'", 0),
            0U);
}

// What the reader knows, by what it says of a key that it does not know.
std::vector<std::string> keys_of_rules() {
  const auto said = mistake("mapwright_rules: 1\nrules:\n- kind: wall\n  hight: 3\n");
  std::istringstream list(said.substr(said.find("the keys are ") + 13));
  std::vector<std::string> keys;
  for (std::string key; std::getline(list >> std::ws, key, ',');) keys.push_back(key);
  return keys;
}

// A key that takes fields is looked for in layers, whichever it is.
TEST(Rules, NamesThatNoLayerHasAreToldForEveryKey) {
  const std::set<std::string> without_fields{"name", "layer",  "geometry", "where",
                                             "kind", "reason", "normal",   "axes"};
  LayerInfo layer;
  layer.name = "walls";
  layer.fields = {"height"};
  std::size_t tried = 0;
  for (const auto& key : keys_of_rules()) {
    if (without_fields.count(key) > 0) continue;
    const bool is_text = key.ends_with("semantic");
    const auto set = read_rules("mapwright_rules: 1\nrules:\n- kind: ramp\n  " + key + ": " +
                                    (is_text ? "\"{nowhere}\"" : "nowhere") + "\n",
                                "r.yaml");
    ASSERT_TRUE(set) << key;
    EXPECT_TRUE(rules_read_fields(*set, "walls")) << key;
    const auto absent = absent_fields(*set, {&layer});
    ASSERT_EQ(absent.size(), 1U) << key;
    EXPECT_NE(absent[0].find("takes its " + key + " from 'nowhere'"), std::string::npos)
        << absent[0];
    ++tried;
  }
  EXPECT_EQ(tried, 14U);
}

TEST(Rules, BuiltInSetsAreSound) {
  for (const auto& name : builtin_rule_sets()) {
    const auto set = read_rules(std::string(builtin_rules(name)), name);
    ASSERT_TRUE(set.has_value()) << set.error().message;
    EXPECT_GT(set->rules.size(), 3U);
  }
}

TEST(Patterns, OverlookCaseAndAccents) {
  EXPECT_TRUE(Pattern("*edific*").matches("Edificis_2024"));
  EXPECT_TRUE(Pattern("alcada").matches("Alçada"));
  EXPECT_TRUE(Pattern("Gebäude").matches("GEBAUDE"));
  EXPECT_TRUE(Pattern("a?c*").matches("abcd"));
  EXPECT_FALSE(Pattern("a?c").matches("abcd"));
  EXPECT_FALSE(Pattern("wall").matches("walls"));
}

TEST(Lengths, AreReadWithTheirUnits) {
  EXPECT_DOUBLE_EQ(length_from_text("7 m", 1.0).value(), 7.0);
  EXPECT_DOUBLE_EQ(length_from_text("3,5", 1.0).value(), 3.5);
  EXPECT_DOUBLE_EQ(length_from_text(" 350 ", 0.01).value(), 3.5);
  EXPECT_DOUBLE_EQ(length_from_text("350 cm", 1.0).value(), 3.5);
  EXPECT_DOUBLE_EQ(length_from_text("12'6\"", 1.0).value(), 12.5 * 0.3048);
  EXPECT_DOUBLE_EQ(length_from_text("12 ft", 1.0).value(), 12 * 0.3048);
  for (const char* text : {"", "tall", "3 apples", "3..5", "5'x", "nan", "inf"}) {
    EXPECT_FALSE(length_from_text(text, 1.0).has_value()) << text;
  }
}

LayerInfo walls_layer() {
  LayerInfo layer;
  layer.name = "Murs exteriors";
  layer.fields = {"TYPE", "top_z", "base_z", "height_txt", "name", "segment_se"};
  layer.geometry = GeometryKind::kLine;
  return layer;
}

SourceFeature wall(FieldValue type, FieldValue top, FieldValue base, FieldValue text,
                   FieldValue name) {
  SourceFeature feature;
  feature.values = {type, top, base, text, name, std::string("brick")};
  return feature;
}

RuleSet rule_set(const std::string& rules) {
  auto set = read_rules("mapwright_rules: 1\nrules:\n" + rules, "test");
  EXPECT_TRUE(set.has_value()) << (set ? "" : set.error().message);
  return set.value_or(RuleSet{});
}

TEST(LayerRules, TakeTheFirstRuleThatFits) {
  const auto rules = rule_set(
      "- {name: low, layer: mur*, where: {type: [kerb, 'low*']}, kind: ignore}\n"
      "- {name: high, where: {top_z: '> 5'}, kind: wall, height: 9}\n"
      "- {name: rest, layer: ['x*', 'MURS*'], kind: wall, height: [height_txt, {field: top_z, "
      "minus: base_z}],\n"
      "   semantic: 'wall,{type},name={name}', segment_semantic: '{segment_semantic}'}\n");
  const LayerRules bound(rules, walls_layer());
  Meaning meaning;
  const auto name_of = [&](const SourceFeature& feature) {
    bound.interpret(feature, GeometryKind::kLine, meaning);
    return meaning.rule == nullptr ? "" : meaning.rule->name;
  };
  EXPECT_EQ(name_of(wall("Kerb", 1.0, 0.0, {}, {})), "low");
  EXPECT_EQ(name_of(wall("low_wall", 9.0, 0.0, {}, {})), "low");
  EXPECT_EQ(name_of(wall("wall", 9.0, 0.0, {}, {})), "high");
  EXPECT_EQ(name_of(wall("wall", 3.0, 0.5, std::string("2 m"), std::string("A; b,c"))), "rest");
  EXPECT_EQ(meaning.height_m, 2.0);
  EXPECT_EQ(meaning.semantic, "wall,name=A  b c");
  EXPECT_TRUE(meaning.semantic_altered);
  EXPECT_EQ(meaning.segment_semantic, "brick");
}

TEST(LayerRules, PassOverValuesThatAreNoQuantities) {
  const auto rules =
      rule_set("- {kind: wall, height: [height_txt, {field: top_z, minus: base_z}, 7]}\n");
  const LayerRules bound(rules, walls_layer());
  Meaning meaning;
  bound.interpret(wall({}, 3.0, 0.5, std::string("tall"), {}), GeometryKind::kLine, meaning);
  EXPECT_EQ(meaning.height_m, 2.5);
  EXPECT_EQ(meaning.unreadable, (std::vector<std::string>{"height_txt 'tall'"}));
  bound.interpret(wall({}, 3.0, {}, {}, {}), GeometryKind::kLine, meaning);
  EXPECT_EQ(meaning.height_m, 7.0);
  EXPECT_TRUE(meaning.unreadable.empty());
}

TEST(LayerRules, ReadOsmTags) {
  LayerInfo layer;
  layer.name = "multipolygons";
  layer.fields = {"building", "other_tags"};
  layer.geometry = GeometryKind::kPolygon;
  const auto rules = read_rules(std::string(builtin_rules("osm")), "osm");
  ASSERT_TRUE(rules.has_value());
  const LayerRules bound(*rules, layer);
  SourceFeature feature;
  feature.values = {std::string("yes"),
                    std::string(R"("building:levels"=>"3","name"=>"Casa \"Mila\"")")};
  Meaning meaning;
  bound.interpret(feature, GeometryKind::kPolygon, meaning);
  ASSERT_NE(meaning.rule, nullptr);
  EXPECT_EQ(meaning.rule->name, "buildings");
  EXPECT_EQ(meaning.height_m, 9.0);
  EXPECT_EQ(meaning.semantic, "building,name=Casa \"Mila\"");
}

}  // namespace
}  // namespace mapwright::converter
