// edgescan-cli replay: a recording through the live path, a JSON line per line received, and the edges of the sweep at the end.
#include "core/recording/replay.h"
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "core/base/sha256.h"
#include "core/method/pipeline.h"
#include "core/recording/recorded_robot.h"
#include "core/report/report.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

namespace edgescan::cli {
namespace {

struct ReplayWanted {
    std::string file;
    double speed = 0.0;
    bool quiet = false;
    ReadingOptions place;
    MethodFlags method;
};

nlohmann::ordered_json lineReport(const Replay& replay) {
    const SweepProgress progress = replay.progress();
    return {{"line", replay.position() - 1}, {"sweep", progress.number},          {"row", progress.lines - 1},
            {"lost", progress.lost.size()},  {"duplicates", progress.duplicates}, {"time_ns", replay.timeNs(replay.position() - 1)}};
}

// As long after the line before as when it was recorded, at the speed asked for; 0 does not wait.
void waitForLine(const Replay& replay, double speed) {
    const int line = replay.position();
    if (speed <= 0 || line == 0 || line >= replay.lines()) return;
    const double ns = static_cast<double>(replay.timeNs(line) - replay.timeNs(line - 1)) / speed;
    std::this_thread::sleep_for(std::chrono::nanoseconds(static_cast<std::int64_t>(std::max(0.0, ns))));
}

// Of several sweeps the longest is the result, as when the file is opened.
void keepLongest(Replay& replay, std::shared_ptr<const Scan>& longest) {
    for (const FinishedSweep& sweep : replay.feed().assembler().takeFinished()) {
        if (sweep.scan && (!longest || sweep.scan->lines() > longest->lines())) longest = sweep.scan;
    }
}

int run(const ReplayWanted& wanted) {
    if (const auto method = checkMethod(wanted.method); !method) {
        complain(method.error());
        return kWrongUsage;
    }
    const auto recording = Recording::open(wanted.file);
    if (!recording) {
        complain(recording.error());
        return kRefused;
    }
    Replay replay(*recording);
    std::shared_ptr<const Scan> longest;
    while (true) {
        waitForLine(replay, wanted.speed);
        if (!replay.step()) break;
        if (!wanted.quiet) std::cout << reportText(lineReport(replay), false) << '\n';
        keepLongest(replay, longest);
    }
    replay.feed().assembler().finish();
    keepLongest(replay, longest);
    if (!longest) {
        complain({"the recording holds no scan line", wanted.file, "choose another recording"});
        return kRefused;
    }
    Scan scan = *longest;
    scan.path = wanted.file;
    if (const auto sha = sha256OfFile(wanted.file)) scan.sha256 = *sha;
    const Result<Settings> settings = settingsFor(wanted.method, scan);
    if (!settings) {
        complain(settings.error());
        return kRefused;
    }
    if (const auto placed = placeRecordedSweep(scan, **recording, wanted.place, wanted.file); !placed) {
        complain(placed.error());
        return kRefused;
    }
    const auto detection = detectEdges(std::make_shared<const Scan>(std::move(scan)), *settings);
    std::cout << reportText({{"result", detectReport(*detection, 0.0)}}, false) << '\n';
    return kDone;
}

} // namespace

void addReplay(CLI::App& app, int& code) {
    auto wanted = std::make_shared<ReplayWanted>();
    CLI::App& command =
        *app.add_subcommand("replay", "A recording through the live path: a JSON line per line received, the edges at the end");
    command.add_option("FILE", wanted->file, "Recording (.mcap)")->required();
    command.add_option("--speed", wanted->speed, "1 = as it was recorded; 0 = as fast as it goes")->capture_default_str();
    command.add_flag("--quiet", wanted->quiet, "Only the result");
    addPlaceFlags(command, wanted->place);
    addMethodFlags(command, wanted->method);
    command.callback([wanted, &code] { code = run(*wanted); });
}

} // namespace edgescan::cli
