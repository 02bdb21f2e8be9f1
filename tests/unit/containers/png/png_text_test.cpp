// The text of a picture, also of a damaged one: libpng prints nothing.
#include "core/containers/png/png.h"

#include <gtest/gtest.h>

#include <random>

namespace edgescan::containers {
namespace {

TEST(PngText, ADamagedPictureGivesItsTextOrNoneAndPrintsNothing) {
    const std::string record(3000, 'r');
    const std::string picture = *png8Bytes(Grid<std::uint8_t>(20, 30, 7), "x.png", record);
    ASSERT_EQ(pngText(picture, kPngRecordKeyword), record);
    EXPECT_EQ(pngText(picture, "another key"), "");
    EXPECT_EQ(pngText("", kPngRecordKeyword), "");
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::mt19937 random(21);
    for (int n = 0; n < 4000; ++n) {
        std::string damaged = picture;
        if (n % 3 == 0) damaged.resize(random() % damaged.size());
        for (auto times = 1 + random() % 4; times > 0 && !damaged.empty(); --times)
            damaged[random() % std::min<std::size_t>(damaged.size(), n % 2 == 0 ? 60 : damaged.size())] = static_cast<char>(random());
        const std::string text = pngText(damaged, kPngRecordKeyword);
        EXPECT_TRUE(text.empty() || text.size() <= record.size());
        static_cast<void>(pngValues(damaged, "x.png"));
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(BarePng, IsThePictureWithoutTextsAndRefusesWhatIsNone) {
    const std::string picture = *png8Bytes(Grid<std::uint8_t>(20, 30, 7), "x.png", "secret");
    const auto bare = barePng(picture + "behind it", 1000, "logo.png");
    ASSERT_TRUE(bare) << bare.error().sentence();
    EXPECT_EQ(bare->find("secret"), std::string::npos);
    EXPECT_EQ(bare->find("behind it"), std::string::npos);
    ASSERT_TRUE(barePng(*bare, 600, "logo.png"));
    EXPECT_FALSE(barePng(picture, 599, "logo.png"));
    for (std::size_t length = 0; length < picture.size() - 12; length += 7) // the last 12 bytes only say that it ends
        EXPECT_FALSE(barePng(picture.substr(0, length), 1000, "logo.png")) << length;
    std::string huge = picture;
    huge[16] = '\x7f'; // of the width
    EXPECT_FALSE(barePng(huge, 1000, "logo.png"));
}

} // namespace
} // namespace edgescan::containers
