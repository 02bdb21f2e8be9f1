// edgescan-cli: the method without a display.
#include "app/cli/commands.h"
#include "core/base/version.h"

#include <exception>
#include <iostream>
#include <new>

int main(int argc, char** argv) {
    using namespace edgescan;
    CLI::App app{"EdgeScan: the edges of rocks in a laser range scan"};
    app.set_version_flag("--version", version());
    app.require_subcommand(1);
    int code = cli::kDone;
    cli::addInfo(app, code);
    cli::addDetect(app, code);
    cli::addConvert(app, code);
    cli::addSimulate(app, code);
    cli::addEvaluate(app, code);
    cli::addVerify(app, code);
    cli::addServe(app, code);
    cli::addRecord(app, code);
    cli::addReplay(app, code);
    cli::addWhy(app, code);
    cli::addCompare(app, code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // Help and version end here too, with code 0.
        return app.exit(error) == 0 ? cli::kDone : cli::kWrongUsage;
    } catch (const std::bad_alloc&) {
        std::cerr << "edgescan-cli: there is not enough memory for this scan; close other programs or use a smaller scan.\n";
        return cli::kRefused;
    } catch (const std::exception& error) {
        std::cerr << "edgescan-cli: " << error.what() << "; this should not happen, please report it.\n";
        return cli::kRefused;
    }
    std::cout.flush();
    if (std::cout.good()) return code;
    std::cerr << "edgescan-cli: stdout: the results cannot be written (no space, or closed); send them elsewhere.\n";
    return cli::kRefused;
}
