// edgescan-cli report: one page about a scan, for any browser.
#include "app/cli/commands.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "core/base/shell_quoted.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/method/pipeline.h"
#include "core/method/work_memory.h"
#include "core/page/scan_page.h"

#include <memory>

namespace edgescan::cli {
namespace {

struct ReportCommand {
    std::string file, out, operatorName, role;
    ReadFlags read;
    MethodFlags method;
};

std::string commandOf(const ReportCommand& report) {
    std::string command = "edgescan-cli report " + shellQuoted(report.file) + " -o " + shellQuoted(report.out);
    for (const std::string& flags : {typedFlags(report.method), readingFlags(report.read.options)})
        command += flags.empty() ? "" : " " + flags;
    if (!report.operatorName.empty()) command += " --operator " + shellQuoted(report.operatorName);
    if (!report.role.empty()) command += " --role " + shellQuoted(report.role);
    return command;
}

Result<Done> make(const ReportCommand& report) {
    Result<Scan> opened = openAsAsked(report.file, readingOptions(report.read));
    if (!opened) return opened.error();
    if (auto enough = checkMemoryFor(Work::Detect, *opened); !enough) return enough.error();
    const Result<Settings> settings = settingsFor(report.method, *opened);
    if (!settings) return settings.error();
    const auto detection = detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings);
    const std::string page = scanPage(*detection, {commandOf(report), report.operatorName, report.role, utcText(utcNow())});
    return writeWholeFile(report.out, page);
}

int run(const ReportCommand& report) {
    if (const auto method = checkMethod(report.method); !method) {
        complain(method.error());
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
    addMethodFlags(command, report->method);
    addReadFlags(command, report->read);
    command.callback([report, &code] { code = run(*report); });
}

} // namespace edgescan::cli
