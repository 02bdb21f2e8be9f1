// edgescan-cli replay: plays a recording through the live path. Prints a JSON line per received scan line, and the edges of the sweep at
// the end.
#include "app/cli/commands.h"
#include "app/cli/live_report.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/report.h"
#include "core/files/open_save/open_scan.h"
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

namespace edgescan::cli {
namespace {

struct ReplayWanted {
    std::string file;
    std::string json = "-";
    double speed = 0.0;
    bool quiet = false;
    ReadingOptions place;
    MethodFlags method;
};

nlohmann::ordered_json lineReport(const scanner::PlayedLine& played) {
    const scanner::SweepProgress& progress = played.progress;
    return {{"line", played.line},
            {"sweep", progress.number},
            {"row", progress.lines - 1},
            {"lost", progress.lost.size()},
            {"duplicates", progress.duplicates},
            {"time_ns", played.timeNs},
            {"irregular", irregularReport(progress.irregularEver)}};
}

// Waits until the next line is due: the recorded delay divided by the speed. Speed 0 does not wait.
void waitForNextLine(const scanner::PlayedLine& played, double speed) {
    if (speed <= 0 || played.nextNs == 0) return;
    const double ns = static_cast<double>(played.nextNs - played.timeNs) / speed;
    std::this_thread::sleep_for(std::chrono::nanoseconds(static_cast<std::int64_t>(std::max(0.0, ns))));
}

int run(const ReplayWanted& wanted) {
    if (const auto method = checkMethodAndWarn(wanted.method); !method) return failWith(method.error(), kWrongUsage);
    std::error_code none;
    if (!std::filesystem::exists(wanted.file, none) && wanted.file.find_first_not_of("0123456789.:") == std::string::npos)
        return failWith(Error{"this is the address of a scanner and not a file", wanted.file, "record records it"}, kWrongUsage);
    JsonLines json(wanted.json);
    auto scan = files::openScan(wanted.file, wanted.place, [&](const scanner::PlayedLine& played) {
        if (!wanted.quiet) json.add(document("replay-line", lineReport(played)));
        waitForNextLine(played, wanted.speed);
    });
    if (scan && scan->format != "recording" && !scan->format.starts_with("ROS ") && scan->format != "PointCloud2")
        scan = Error{"this file is not a recording", wanted.file, "open it with detect"};
    if (!scan) return failWith(scan.error());
    const Result<edges::Settings> settings = settingsFor(wanted.method, *scan);
    if (!settings) return failWith(settings.error());
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*scan)), *settings);
    json.add(document("replay", {{"result", document("detect", exports::detectReport(*detection, 0.0))}}));
    return json.ended(kDone);
}

} // namespace

void addReplay(CLI::App& app, int& code) {
    auto wanted = std::make_shared<ReplayWanted>();
    CLI::App& command = *app.add_subcommand(
        "replay", "Plays a recording like a live scanner; prints a line of JSON per scan line, and the edges at the end");
    command.add_option("FILE", wanted->file, "Recording (.mcap), or the bag of a laser")->required();
    addNumber(command, "--speed", wanted->speed, {0, 1e6}, "1 = as it was recorded; 0 = as fast as possible");
    command.add_flag("--quiet", wanted->quiet, "Only the edges at the end");
    addJsonFlag(command, wanted->json, "One JSON object per scan line, then the edges", {"replay-line", "replay"}).capture_default_str();
    addPlaceFlags(command, wanted->place);
    addMethodFlags(command, wanted->method);
    command.callback([wanted, &code] { code = run(*wanted); });
}

} // namespace edgescan::cli
