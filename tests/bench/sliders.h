// The cost of EdgeScan+'s sliders.
#pragma once

#include "tests/bench/goals.h"

namespace edgescan::bench {

/// A full run with default settings, without the pipeline.
void runPlus(const Scan& scan, int threads);

/// Measures one slider of each kind, on one thread, in units of a full run.
void measureSliders(const Scan& scan, int rounds, Table& table);

} // namespace edgescan::bench
