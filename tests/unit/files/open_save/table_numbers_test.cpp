// Words about the numbers of a table.
#include "core/files/open_save/table_numbers.h"

#include <gtest/gtest.h>

using namespace edgescan;

TEST(TableNumbers, NumbersThatNoWholeNumberHoldsAreWrittenAsTheyAre) {
    struct {
        float largest;
        const char* words;
    } const cases[]{{498765.0F, "numbers up to 498765 "},
                    {-1234567.0F, "numbers up to 1234567 "},
                    {1e30F, "numbers up to 1e+30 "},
                    {-3e38F, "numbers up to 3e+38 "}};
    for (const auto& [largest, words] : cases) {
        files::PointTable table;
        table.points = {{1.0, 2.0, 3.0}, {static_cast<double>(largest), 0.0, 0.0}};
        EXPECT_TRUE(files::coarseStep(table).starts_with(words)) << files::coarseStep(table);
    }
}
