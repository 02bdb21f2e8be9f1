// edgescan-cli record: records a live scanner to disk.
#include "app/cli/commands.h"
#include "app/cli/live_report.h"
#include "app/shared/exits.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/exports/report.h"
#include "core/files/live_feed/live_feed.h"
#include "core/scanner/cola/host_port.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <thread>

namespace edgescan::cli {
namespace {

constexpr std::size_t kKeptBytes = std::size_t{8} << 20U;

struct Record {
    std::string address, out;
    std::string json = "-";
    std::string axis, topic, joint;
    int lines = 0;
    double seconds = 0.0, timeoutS = 0.0;
    bool progress = false, keepRepeated = false;
    Mounting mounting;
};

void showStatus(const files::LiveStatus& status) {
    std::string line = scanner::connectionPhaseName(status.connection.phase);
    line += "  " + status.sweep.text() + ", " + std::to_string(status.sweep.lost.size()) + " lost, " +
            std::to_string(status.statistics.reconnects) + " reconnects";
    if (const auto remarks = status.sweep.irregular.sentences(); !remarks.empty())
        line += ", " + std::to_string(remarks.size()) + " remarks";
    const std::string lag = status.recording ? files::lagText(*status.recording) : std::string();
    if (!lag.empty()) line += ", " + lag;
    showProgress(line);
}

// True if the recording has the requested sweeps or lines, or can no longer get them.
bool finished(const Record& record, const files::LiveStatus& status, std::chrono::steady_clock::time_point start) {
    if (interrupted() || status.connection.phase == scanner::ConnectionPhase::Stopped) return true;
    if (status.recording && status.recording->ended) return true;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (record.timeoutS > 0 && status.lines == 0 && elapsed.count() >= record.timeoutS) return true;
    return (record.lines > 0 && status.lines >= record.lines) || (record.seconds > 0 && elapsed.count() >= record.seconds);
}

// Remarks about flags, sweeps, telegrams and the disk, as sentences.
std::vector<std::string> remarks(const std::vector<std::string>& idle, const files::LiveStatus& status,
                                 const files::RecordingState& recorded) {
    std::vector<std::string> all = idle;
    std::ranges::move(status.sweep.irregularEver.sentences(), std::back_inserter(all));
    if (const std::string assumed = status.sweep.allAssumed(); !assumed.empty()) all.push_back(assumed);
    const auto count = [&](std::uint64_t number, const std::string& what) {
        if (number > 0) all.push_back(std::to_string(number) + what);
    };
    const scanner::TelegramAccount& account = status.sweep.account;
    count(static_cast<std::uint64_t>(account.linesLost), " lines of the sweeps are lost in whole or in part.");
    count(static_cast<std::uint64_t>(status.undecodable), " scan telegrams could not be decoded: " + status.whyUndecodable + ".");
    count(static_cast<std::uint64_t>(status.noReturns), files::kNoReturnsOfLaser);
    count(status.statistics.stream.skipped, " bytes were not a telegram and were skipped.");
    count(recorded.dropped, " telegrams are missing in the recording.");
    if (recorded.unsynced() > 0)
        all.push_back("The disk has not confirmed the last " + std::to_string(recorded.unsynced()) +
                      " bytes: keep the power on until it is idle.");
    return all;
}

/// The mounting that was used to place the lines, and which of its values are assumed. Lines that came with their angles have neither step
/// nor start.
nlohmann::ordered_json mountingReport(const files::LiveStatus& status) {
    const scanner::SweepSettings& sweep = status.settings;
    const bool ownAngles = status.sweep.angleSource == scanner::AngleSource::Stepper;
    nlohmann::ordered_json assumed = nlohmann::ordered_json::array(), step = nullptr;
    if (sweep.axisAssumed) assumed.push_back("axis");
    if (sweep.stepAssumed && !ownAngles) assumed.push_back("line_step_deg");
    if (sweep.firstAssumed && !ownAngles) assumed.push_back("line_start_deg");
    nlohmann::ordered_json axis = nullptr, first = nullptr; // points of a cloud have their places
    if (!status.wholeClouds) axis = status.sweep.axis == Axis::Spin ? "spin" : "sweep";
    if (!status.wholeClouds && !ownAngles) first = status.sweep.firstLineDeg;
    if (sweep.degPerLine && !ownAngles) step = *sweep.degPerLine;
    nlohmann::ordered_json lines = nullptr;
    if (sweep.expectedLines > 0) lines = sweep.expectedLines;
    return {{"axis", axis},
            {"line_step_deg", step},
            {"line_start_deg", first},
            {"stop_and_go", !sweep.continuous},
            {"expected_lines", lines},
            {"assumed", assumed}};
}

nlohmann::ordered_json summary(const Record& record, const std::vector<std::string>& idle, const files::LiveStatus& status,
                               const files::RecordingState& recorded) {
    const scanner::TelegramAccount& account = status.sweep.account;
    return {{"output", record.out},
            {"lines", status.lines},
            {"lines_after", status.linesAfter},
            {"sweep", status.sweep.text()},
            {"lost_lines", status.sweep.lost},
            {"duplicates", status.sweep.duplicates},
            {"undecodable", status.undecodable},
            {"reconnects", status.statistics.reconnects},
            {"mounting", mountingReport(status)},
            {"scanner", status.scanner ? nlohmann::ordered_json(status.scanner->words()) : nlohmann::ordered_json(nullptr)},
            {"sweeps",
             {{"count", account.sweeps},
              {"lines", account.lines},
              {"lines_lost", account.linesLost},
              {"cells", account.cells},
              {"cells_lost", account.cellsLost}}},
            {"telegrams", accountReport(account)},
            {"irregular", irregularReport(status.sweep.irregularEver)},
            {"stream", {{"skipped_bytes", status.statistics.stream.skipped}, {"bad_checksums", status.statistics.stream.badChecksum}}},
            {"disk",
             {{"messages", recorded.messages},
              {"bytes", recorded.bytes},
              {"dropped", recorded.dropped},
              {"unsynced_bytes", recorded.unsynced()},
              {"worst_lag_s", std::round(recorded.worstLagSeconds * 100) / 100}}},
            {"warnings", remarks(idle, status, recorded)}};
}

int run(const Record& record) {
    if (std::error_code ignored; std::filesystem::is_regular_file(record.address, ignored))
        return failWith({"this is a file and not a scanner", record.address, "replay plays a recording"}, kWrongUsage);
    const Result<scanner::HostPort> address = scanner::hostPort(record.address);
    if (!address) return failWith(address.error(), kWrongUsage);
    const char* ofBridge = !record.topic.empty() ? "--topic" : !record.joint.empty() ? "--joint" : nullptr;
    if (!address->bridge && ofBridge != nullptr)
        return failWith(Error{"only a robot's bridge has topics and joints", ofBridge, "give ws://HOST, or leave it out"}, kWrongUsage);
    if (!address->bridge && record.keepRepeated)
        return failWith(
            Error{"a scanner of SICK says itself which ranges it did not measure", "--keep-repeated", "give ws://HOST, or leave it out"},
            kWrongUsage);
    if (const auto right = checkMounting(record.mounting); !right) return failWith(right.error(), kWrongUsage);
    scanner::ConnectionSettings scanner;
    scanner.host = address->host;
    scanner.port = address->port;
    scanner.bridge = address->bridge;
    scanner.topic = record.topic;
    scanner.joint = record.joint;
    scanner.keepRepeated = record.keepRepeated;
    Mounting mounting = record.mounting;
    if (!record.axis.empty()) mounting.axis = record.axis == "spin" ? Axis::Spin : Axis::Sweep;
    const Result<scanner::SweepSettings> sweep = sweepOf(mounting);
    if (!sweep) return failWith(sweep.error());
    if (const auto can = checkOutputs(std::array{record.json}); !can) return failWith(can.error());
    // The last lines are wanted only until the recording has begun.
    files::LiveFeed feed(scanner, *sweep, [] {}, {.lines = record.lines, .keptBytes = kKeptBytes});
    if (const auto started = feed.startRecording(record.out); !started) return failWith(started.error());
    catchInterrupt();
    const auto start = std::chrono::steady_clock::now();
    const bool showsProgress = record.progress || isatty(STDERR_FILENO) != 0;
    std::string reported; // why nothing comes, once for each reason
    std::vector<std::string> idle;
    while (true) {
        const files::LiveStatus now = feed.status();
        if (address->bridge && now.lines > 0 && idle.empty()) {
            idle = idleMounting(mounting, record.joint, now);
            for (const std::string& sentence : idle) printError(sentence);
        }
        if (finished(record, now, start)) break;
        const std::string problem = now.connection.problem ? now.connection.problem->sentence() : std::string();
        if (!problem.empty() && problem != reported) printError(now.connection.sentence + " Ctrl+C ends.");
        reported = problem;
        if (showsProgress) showStatus(now);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    files::LiveStatus status = feed.status();
    if (showsProgress) showProgress(std::to_string(status.lines) + " lines", true);
    feed.stop();
    const files::LiveStatus last = feed.status();
    status.sweep = last.sweep;           // includes the end of its last sweep
    status.statistics = last.statistics; // includes the telegrams received meanwhile
    status.lines = last.lines;           // likewise: the recording has these lines too
    status.linesAfter = last.linesAfter;
    if (const std::string lag = status.recording ? files::lagText(*status.recording) : std::string(); !lag.empty())
        printError(lag + "; waiting some seconds for it.");
    if (status.lines == 0 && status.statistics.stream.bytes == 0) feed.discardRecording(); // it would only block the next try
    const Result<files::RecordingState> closed = feed.stopRecording();
    if (!closed) return failWith(closed.error());
    if (status.lines == 0) {
        Error none = scanner::noLinesError(status.connection, record.address);
        if (last.undecodable > 0) none.what += "; " + std::to_string(last.undecodable) + " messages gave no line: " + last.whyUndecodable;
        if (status.statistics.stream.bytes > 0) none.hint += "; what did arrive is in " + record.out;
        printError(none);
        return kRefused;
    }
    const auto written = writeDocument(record.json, document("record", summary(record, idle, status, *closed)), false);
    return written ? kDone : failWith(written.error());
}

} // namespace

void addRecord(CLI::App& app, int& code) {
    auto record = std::make_shared<Record>();
    CLI::App& command = *app.add_subcommand("record", "Records a live scanner or a robot's bridge; it only reads and subscribes");
    command.add_option("HOST", record->address, "Scanner as HOST or HOST:PORT; a robot's Foxglove bridge as ws://HOST or ws://HOST:PORT")
        ->required();
    command.add_option("-o,--output", record->out, "New recording (.mcap)")
        ->type_name("FILE")
        ->check(namedAs("a recording", ".mcap", false))
        ->required();
    addJsonFlag(command, record->json, "Account of the recording, when it has ended").capture_default_str();
    addNumber(command, "--lines", record->lines, {0, 1e9},
              "Record exactly this number of lines, of a bridge this number or some more; 0 = until Ctrl+C");
    addNumber(command, "--seconds", record->seconds, kSeconds, "End after this time [s]; 0 = run on");
    addNumber(command, "--timeout", record->timeoutS, kSeconds, "End if no line has come by this time [s]; 0 = try again until Ctrl+C");
    const char* group = "Mounting of the stepper (what is not given is assumed, reported and marked in the recording)";
    Mounting& mounting = record->mounting;
    command.add_option("--axis", record->axis, "What the stepper turns about: spin (viewing direction) or sweep (0/180 degree line)")
        ->check(CLI::IsMember({"spin", "sweep"}))
        ->group(group);
    addNumber(command, "--line-step", mounting.lineStepDeg, {-90, 90}, "Stepper angle from line to line [degrees]").group(group);
    addNumber(command, "--line-start", mounting.firstLineDeg, physical::kBeamDeg.limits, "Stepper angle of the first line [degrees]")
        .group(group);
    command.add_option("--calibration", mounting.calibration, "Calibration file of the robot, which has axis and step")
        ->type_name("FILE")
        ->group(group);
    addMountingFlags(command, mounting, group);
    const char* bridge = "Robot's bridge";
    command
        .add_option("--topic", record->topic, "Topic of scan lines or of clouds; without it the first one of lines by name, else of clouds")
        ->type_name("NAME")
        ->group(bridge);
    command.add_option("--joint", record->joint, "Joint that turns the laser; without it transforms, then the joint that turns furthest")
        ->type_name("NAME")
        ->group(bridge);
    command
        .add_flag("--keep-repeated", record->keepRepeated,
                  "Take a range or point that repeats exactly, far apart from the rest, as measured and not as no return")
        ->group(bridge);
    command.add_flag("--progress", record->progress, "Show the progress on stderr, also where that is not a terminal");
    command.callback([record, &code] { code = run(*record); });
}

} // namespace edgescan::cli
