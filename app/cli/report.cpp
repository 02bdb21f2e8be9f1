// edgescan-cli report: one HTML page about a scan.
#include "app/cli/commands.h"
#include "app/cli/export_flags.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/shell_quoted.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/html/scan_page.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

namespace edgescan::cli {
namespace {

struct ReportCommand {
    std::string file, out, operatorName, role, targets, before, site, remark, logo;
    bool withRocks = false;
    RockFlags rocks;
    ReadFlags read;
    MethodFlags method;
};

std::string commandOf(const ReportCommand& report) {
    std::string command = "edgescan-cli report " + shellQuoted(fileName(report.file)) + " -o " + shellQuoted(fileName(report.out));
    for (const std::string& flags : {typedFlags(report.method), readingFlags(exports::withNames(report.read.options)),
                                     report.withRocks ? std::string("--rocks") : std::string(), typedFlags(report.rocks)})
        command += flags.empty() ? "" : " " + flags;
    if (!report.targets.empty()) command += " --targets " + shellQuoted(fileName(report.targets));
    if (!report.before.empty()) command += " --before " + shellQuoted(fileName(report.before));
    if (!report.operatorName.empty()) command += " --operator " + shellQuoted(report.operatorName);
    if (!report.role.empty()) command += " --role " + shellQuoted(report.role);
    if (!report.site.empty()) command += " --site " + shellQuoted(report.site);
    if (!report.remark.empty()) command += " --remark " + shellQuoted(report.remark);
    if (!report.logo.empty()) command += " --logo " + shellQuoted(fileName(report.logo));
    return command;
}

Result<inspect::Notebook> notebookOf(const ReportCommand& report, const Scan& scan) {
    const auto bytes = readInput(report.targets);
    if (!bytes) return bytes.error();
    return inspect::notebookFromText(textOf(*bytes), inspect::notebookScan(scan), report.targets);
}

Result<inspect::SceneChange> changeSince(const ReportCommand& report, const edges::Detection& now) {
    Result<Scan> before = openAndWarn(report.before, report.read);
    if (!before) return before.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *before); !enough) return enough.error();
    const auto earlier = edges::detectEdges(std::make_shared<const Scan>(std::move(*before)), now.settings);
    return inspect::sceneChange({now.scan, now.mask}, {earlier->scan, earlier->mask});
}

Result<std::string> logoOf(const ReportCommand& report) {
    if (report.logo.empty()) return std::string();
    const auto bytes = readInput(report.logo);
    return bytes ? exports::logoFrom(textOf(*bytes), report.logo) : bytes.error();
}

/// This program writes pages. A browser prints them.
Result<Done> checkOutput(const std::string& out) {
    const std::string extension = std::filesystem::path(out).extension().string();
    if (isStreamOrDevice(out) || extension == ".html" || extension == ".htm") return Done{};
    return Error{"the report is HTML", out,
                 "give a name that ends with .html; a browser prints it as PDF: chromium --headless --print-to-pdf=report.pdf report.html"};
}

Result<Done> make(const ReportCommand& report) {
    const Result<std::string> logo = logoOf(report);
    if (!logo) return logo.error();
    Result<Scan> opened = openAndWarn(report.file, report.read);
    if (!opened) return opened.error();
    if (auto enough = edges::checkMemoryFor(report.withRocks ? edges::Work::Rocks : edges::Work::Detect, *opened); !enough)
        return enough.error();
    const Result<edges::Settings> settings = settingsFor(report.method, *opened);
    if (!settings) return settings.error();
    const auto preset = presetOf(report.rocks, *opened);
    if (!preset) return preset.error();
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings,
                                              report.withRocks ? edges::KeepFor::Rocks : edges::KeepFor::Edges);
    std::optional<rocks::Study> rocks;
    if (report.withRocks) rocks = rocks::studyRocks(rocks::rockInputs(*detection), *preset->settings, preset->edits);
    const exports::PageWords words{commandOf(report), report.operatorName, report.role, utcText(utcNow()),
                                   report.site,       report.remark,       *logo};
    exports::PageNotes notes{rocks ? &*rocks : nullptr, nullptr, nullptr, fileName(report.before)};
    std::optional<inspect::Notebook> notebook;
    if (!report.targets.empty()) {
        auto read = notebookOf(report, *detection->scan);
        if (!read) return read.error();
        notes.notebook = &notebook.emplace(std::move(*read));
    }
    std::optional<inspect::SceneChange> change;
    if (!report.before.empty()) {
        auto found = changeSince(report, *detection);
        if (!found) return found.error();
        for (const std::string& warning : found->earlier.how.warnings) printError(printable(report.before) + ": " + warning);
        notes.change = &change.emplace(std::move(*found));
    }
    const std::string page = exports::scanPage(*detection, words, notes);
    if (auto written = writeWholeFile(report.out, page); !written) return written;
    printError(printable(report.file) + ": a report of " + fixedText(static_cast<double>(page.size()) / 1e6, 1) + " MB; written to " +
               placesText({report.out}) + ".");
    return Done{};
}

int run(ReportCommand& report) {
    if (const auto right = checkOutput(report.out); !right) return failWith(right.error(), kWrongUsage);
    if (const auto method = checkMethodAndWarn(report.method); !method) return failWith(method.error(), kWrongUsage);
    if (const auto rocks = checkRocks(report.rocks); !rocks) return failWith(rocks.error(), kWrongUsage);
    if (!report.withRocks && anyTyped(report.rocks))
        return failWith(Error{"these flags are of rocks, and the report has none", typedFlags(report.rocks), "add --rocks"}, kWrongUsage);
    if (const auto one = report.before.empty() ? Result<Done>(Done{}) : checkOnePose({report.file, report.before}, report.read); !one)
        return failWith(one.error(), kWrongUsage);
    claimInput(report.file);
    if (const auto can = checkOutputs(std::array{report.out}); !can) return failWith(can.error());
    const auto made = make(report);
    return made ? kDone : failWith(made.error());
}

} // namespace

void addReport(CLI::App& app, int& code) {
    auto report = std::make_shared<ReportCommand>();
    CLI::App& command = *app.add_subcommand("report", "Writes one page about a scan that any browser opens without a network");
    command.add_option("SCAN", report->file, "The scan")->required();
    command
        .add_option(
            "-o,--output", report->out,
            "New file: .html; - is standard output. A browser prints it as PDF: chromium --headless --print-to-pdf=report.pdf report.html")
        ->type_name("FILE")
        ->required();
    command.add_option("--operator", report->operatorName, "Name of the operator")->type_name("NAME");
    command.add_option("--role", report->role, "Role of the operator")->type_name("NAME");
    command.add_option("--site", report->site, "The site, for the head of the report")->type_name("NAME");
    command.add_option("--remark", report->remark, "A remark for the report; it may have several lines");
    command.add_option("--logo", report->logo, "A PNG picture for the head of the report")->type_name("FILE");
    command.add_option("--targets", report->targets, "Targets and measurements on the scan: the viewer's file (docs/guide/measure.md)")
        ->type_name("FILE");
    command.add_option("--before", report->before, "An earlier scan of the same place: what changed since, with the same settings")
        ->type_name("FILE");
    command.add_flag("--rocks", report->withRocks, std::string("With the rocks between the edges: ") + rocks::kRockCaveat)->group("Rocks");
    addRockFlags(command, report->rocks, true);
    addMethodFlags(command, report->method);
    addReadFlags(command, report->read);
    command.callback([report, &code] { code = run(*report); });
}

} // namespace edgescan::cli
