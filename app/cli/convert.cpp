// edgescan-cli convert: any readable scan to any writable format.
#include "app/cli/commands.h"
#include "app/cli/export_flags.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"

#include <array>
#include <memory>

namespace edgescan::cli {
namespace {

struct Convert {
    std::string in, out;
    ReadFlags read;
    WriteFlags write;
};

int run(const Convert& convert) {
    const exports::ExportKind& whole = exports::exportKind(exports::ExportContent::WholeScan);
    if (auto known = exports::checkExtension(whole, convert.out, convert.out, ", "); !known) {
        Error unknown = known.error();
        if (const std::string flags = flagsFor(convert.out); !flags.empty()) unknown.hint += "; such a file is made by " + flags;
        return failWith(unknown, kWrongUsage);
    }
    if (auto used = checkWriting(convert.write, {{&whole, convert.out}}); !used) return failWith(used.error(), kWrongUsage);
    claimInput(convert.in);
    if (auto can = checkOutputs(std::array{convert.out}); !can) return failWith(can.error());
    Result<Scan> opened = openAndWarn(convert.in, convert.read);
    if (!opened) return failWith(opened.error());
    edges::Detection detection;
    detection.scan = std::make_shared<const Scan>(std::move(*opened));
    const Scan& scan = *detection.scan;
    warnOfIdleWriting(convert.write, scan);
    const exports::ExportOptions options = exportOptions(convert.write, scan, convert.out);
    const std::vector<std::string> lost = files::lostOnSaving(
        scan, convert.out,
        {.ascii = options.ascii, .frame = options.frame, .includeAttached = options.includeAttached, .choices = options.choices});
    const auto saved = exports::exportWithProvenance(exports::ExportContent::WholeScan, detection, convert.out, options);
    if (!saved) return failWith(saved.error());
    for (const std::string& sentence : lost) printError(printable(convert.in) + ": " + sentence);
    printError(printable(convert.in) + ": " + std::to_string(scan.lines()) + " lines x " + std::to_string(scan.beams()) +
               " beams; written to " + placesText({convert.out}) + ".");
    printError(placesText({convert.out}) + ": " + exports::coordinatesText(*saved->coordinates));
    return kDone;
}

} // namespace

void addConvert(CLI::App& app, int& code) {
    auto convert = std::make_shared<Convert>();
    CLI::App& command = *app.add_subcommand("convert", "Converts any readable scan to any writable format, with its grid");
    command.add_option("IN", convert->in, "Scan")->required();
    command.add_option("OUT", convert->out, "New file: " + files::writtenExtensions(true) + " (.json: raw grid, .mcap: recording)")
        ->required();
    addReadFlags(command, convert->read);
    addWriteFlags(command, convert->write);
    command.callback([convert, &code] { code = run(*convert); });
}

} // namespace edgescan::cli
