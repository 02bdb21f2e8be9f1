// edgescan-cli record: a live scanner to disk.
#include "app/cli/commands.h"
#include "app/shared/host_port.h"
#include "app/shared/interrupt.h"
#include "app/shared/options.h"
#include "core/live/live_feed.h"
#include "core/report/report.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <thread>

namespace edgescan::cli {
namespace {

struct Record {
    std::string address, out;
    std::string axis = "spin";
    int lines = 0;
    double seconds = 0.0;
    bool progress = false;
    SweepSettings sweep;
};

void tell(const LiveStatus& status) {
    std::fprintf(stderr, "\r%-11s %s, %d lost, %llu reconnects   ", sessionPhaseName(status.session.phase), status.sweep.text().c_str(),
                 static_cast<int>(status.sweep.lost.size()), static_cast<unsigned long long>(status.statistics.reconnects));
}

// True when the recording has what was asked for, or will never get it.
bool finished(const Record& record, const LiveStatus& status, std::chrono::steady_clock::time_point start) {
    if (interrupted() || status.session.phase == SessionPhase::Stopped) return true;
    if (status.recording && status.recording->ended) return true;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return (record.lines > 0 && status.lines >= record.lines) || (record.seconds > 0 && elapsed.count() >= record.seconds);
}

nlohmann::ordered_json summary(const Record& record, const LiveStatus& status) {
    return {{"output", record.out},
            {"lines", status.lines},
            {"sweep", status.sweep.text()},
            {"lost_lines", status.sweep.lost},
            {"duplicates", status.sweep.duplicates},
            {"undecodable", status.undecodable},
            {"reconnects", status.statistics.reconnects},
            {"scanner", status.scanner ? nlohmann::ordered_json(status.scanner->words()) : nlohmann::ordered_json(nullptr)}};
}

int run(const Record& record) {
    const Result<HostPort> address = hostPort(record.address);
    if (!address) {
        complain(address.error());
        return kWrongUsage;
    }
    SessionSettings scanner;
    scanner.host = address->host;
    scanner.port = address->port;
    SweepSettings sweep = record.sweep;
    sweep.axis = record.axis == "spin" ? Axis::Spin : Axis::Sweep;
    LiveFeed feed(scanner, sweep, [] {});
    if (const Result<Done> started = feed.startRecording(record.out); !started) {
        complain(started.error());
        return kRefused;
    }
    catchInterrupt();
    const auto start = std::chrono::steady_clock::now();
    const bool telling = record.progress || isatty(STDERR_FILENO) != 0;
    while (!finished(record, feed.status(), start)) {
        if (telling) tell(feed.status());
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (telling) std::fputc('\n', stderr);
    const LiveStatus status = feed.status();
    feed.stop();
    const Result<Done> closed = feed.stopRecording();
    if (!closed) {
        complain(closed.error());
        return kRefused;
    }
    if (status.lines == 0) {
        complain({status.session.sentence.empty() ? "no line was received" : status.session.sentence, record.address,
                  "check cable, address and port"});
        return kRefused;
    }
    std::cout << reportText(summary(record, status), false) << '\n';
    return kDone;
}

} // namespace

void addRecord(CLI::App& app, int& code) {
    auto record = std::make_shared<Record>();
    CLI::App& command = *app.add_subcommand("record", "A live scanner to disk; nothing but reads and a subscription is sent to it");
    command.add_option("HOST", record->address, "Scanner as HOST or HOST:PORT")->required();
    command.add_option("-o,--output", record->out, "New recording (.mcap)")->required();
    command.add_option("--lines", record->lines, "End after so many lines; 0 = until Ctrl+C")->capture_default_str();
    command.add_option("--seconds", record->seconds, "End after so many seconds; 0 = run on")->capture_default_str();
    command.add_option("--expected-lines", record->sweep.expectedLines, "Lines of a whole sweep; 0 = not known")->capture_default_str();
    command.add_option("--axis", record->axis, "Mounting of the stepper")->check(CLI::IsMember({"spin", "sweep"}))->capture_default_str();
    command.add_option("--first-line", record->sweep.firstLineDeg, "Stepper angle of the first line [degrees]")->capture_default_str();
    command.add_option("--line-step", record->sweep.degPerLine, "Stepper angle from line to line [degrees]");
    command.add_option("--ticks-per-degree", record->sweep.ticksPerDeg, "Encoder counts per degree, where there is an encoder");
    command.add_flag("--progress", record->progress, "Tell the progress on stderr also where that is no terminal");
    command.callback([record, &code] { code = run(*record); });
}

} // namespace edgescan::cli
