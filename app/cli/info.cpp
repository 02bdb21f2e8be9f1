// edgescan-cli info: one JSON object per file.
#include "app/cli/commands.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "core/exports/report.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace edgescan::cli {
namespace {

struct Info {
    std::vector<std::string> files;
    ReadFlags read;
};

int run(const Info& info) {
    int code = kDone;
    for (const std::string& file : info.files) {
        const auto one = [&] {
            const Result<Scan> scan = files::openAsAsked(file, readingOptions(info.read));
            printResult(scan ? document("info", exports::infoReport(*scan)) : refusal("info", file, scan.error()), false);
            if (!scan) printError(scan.error());
            return scan ? kDone : kRefused;
        };
        if (guarded(one, kRefused) != kDone) code = kRefused;
    }
    return code;
}

} // namespace

void addInfo(CLI::App& app, int& code) {
    auto info = std::make_shared<Info>();
    CLI::App& command = *app.add_subcommand("info", "What a file holds: one JSON object per file on stdout");
    command.add_option("FILE", info->files, "Scans")->required();
    addReadFlags(command, info->read);
    command.callback([info, &code] { code = run(*info); });
}

} // namespace edgescan::cli
