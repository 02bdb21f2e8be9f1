// JSON from outside: depth, size and keys are bounded, and every fault gives one sentence.
#include "core/base/bounded_json.h"

#include "core/base/json_fields.h"
#include "core/edges/settings/presets.h"
#include "core/exports/verify.h"
#include "core/files/recording/replay.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"
#include "tests/support/bytes.h"
#include "tests/support/live_lines.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

using namespace edgescan;
using namespace edgescan::test;

namespace {

std::string nested(std::size_t depth, char open = '[', char close = ']') { return std::string(depth, open) + std::string(depth, close); }

std::string refusal(const std::string& text, const JsonBounds& bounds = {}) {
    const auto plain = parseJson(text, "x.json", bounds);
    const auto ordered = parseOrderedJson(text, "x.json", bounds);
    EXPECT_EQ(bool(plain), bool(ordered)) << text.substr(0, 80);
    if (plain) return {};
    EXPECT_EQ(plain.error().sentence(), ordered.error().sentence());
    EXPECT_TRUE(plain.error().where.starts_with("x.json"));
    return plain.error().sentence();
}

void expectRefusal(const std::string& text, const std::string& words, const JsonBounds& bounds = {}) {
    EXPECT_NE(refusal(text, bounds).find(words), std::string::npos) << text.substr(0, 80) << " -> " << refusal(text, bounds);
}

constexpr std::size_t kDeep = 100'000;

} // namespace

TEST(BoundedJson, ReadsWhatNlohmannReads) {
    for (const char* text : {R"({"a":[1,-2,3.5e3,true,false,null,"x\u00e9\n"],"b":{"c":{}},"d":[[],[[1]]]})", "[]", "{}", "7", "\"w\"",
                             " null ", "\xEF\xBB\xBF{\"bom\":1}"}) {
        const auto plain = parseJson(text, "x");
        ASSERT_TRUE(plain) << text;
        EXPECT_EQ(*plain, nlohmann::json::parse(text));
        const auto ordered = parseOrderedJson(text, "x");
        ASSERT_TRUE(ordered) << text;
        EXPECT_EQ(ordered->dump(), nlohmann::ordered_json::parse(text).dump());
    }
    EXPECT_EQ(parseOrderedJson(R"({"z":1,"a":2})", "x")->dump(), R"({"z":1,"a":2})");
}

TEST(BoundedJson, WhatIsOutOfBoundsIsASentence) {
    EXPECT_EQ(refusal(nested(12)), "");
    expectRefusal(nested(13), "nested too deep");
    expectRefusal(nested(kDeep), "nested too deep");
    expectRefusal(std::string(kDeep, '['), "nested too deep");
    std::string objects;
    for (std::size_t n = 0; n < kDeep; ++n) objects += "{\"a\":";
    expectRefusal(objects, "nested too deep");
    expectRefusal(nested(8), "nested too deep", {100, 7, 10});
    expectRefusal(std::string(101, ' '), "too large", {100, 7, 10});
    std::string keys = "{\"k0\":0";
    for (int n = 1; n < 5000; ++n) keys += ",\"k" + std::to_string(n) + "\":0";
    expectRefusal(keys + "}", "too many keys"); // in one object
    expectRefusal(R"([{"a":1},{"a":1},{"a":1}])", "too many keys", {100, 7, 2});
    EXPECT_EQ(refusal(R"([{"a":1},{"a":1}])", {100, 7, 2}), "");
    expectRefusal(R"({"lines":1,"lines":2})", "\"lines\" appears twice");
    expectRefusal("[1e999]", "a number that no computer can store");
    expectRefusal("[1,", "x.json: byte 4: the JSON is damaged or cut off here");
    expectRefusal("", "x.json: the file is empty; copy it again or choose another.");
    expectRefusal(" \n", "the file is empty");
    expectRefusal("{\"a\":1}x", "damaged or cut off");
    expectRefusal("\"\xff\"", "damaged or cut off");
}

TEST(BoundedJson, EveryDoorThatJsonComesInBy) {
    const Folder folder;
    const std::string deep = "{\"format\":\"edgescan-preset/1\",\"settings\":" + nested(kDeep) + "}";
    writeText(folder / "deep.json", deep);
    const auto preset = edges::findPreset((folder / "deep.json").string());
    ASSERT_FALSE(preset);
    EXPECT_NE(preset.error().sentence().find("nested too deep"), std::string::npos) << preset.error().sentence();
    writeText(folder / "large.json", "{\"format\":\"edgescan-preset/1\"}");
    std::filesystem::resize_file(folder / "large.json", std::uintmax_t{1} << 36U); // sparse: must not be read
    const auto large = edges::findPreset((folder / "large.json").string());
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().sentence().find("too large"), std::string::npos) << large.error().sentence();

    for (const char* format : {"edgescan-raw-grid/1", "edgescan-pose/1", "edgescan-calibration/1"}) {
        const std::string text = std::string("{\"format\":\"") + format + "\",\"note\":" + nested(kDeep) + "}";
        EXPECT_FALSE(parseJsonObject(text, format, "x"));
    }
    EXPECT_FALSE(parseReadingOptions("{\"axis\":" + nested(kDeep) + "}", "x"));
    EXPECT_FALSE(scanner::settingsOf({{"stepper.axis", nested(kDeep)}}).warnings.empty());
    const std::string reading = "{\"phi_deg\":1,\"x\":" + nested(1000) + "}";
    EXPECT_FALSE(files::parseStepper(Bytes(reading.begin(), reading.end()), 0));

    // Inside an export, and in its sidecar.
    writeText(folder / "edges.xyz", "# edgescan-record {\"a\":" + nested(kDeep) + "}\n1 2 3\n");
    EXPECT_FALSE(exports::verifyExport(folder / "edges.xyz", {}));
    writeText(folder / "edges.xyz.provenance.json", nested(kDeep, '{', '}'));
    EXPECT_FALSE(exports::verifyExport(folder / "edges.xyz", {}));
    for (const char* extension : {".xyz", ".pcd", ".ply"}) {
        const std::string mark = extension == std::string(".ply") ? "ply\ncomment edgescan " : "# edgescan ";
        EXPECT_NE(refusalOf(mark + "{\"format\":\"edgescan-raw-grid/1\",\"note\":" + nested(kDeep) + "}\n1 2 3\n", extension), "");
    }
}
