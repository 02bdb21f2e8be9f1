// Scans of heaps of real stones, with exact truth.
#pragma once

#include "app/lab/sim/truth/truth_files.h"
#include "app/lab/stones/heap.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace edgescan::lab {

/// What is scanned, and how. The same values give the same bytes on one machine, for any number of threads.
struct StoneScene {
    std::string kind = "bench";         ///< one of siteKinds()
    std::string set = "free";           ///< one of stoneSets()
    std::uint64_t seed = 1;             ///< of walls, stones and noise
    int view = 0;                       ///< 1, 2, ...: the same heap from a moved scanner
    bool full = false;                  ///< 800 lines x 1000 beams instead of 400 x 500, over the same angles
    bool spin = false;                  ///< the scanner turns about its viewing direction, by 180 degrees, instead of sweeping over 80
    bool carved = false;                ///< carvedStone() of each stone, where the whole one rests
    double noise = 1.0;                 ///< factor on the range noise of the device
    std::filesystem::path settled = {}; ///< folder of settled heaps: read if the heap is there, else written. Empty: none
};

struct StoneScan {
    sim::Simulation simulation; ///< scan: name "bench-free-seed1-view0", format "simulated"; truth: its rocks are the stones
    sim::TruthSet truth;
};

/// Settles the stones unless the folder has the heap, scans them, and finds the true edges. @param stones readStones() of the scene's set
/// or of "all" @param threads 0: one per core; the physics uses one. Error: unknown kind or set, a stone of the heap that is not there, a
/// file, "cancelled".
Result<StoneScan> stoneScan(const StoneScene& scene, const Stones& stones, int threads = 0, const StoneProgress& progress = {});

/// The heap of a scene: from its folder, or settled and then stored there.
Result<Heap> heapOf(const StoneScene& scene, const Site& site, const Stones& stones, const StoneProgress& progress = {});

} // namespace edgescan::lab
