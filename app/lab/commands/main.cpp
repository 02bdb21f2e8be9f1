// edgescan-lab: makes scans, and measures how good the methods are, against ground truth, against PCL and on a second scan of the same
// place.
#include "app/lab/commands/commands.h"
#include "app/shared/exits.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/inputs.h"

using namespace edgescan;

int main(int argc, char** argv) {
    cli::setProgramName("edgescan-lab");
    CLI::App app{"EdgeScan's measures: every method on one scan, against ground truth and on two scans of one place"};
    app.set_version_flag("--version", cli::versionText());
    app.require_subcommand(1);
    int code = cli::kDone;
    cli::surviveFileLimit();
    const BindInputs inputs; // no input file can be overwritten
    cli::addBenchmark(app, code);
    cli::addRepeatability(app, code);
    cli::addEvaluate(app, code);
    cli::addClicks(app, code);
    cli::addFamilies(app, code);
    cli::addLearnBorders(app, code);
    cli::addLearnConfidence(app, code);
    cli::addLearnEdges(app, code);
    cli::addLearnRocks(app, code);
    cli::addStones(app, code);
    cli::addSimulate(app, code);
    cli::addEmulate(app, code);
    cli::addCalibrate(app, code);
    cli::addPages(
        app,
        {"edgescan-lab",
         "measures how good edge detection is",
         {"edgescan-lab simulate -o BELL.json --truth TRUTH --seed 7 --lines 300 --beams 381",
          "edgescan-lab evaluate BELL.json --truth TRUTH", "edgescan-lab benchmark BELL.json --truth TRUTH --no-peers --repeats 1"},
         {},
         {{"benchmark",
           "Methods",
           {"edgescan-lab benchmark BELL.json --truth TRUTH --only thesis,edgescan+ --repeats 1 --pictures SHEETS"},
           {}},
          {"evaluate", "Methods", {"edgescan-lab evaluate BELL.json --truth TRUTH --sweep --thresholds 0.5,1,2 --json SCORES.json"}, {}},
          {"repeatability",
           "Two scans",
           {"edgescan-lab repeatability BELL.json AGAIN.json --poses-3dtk A.pose B.pose --only edgescan+ --json REPEATED.json"},
           {}},
          {"clicks", "Lengths", {"edgescan-lab clicks --scene hangup --seeds 1 --clicks 50 --lines 120 --beams 160"}, {}},
          {"families",
           "Methods",
           {"edgescan-lab families --family staircase --scenes 1 --with default --with old='--preset default-3' --store SCORES --json "
            "FAMILIES.json",
            "edgescan-lab families --family staircase --scenes 1 --with default --store SCORES --against FAMILIES.json"},
           {{"3", "a change does not pass, or a recorded figure fell"}}},
          {"learn-borders", "Weights", {"edgescan-lab learn-borders -o border_weights.inc --rounds 1 --lines 60 --beams 80"}, {}},
          {"learn-confidence",
           "Weights",
           {"edgescan-lab learn-confidence -o confidence_trees.inc --lines 60 --beams 80 --only hangup --scenes 1"},
           {}},
          {"learn-edges", "Weights", {"edgescan-lab learn-edges -o border_trees.inc --only hangup --scenes 1 --trees 2"}, {}},
          {"learn-rocks", "Weights", {"edgescan-lab learn-rocks -o merge_trees.inc --only hangup --scenes 1 --trees 2"}, {}},
          {"stones",
           "Scans",
           {"edgescan-lab stones --stones STONES --kind bench --seed 1 --settled HEAPS -o HEAP.json --truth HEAP-TRUTH"},
           {}},
          {"simulate", "Scans", {"edgescan-lab simulate -o BELL.json --truth TRUTH --seed 7 --lines 300 --beams 381"}, {}},
          {"emulate", "Scans", {"edgescan-lab emulate BELL.json --port 2112 --rate 25"}, {}},
          {"calibrate",
           "Scanner",
           {"edgescan-lab simulate -o TURN.json --axis spin --turn 220 --lines 330 --beams 191 --mount-t1 30",
            "edgescan-lab calibrate TURN.json -o CALIBRATION.json"},
           {}}}});
    return cli::exitCodeOf([&] { return cli::parsed(app, argc, argv).value_or(code); });
}
