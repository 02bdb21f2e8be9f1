// The table of parameters: every row can be typed, stored and snapped, and gives one sentence for a fault.
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

namespace edgescan::edges {
namespace {

TEST(Parameters, KeysAreUniqueAndEveryRowExplainsItself) {
    std::set<std::string> keys;
    for (const Parameter& p : parameters()) {
        EXPECT_TRUE(keys.insert(p.key).second) << p.key;
        EXPECT_GT(std::string(p.help).size(), 20U) << p.key;
        EXPECT_LT(p.minimum, p.maximum) << p.key;
        EXPECT_EQ(findParameter(p.key), &p);
    }
    for (const char* fixed : {"kernel", "sigma", "lower", "ratio", "aperture", "norm", "near", "far", "mask-missing", "method", "jump",
                              "growth", "crease", "sensitivity", "hysteresis-low", "min-length", "grazing", "noise", "classes"})
        EXPECT_TRUE(keys.count(fixed)) << fixed;
    EXPECT_EQ(findParameter("nonsense"), nullptr);
}

TEST(Parameters, EveryValueSurvivesTextJsonAndSettings) {
    for (const Parameter& p : parameters()) {
        std::vector<double> values{p.minimum, p.maximum, p.get(Settings{})};
        for (const Choice& c : p.choices) values.push_back(c.value);
        if (p.choices.empty()) values.push_back(snapped(p, p.minimum + (p.maximum - p.minimum) / 3));
        if (p.automatic != nullptr) values.push_back(kAutomatic);
        for (const double value : values) {
            const Result<double> back = parseValue(p, formatValue(p, value));
            ASSERT_TRUE(back) << back.error().sentence();
            EXPECT_TRUE(*back == value || (std::isnan(*back) && std::isnan(value))) << p.key << " " << value;
            Settings s;
            p.set(s, value);
            EXPECT_TRUE(p.get(s) == value || (std::isnan(p.get(s)) && std::isnan(value)));
            const Result<Settings> again = settingsFromJson(settingsToJson(s), Settings{}, "test");
            ASSERT_TRUE(again) << again.error().sentence();
            EXPECT_TRUE(*again == s) << p.key;
        }
    }
}

TEST(Parameters, NonsenseIsRefusedWithTheFlagsName) {
    for (const Parameter& p : parameters()) {
        for (const char* text : {"", "abc", "1e999", "nan", "-1e9", "12,5", "3 3"}) {
            const Result<double> value = parseValue(p, text);
            ASSERT_FALSE(value) << p.key << " " << text;
            EXPECT_NE(value.error().sentence().find(flagOf(p)), std::string::npos);
        }
    }
    EXPECT_FALSE(parseValue(*findParameter("kernel"), "4"));
    EXPECT_FALSE(parseValue(*findParameter("lower"), "auto"));
}

TEST(Parameters, LengthsTakeTheirUnit) {
    const Parameter& near = *findParameter("near");
    EXPECT_EQ(*parseValue(near, "2500"), 2500);
    EXPECT_EQ(*parseValue(near, "2500mm"), 2500);
    EXPECT_EQ(*parseValue(near, "2500 mm"), 2500);
    EXPECT_EQ(*parseValue(near, "2.5m"), 2500);
    EXPECT_EQ(*parseValue(*findParameter("growth"), "1%"), 1) << "of the range";
    EXPECT_EQ(parseValue(near, "25cm").error().hint, "write it like 12.5, in mm, or with its unit: mm or m");
}

TEST(Parameters, TheNameOfAFlagFindsItsParameter) {
    EXPECT_EQ(findParameter("edge-strength"), findParameter("sensitivity"));
    EXPECT_EQ(flagOf(*findParameter("sensitivity")), "--edge-strength");
    EXPECT_EQ(settingsFromJson({{"edge-strength", 2}}, Settings{}, "here")->sensitivity, 2);
}

TEST(Parameters, SnappingGivesOddKernelsAndStaysInside) {
    const Parameter& kernel = *findParameter("kernel");
    for (const auto& [typed, expected] : {std::pair{-5.0, 1.0}, {4.4, 5.0}, {8.1, 9.0}, {99.0, 11.0}})
        EXPECT_EQ(snapped(kernel, typed), expected);
    EXPECT_EQ(snapped(*findParameter("lower"), 10.04), 10.0);
    EXPECT_EQ(snapped(*findParameter("lower"), 1e9), 20000.0);
    EXPECT_TRUE(std::isnan(snapped(*findParameter("sigma"), kAutomatic)));
}

TEST(Parameters, NearBeyondFarIsRefused) {
    Settings s = cannySettings();
    s.scaling = Scaling::Window;
    s.nearMm = 5000;
    s.farMm = 5000;
    EXPECT_FALSE(checkSettings(s));
    s.farMm = 5001;
    EXPECT_TRUE(checkSettings(s));
}

TEST(Parameters, ASetTakesNamesInAnyOrder) {
    const Parameter& classes = *findParameter("classes");
    EXPECT_EQ(*parseValue(classes, "concave,jump"), kClassJump | kClassConcave);
    EXPECT_EQ(formatValue(classes, kClassJump | kClassConcave), "jump,concave");
    EXPECT_EQ(*parseValue(classes, "all"), 63);
    EXPECT_EQ(*parseValue(classes, "none"), 0);
    for (const char* text : {"jump,", ",", "jump,border2", "jump concave", "3"}) EXPECT_FALSE(parseValue(classes, text)) << text;
}

TEST(Parameters, BordersAndRoughScansAreReadOnlyWhereTheyActed) {
    const auto used = [](const char* key, const Settings& settings) { return findParameter(key)->usedBy(settings); };
    Settings s;
    EXPECT_TRUE(used("rock-borders", s) && !used("border-from", s) && !used("rough-scans", s));
    s.rockBorders = true;
    s.rules = 4;
    EXPECT_TRUE(used("border-from", s) && used("rough-scans", s));
    s.method = Method::Canny;
    for (const char* key : {"rock-borders", "border-from", "rules", "rough-scans"}) EXPECT_FALSE(used(key, s)) << key;
}

TEST(Presets, AFileFromBeforeThereWereMethodsIsCanny) {
    const auto path = std::filesystem::temp_directory_path() / "edgescan-old-preset.json";
    std::ofstream(path) << R"({"format": "edgescan-preset/1", "settings": {"kernel": 5}})";
    const Result<Preset> old = findPreset(path.string());
    ASSERT_TRUE(old) << old.error().sentence();
    EXPECT_EQ(old->settings.method, Method::Canny);
    std::filesystem::remove(path);
}

TEST(Presets, AFileComesBackAsItWas) {
    Preset preset{"my bell", "", findPreset("thesis")->settings, {}};
    preset.settings.lower = 17.5;
    preset.settings.farMm = 12000;
    const auto path = std::filesystem::temp_directory_path() / "edgescan-préréglage.json";
    std::ofstream(path) << presetText(preset);
    const Result<Preset> back = findPreset(path.string());
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->name, "my bell");
    EXPECT_TRUE(back->settings == preset.settings);
    for (const char* text :
         {"", "{}", "[1]", "{\"format\": \"edgescan-preset/1\"}", "{\"format\": \"edgescan-preset/1\", \"settings\": {\"kernal\": 3}}",
          "{\"format\": \"edgescan-preset/1\", \"settings\": {\"kernel\": 4}}"}) {
        std::ofstream(path) << text;
        const Result<Preset> bad = findPreset(path.string());
        ASSERT_FALSE(bad) << text;
        EXPECT_NE(bad.error().sentence().find("edgescan-pr"), std::string::npos);
    }
    std::filesystem::remove(path);
    EXPECT_FALSE(findPreset("no-such-preset"));
}

// Records name the default settings by their version: after a change of a default, raise kDefaultSet.version and enter the new ones here.
TEST(Presets, TheDefaultSettingsAreThoseOfTheirVersion) {
    EXPECT_EQ(kDefaultSet.version, 5);
    EXPECT_EQ(
        settingsToJson(Settings{}).dump(),
        R"({"aperture":3,"border-from":50,"classes":"jump,convex,concave,silhouette,rim","crease":30,"far":"auto","fill":0,"fill-edges":"off","grazing":0.1,"growth":1,"hysteresis-low":70,"jump":"auto",)"
        R"("kernel":3,"log-mask":"four","lower":6,"mask-isolated":"on","mask-missing":"on","method":"edgescan+","min-length":4,"near":"auto",)"
        R"("noise":"auto","noise-kind":"measured","norm":"l1","ratio":3,"rock-borders":"off","rough-scans":"on","rules":5,"scaling":"log","sensitivity":1,"sigma":"auto","slips":"on","step":3,"turns":"on"})");
    EXPECT_EQ(builtInPresets().front().name, kDefaultSet.name);
    EXPECT_TRUE(changedFromDefault(Settings{}).empty());
    EXPECT_EQ(changedFromDefault(findPreset("default-3")->settings),
              (std::vector<std::string>{"min-length", "classes", "turns", "rules", "rough-scans"}));
    EXPECT_EQ(changedFromDefault(findPreset("default-4")->settings), std::vector<std::string>{"rules"});
    // Parameters that the method does not read are not listed.
    Settings turned;
    turned.jumpMm = 50;
    turned.kernel = 7;
    EXPECT_EQ(changedFromDefault(turned), std::vector<std::string>{"jump"});
}

TEST(Presets, ARecordOfAnEarlierSetKeepsItsMeaning) {
    nlohmann::json old = settingsToJson(defaultSettings(3));
    EXPECT_EQ(settingsOfRecord(old, 3), old);
    old["classes"] = "all"; // of five
    EXPECT_EQ(settingsOfRecord(old, 3)["classes"], "jump,convex,concave,border,silhouette");
    EXPECT_EQ(settingsOfRecord(old, kDefaultSet.version)["classes"], "all");
    EXPECT_EQ(settingsOfRecord(nlohmann::json::object(), 2), settingsToJson(defaultSettings(3)));
    EXPECT_EQ(settingsOfRecord(nlohmann::json::object(), 0), settingsToJson(defaultSettings(3)));
    EXPECT_EQ(settingsOfRecord(settingsToJson(Settings{}), 0), settingsToJson(Settings{}));
    nlohmann::json four = settingsToJson(defaultSettings(4)); // as version 4 wrote them
    for (const char* later : {"rules", "rock-borders", "border-from"}) four.erase(later);
    for (const int version : {0, 4}) EXPECT_EQ(settingsOfRecord(four, version), settingsToJson(defaultSettings(4))) << version;
    EXPECT_EQ(settingsOfRecord(nlohmann::json::object(), kDefaultSet.version), settingsToJson(Settings{}));
}

} // namespace
} // namespace edgescan::edges
