// edgescan-cli report: one page about a scan, for any browser.
#include "app/cli/commands.h"
#include "app/cli/rock_flags.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "core/base/shell_quoted.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/method/pipeline.h"
#include "core/method/work_memory.h"
#include "core/page/scan_page.h"

#include <memory>
#include <optional>

namespace edgescan::cli {
namespace {

struct ReportCommand {
    std::string file, out, operatorName, role;
    bool withRocks = false;
    RockFlags rocks;
    ReadFlags read;
    MethodFlags method;
};

std::string commandOf(const ReportCommand& report) {
    std::string command = "edgescan-cli report " + shellQuoted(report.file) + " -o " + shellQuoted(report.out);
    for (const std::string& flags : {typedFlags(report.method), readingFlags(report.read.options),
                                     report.withRocks ? std::string("--rocks") : std::string(), typedFlags(report.rocks)})
        command += flags.empty() ? "" : " " + flags;
    if (!report.operatorName.empty()) command += " --operator " + shellQuoted(report.operatorName);
    if (!report.role.empty()) command += " --role " + shellQuoted(report.role);
    return command;
}

Result<Done> make(const ReportCommand& report) {
    Result<Scan> opened = openAsAsked(report.file, readingOptions(report.read));
    if (!opened) return opened.error();
    if (auto enough = checkMemoryFor(report.withRocks ? Work::Rocks : Work::Detect, *opened); !enough) return enough.error();
    const Result<Settings> settings = settingsFor(report.method, *opened);
    if (!settings) return settings.error();
    const auto preset = presetOf(report.rocks, *opened);
    if (!preset) return preset.error();
    const auto detection =
        detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings, report.withRocks ? KeepFor::Rocks : KeepFor::Edges);
    std::optional<RockStudy> rocks;
    if (report.withRocks) rocks = studyRocks(rockInputs(*detection), *preset->settings, preset->edits);
    const PageWords words{commandOf(report), report.operatorName, report.role, utcText(utcNow())};
    const std::string page = scanPage(*detection, words, rocks ? &*rocks : nullptr);
    return writeWholeFile(report.out, page);
}

int run(ReportCommand& report) {
    if (const auto method = checkMethod(report.method); !method) {
        complain(method.error());
        return kWrongUsage;
    }
    if (const auto rocks = checkRocks(report.rocks); !rocks) {
        complain(rocks.error());
        return kWrongUsage;
    }
    if (!report.withRocks && anyTyped(report.rocks)) {
        complain(Error{"these flags are of rocks, and the report has none", "report", "add --rocks"});
        return kWrongUsage;
    }
    const auto made = make(report);
    if (made) return kDone;
    complain(made.error());
    return kRefused;
}

} // namespace

void addReport(CLI::App& app, int& code) {
    auto report = std::make_shared<ReportCommand>();
    CLI::App& command = *app.add_subcommand("report", "One page about a scan that opens in any browser, without a network");
    command.add_option("SCAN", report->file, "The scan")->required();
    command.add_option("-o,--output", report->out, "New file: .html; - is stdout")->required();
    command.add_option("--operator", report->operatorName, "Who makes the report");
    command.add_option("--role", report->role, "As what");
    command.add_flag("--rocks", report->withRocks, std::string("With the rocks between the edges: ") + kRockCaveat)->group("Rocks");
    addRockFlags(command, report->rocks, true);
    addMethodFlags(command, report->method);
    addReadFlags(command, report->read);
    command.callback([report, &code] { code = run(*report); });
}

} // namespace edgescan::cli
