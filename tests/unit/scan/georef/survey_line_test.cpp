// Lines as surveyors write them: every usual separator, order and decimal mark; what allows two readings is refused.
#include "core/scan/georef/survey_line.h"

#include <gtest/gtest.h>

using namespace edgescan;
using Eigen::Vector3d;

namespace {

const Vector3d kPlace(498765.432, 5150123.456, 287.654);

Vector3d placeOf(const char* line, SurveyOrder order = SurveyOrder::EastingFirst) {
    const auto read = parseSurveyLine(line, order);
    EXPECT_TRUE(read) << line << ": " << (read ? "" : read.error().sentence());
    return read ? read->enhM : Vector3d::Zero();
}

} // namespace

TEST(SurveyLine, EverySeparatorAndDecimalMark) {
    for (const char* line : {"498765.432,5150123.456,287.654", "498765.432, 5150123.456, 287.654", "498765.432;5150123.456;287.654",
                             "498765.432\t5150123.456\t287.654", "  498765.432   5150123.456 287.654 \r\n",
                             "498765,432;5150123,456;287,654", "498765,432\t5150123,456\t287,654", "498765,432 5150123,456 287,654"})
        EXPECT_EQ(placeOf(line), kPlace) << line;
}

TEST(SurveyLine, TheNameComesFirstAndWordsComeLast) {
    for (const char* line : {"P7,498765.432,5150123.456,287.654", "P7;498765.432;5150123.456;287.654;scanner head",
                             "P7\t498765.432\t5150123.456\t287.654\tCP 12"}) {
        const auto read = parseSurveyLine(line);
        ASSERT_TRUE(read) << line;
        EXPECT_EQ(read->name, "P7");
        EXPECT_EQ(read->enhM, kPlace);
        EXPECT_FALSE(read->headingDeg);
    }
    EXPECT_EQ(parseSurveyLine("101,498765.432,5150123.456,287.654")->name, "101");
}

TEST(SurveyLine, HeadingPitchAndRollMayFollow) {
    const auto four = parseSurveyLine("498765.432 5150123.456 287.654 217.4");
    ASSERT_TRUE(four);
    EXPECT_EQ(four->headingDeg, 217.4);
    EXPECT_FALSE(four->pitchDeg);
    const auto six = parseSurveyLine("101; 498765.432; 5150123.456; 287.654; 217.4; 14.25; -3.4");
    ASSERT_TRUE(six);
    EXPECT_EQ(six->name, "101");
    EXPECT_EQ(six->enhM, kPlace);
    EXPECT_EQ(six->headingDeg, 217.4);
    EXPECT_EQ(six->pitchDeg, 14.25);
    EXPECT_EQ(six->rollDeg, -3.4);
}

TEST(SurveyLine, TheOrderIsThatAskedForOrThatOfTheLetters) {
    EXPECT_EQ(placeOf("5150123.456, 498765.432, 287.654", SurveyOrder::NorthingFirst), kPlace);
    for (const char* line : {"N 5150123.456 E 498765.432 RL 287.654", "E=498765.432 N=5150123.456 RL=287.654",
                             "P7 Z: 287.654; Northing: 5150123.456; Easting: 498765.432"})
        EXPECT_EQ(placeOf(line), kPlace) << line;
}

TEST(SurveyLine, WhatAllowsTwoReadingsIsRefused) {
    for (const char* line : {"", "   ", "P7", "498765.432", "498765.432, 5150123.456", "1.5 2.5 3.5 4.5 5.5", "498765 5150123 287 90",
                             "E 498765.4 N 5150123.4", "nan nan nan", "1 2 3 4 5 6 7 8", "312,345.678; 5,150,023.456; 87.6",
                             "E 312,345.678 N 5150023.456 RL 87.6", "-312,345.678,5150023.456,87.6"}) {
        const auto read = parseSurveyLine(line);
        EXPECT_FALSE(read) << line;
        EXPECT_TRUE(read || read.error().sentence().ends_with(".")) << line;
    }
}

TEST(SurveyLine, AsManyNumbersAsAskedFor) {
    EXPECT_EQ(typedNumbers("498765,432", 1), std::vector<double>{498765.432});
    EXPECT_EQ(typedNumbers("0.2, -0.1, 0.15", 3), (std::vector<double>{0.2, -0.1, 0.15}));
    EXPECT_EQ(typedNumbers("0,2 -0,1 0,15", 3), (std::vector<double>{0.2, -0.1, 0.15}));
    EXPECT_EQ(typedNumbers("1,2,3", 3), (std::vector<double>{1, 2, 3}));
    for (const char* text : {"", "x", "1 2", "1 2 3 4", "1 2 x"}) EXPECT_TRUE(typedNumbers(text, 3).empty()) << text;
}
