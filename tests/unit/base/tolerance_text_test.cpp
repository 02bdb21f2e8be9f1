// A tolerance is never written as zero.
#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"

#include <gtest/gtest.h>

using namespace edgescan;

TEST(ToleranceText, IsNeverZeroUnlessItIsNotKnown) {
    for (int decimals = 0; decimals <= 4; ++decimals) {
        const std::string zero = fixedText(0, decimals);
        EXPECT_EQ(fixedText(shownTolerance(0, decimals), decimals), zero);
        for (double tolerance = 1e-9; tolerance < 10; tolerance *= 1.7) {
            EXPECT_NE(fixedText(shownTolerance(tolerance, decimals), decimals), zero) << tolerance;
            EXPECT_GE(shownTolerance(tolerance, decimals), tolerance);
        }
    }
    EXPECT_EQ(shownTolerance(0.009, 3), 0.009);
    EXPECT_EQ(fixedText(shownTolerance(0.0004, 3), 3), "0.001");
}
