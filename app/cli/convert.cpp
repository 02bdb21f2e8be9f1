// edgescan-cli convert: any readable scan to any writable format.
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "core/files/save_scan.h"

#include <iostream>
#include <memory>

namespace edgescan::cli {
namespace {

struct Convert {
    std::string in, out;
    bool ascii = false;
    ReadFlags read;
};

int run(const Convert& convert) {
    if (!saveFormatOf(convert.out)) {
        complain({"the extension names no format that can be written", convert.out, "use .json, .pcd, .ply, .csv or .xyz"});
        return kWrongUsage;
    }
    const Result<Scan> scan = openScan(convert.in, openOptions(convert.read));
    if (!scan) {
        complain(scan.error());
        return kRefused;
    }
    for (const std::string& warning : scan->warnings) std::cerr << "edgescan-cli: " << convert.in << ": " << warning << '\n';
    const Result<Done> saved = saveScan(*scan, convert.out, {convert.ascii});
    if (saved) return kDone;
    complain(saved.error());
    return kRefused;
}

} // namespace

void addConvert(CLI::App& app, int& code) {
    auto convert = std::make_shared<Convert>();
    CLI::App& command = *app.add_subcommand("convert", "Any readable scan to any writable format; the grid stays");
    command.add_option("IN", convert->in, "Scan")->required();
    command.add_option("OUT", convert->out, "New file: .json (raw grid) .pcd .ply .csv .xyz")->required();
    command.add_flag("--ascii", convert->ascii, "PCD and PLY as text");
    addReadFlags(command, convert->read);
    command.callback([convert, &code] { code = run(*convert); });
}

} // namespace edgescan::cli
