// No setting removes a cell from a scan or changes it (docs/reference/rules.md, "S18").
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::edges;

TEST(Filters, WhateverIsSetTheScanStaysAndItsCellsAddUp) {
    Scan made = test::boxesScan(40, 60, 5);
    for (std::size_t k = 3; k < made.cells(); k += 7) made.state[k] = static_cast<CellState>(k % kCellStates);
    const auto scan = std::make_shared<const Scan>(std::move(made));
    const Scan before = *scan;
    Pipeline pipeline;
    int turned = 0;
    for (const Parameter& parameter : parameters()) {
        for (const double value : {parameter.minimum, parameter.maximum}) {
            Settings settings;
            parameter.set(settings, value);
            if (!checkSettings(settings)) continue;
            ++turned;
            const auto detection = pipeline.run(scan, settings);
            ASSERT_EQ(detection->scan, scan) << parameter.key;
            ASSERT_EQ(detection->scan->rangeMm, before.rangeMm) << parameter.key;
            ASSERT_EQ(detection->scan->state, before.state) << parameter.key;
            ASSERT_EQ(detection->mask->cells.size(), scan->cells()) << parameter.key;
        }
    }
    EXPECT_GT(turned, 20);
}
