// edgescan-cli: the method without a display.
#include "app/cli/commands.h"
#include "app/shared/exits.h"
#include "app/shared/interrupt.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/inputs.h"
#include "core/base/version.h"

int main(int argc, char** argv) {
    using namespace edgescan;
    CLI::App app{"EdgeScan: the edges of rocks in a laser range scan"};
    app.set_version_flag("--version", version());
    app.require_subcommand(1);
    int code = cli::kDone;
    cli::surviveFileLimit();
    const BindInputs inputs; // nothing that is read is written over
    cli::addInfo(app, code);
    cli::addDetect(app, code);
    cli::addBatch(app, code);
    cli::addReport(app, code);
    cli::addConvert(app, code);
    cli::addSimulate(app, code);
    cli::addEvaluate(app, code);
    cli::addVerify(app, code);
    cli::addAudit(app, code);
    cli::addServe(app, code);
    cli::addRecord(app, code);
    cli::addReplay(app, code);
    cli::addWhy(app, code);
    cli::addRocks(app, code);
    cli::addCompare(app, code);
    cli::addChange(app, code);
    cli::addCalibrate(app, code);
    cli::addThumbnail(app, code);
    cli::addPages(app,
                  {"edgescan-cli",
                   "edges of rocks in laser range scans",
                   {"edgescan-cli simulate -o BELL.json --truth TRUTH --seed 7 --lines 300 --beams 381", "edgescan-cli detect BELL.json",
                    "edgescan-cli detect BELL.json -o RESULTS --jump 40", "edgescan-cli convert BELL.json BELL.pcd",
                    "edgescan-cli evaluate BELL.json --truth TRUTH", "edgescan-cli verify RESULTS/BELL_edges.png --scans ."}});
    const int ended = cli::guarded([&] { return cli::parsed(app, argc, argv).value_or(code); }, cli::kRefused);
    if (cli::everythingWasSaid()) return ended;
    cli::complain("stdout: the results cannot be written (no space, or closed); send them elsewhere.");
    return cli::kRefused;
}
