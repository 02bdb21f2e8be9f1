// The table of reading options: flags and records return the given options, and the format of records is unchanged.
#include "core/scan/grid/reading_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace edgescan {
namespace {

ReadingOptions everything() {
    ReadingOptions options;
    options.beamStartDeg = -5.5;
    options.beamStepDeg = 0.1;
    options.lineStartDeg = -90;
    options.lineStepDeg = 1e-7;
    options.unitMm = 10;
    options.gridStepDeg = 0.25;
    options.axis = Axis::Sweep;
    options.sensorM = Eigen::Vector3d(1, 2.5, -3);
    options.projection = Projection::Never;
    options.straighten = true;
    options.scanIndex = 4;
    options.topic = "/arm/scan";
    options.joint = "tilt joint";
    options.columns = "2,1,3";
    options.keepRepeated = true;
    options.pose = "it's here.json";
    options.calibration = "robot.json";
    return options;
}

TEST(ReadingOptions, ARecordIsWrittenAsItAlwaysWas) {
    EXPECT_EQ(readingOptionsText({}), "");
    EXPECT_EQ(readingOptionsText(everything()),
              "{\"beam-start\":-5.5,\"beam-step\":0.1,\"line-start\":-90.0,\"line-step\":1e-07,\"unit-mm\":10.0,\"grid-step\":0.25,"
              "\"axis\":\"sweep\",\"sensor\":[1.0,2.5,-3.0],\"project\":\"never\",\"straighten\":true,\"scan\":4,"
              "\"topic\":\"/arm/scan\",\"joint\":\"tilt joint\",\"columns\":\"2,1,3\",\"keep-repeated\":true}");
    const auto again = parseReadingOptions(readingOptionsText(everything()), "test");
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_EQ(readingOptionsText(*again), readingOptionsText(everything()));
    EXPECT_EQ(again->unitMm, 10.0);
    EXPECT_TRUE(again->straighten);
}

TEST(ReadingOptions, DamagedRecordsAreRefused) {
    for (const char* text : {"[1]", "{\"axis\":\"up\"}", "{\"beam-start\":\"1\"}", "{\"sensor\":[1,2]}", "{\"scan\":-1}", "{\"scan\":1e9}",
                             "{\"straighten\":1}", "{\"pose\":\"p.json\"}", "{\"unknown\":1}", "{\"unit\":\"mm\"}"})
        EXPECT_FALSE(parseReadingOptions(text, "test")) << text;
}

TEST(ReadingOptions, FlagsGiveBackWhatWasSaid) {
    EXPECT_EQ(readingFlags({}), "");
    EXPECT_EQ(
        readingFlags(everything()),
        "--beam-start -5.5 --beam-step 0.1 --line-start -90 --line-step 1e-07 --unit cm --grid-step 0.25 "
        "--axis sweep --sensor 1,2.5,-3 --project never --straighten --scan 4 --topic '/arm/scan' --joint 'tilt joint' --columns '2,1,3' "
        "--keep-repeated "
        "--pose 'it'\\''s here.json' --calibration 'robot.json'");
    ReadingOptions again;
    for (const ReadingOption& option : readingOptionTable()) {
        const std::string text = option.get(everything());
        ASSERT_NE(text, "") << option.key;
        ASSERT_TRUE(checked(option, text)) << option.key;
        option.set(again, text);
        EXPECT_EQ(option.get(again), text);
        EXPECT_EQ(option.get({}), "") << option.key;
    }
    EXPECT_EQ(readingFlags(again), readingFlags(everything()));
}

TEST(ReadingOptions, AUnitIsAWordOrANumber) {
    const auto unit =
        std::ranges::find(readingOptionTable(), std::string_view("unit"), [](const ReadingOption& o) { return std::string_view(o.key); });
    ReadingOptions options;
    for (const auto& [text, mm] :
         {std::pair{"m", 1000.0}, {"mm", 1.0}, {"0.2", 0.2}, {"in", 25.4}, {"ft", 304.8}, {"usft", 1200000.0 / 3937.0}}) {
        ASSERT_TRUE(checked(*unit, text)) << text;
        unit->set(options, text);
        EXPECT_EQ(options.unitMm, mm);
        EXPECT_EQ(unit->get(options), text);
    }
    for (const char* text : {"0", "-1", "1e9", "fathom", "1,2"}) EXPECT_FALSE(checked(*unit, text)) << text;
}

TEST(ReadingOptions, WhatReplacesTheFileAndWhatHasNoEffectIsNamed) {
    ReadingOptions given, file;
    given.unitMm = 1000.0;
    given.axis = Axis::Spin;
    given.topic = "/scan";
    file.unitMm = 1.0;
    file.axis = Axis::Spin;
    EXPECT_EQ(replacedByOptions(given, file), std::vector<std::string>{"--unit m replaces mm, which the file gives."});
    EXPECT_TRUE(replacedByOptions(given, {}).empty()) << "the file gives nothing";
    constexpr std::array<std::string_view, 2> kKeys{"topic", "joint"};
    EXPECT_EQ(idleOptions(given, kKeys, "WHY"), std::vector<std::string>{"--topic has no effect: WHY; leave it out."});
}

TEST(ReadingOptions, WhatDoesNotFitIsRefused) {
    for (const ReadingOption& option : readingOptionTable()) {
        using Kind = ReadingOption::Kind;
        if (option.kind == Kind::Switch || option.kind == Kind::Path || option.kind == Kind::Name) continue;
        for (const char* text : {"", "abc", "1,2", "nan", "inf", "1x", "1,", "1,2,3,4"}) EXPECT_FALSE(checked(option, text)) << option.key;
        if (option.kind == Kind::Whole) {
            EXPECT_FALSE(checked(option, "-1") || checked(option, "1.5"));
        }
    }
}

} // namespace
} // namespace edgescan
