// edgescan-lab emulate: an emulated LMS511, or an emulated bridge of a robot, that sends a scan's lines.
#include "app/lab/commands/commands.h"
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "app/shared/exits.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"

#ifdef EDGESCAN_ROBOTS
#include "app/lab/robots/bridge.h"
#endif

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

namespace edgescan::cli {
namespace {

struct Emulate {
    std::string file;
    std::string json = "-";
    bool loop = false;
    bool remission = false;
    bool bridge = false, cloud = false;
    std::string dialect = "both";
    double seconds = 0.0;
    scanner::EmulatedScannerSettings settings;
    ReadFlags read;
};

/// The flags of `record` that give the lines the angles of this scan; empty if the lines are not evenly spaced.
std::string recordFlags(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || polar->lineDeg.size() < 2 || polar->lineDirection < 0 || !polar->lineSkewDeg.empty()) return {};
    const std::vector<double>& lines = polar->lineDeg;
    const double step = (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (std::abs(lines[i] - lines.front() - static_cast<double>(i) * step) > 1e-6) return {};
    }
    return std::string("--axis ") + (polar->axis == Axis::Spin ? "spin" : "sweep") + " --line-start " + significantText(lines.front(), 9) +
           " --line-step " + significantText(step, 9) + " --stop-and-go --expected-lines " + std::to_string(lines.size()) + " --lines " +
           std::to_string(lines.size());
}

struct Emulated {
    std::unique_ptr<scanner::EmulatedScanner> scanner;
    std::shared_ptr<void> bridge; ///< instead of the scanner
    std::string recordFlags;
    std::uint16_t port = 0;
};
Result<Emulated> start(const Emulate& emulate) {
    const Result<Scan> scan = openAndWarn(emulate.file, emulate.read);
    if (!scan) return scan.error();
    scanner::EmulatedScannerSettings settings = emulate.settings;
    settings.atEnd = emulate.loop ? scanner::AtEnd::Again : scanner::AtEnd::Stop;
#ifdef EDGESCAN_ROBOTS
    if (emulate.bridge) {
        auto sweep = emulate.cloud ? robots::bridgeCloudOf(*scan) : robots::bridgeSweepOf(*scan);
        if (!sweep) return sweep.error();
        auto bridge = robots::serveBridge(std::move(*sweep), settings);
        if (!bridge) return bridge.error();
        const std::uint16_t port = (*bridge)->port();
        return Emulated{nullptr, std::move(*bridge), {}, port};
    }
#endif
    scanner::TelegramStyle style;
    style.remission = emulate.remission;
    Result<std::vector<scanner::ScanTelegram>> telegrams = scanner::telegramsOf(*scan, style);
    if (!telegrams) return telegrams.error();
    if (emulate.dialect != "both") settings.only = emulate.dialect == "a" ? scanner::Dialect::A : scanner::Dialect::B;
    auto scanner = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
    if (!scanner) return scanner.error();
    const std::uint16_t port = (*scanner)->port();
    return Emulated{std::move(*scanner), nullptr, recordFlags(*scan), port};
}

int run(const Emulate& emulate) {
    const scanner::ScannerFaults& f = emulate.settings.faults;
    const std::array each{f.loseEvery, f.duplicateEvery, f.garbageEvery, f.corruptEvery, f.stallEvery, f.dropEvery, f.narrowEvery};
    if (f.byChance && std::ranges::all_of(each, [](int every) { return every == 0; }))
        return failWith(Error{"no fault comes by chance", "--by-chance", "give one too, such as --lose-every 100"}, kWrongUsage);
    const auto emulated = start(emulate);
    if (!emulated) return failWith(emulated.error());
    catchInterrupt();
    nlohmann::ordered_json flags = nullptr;
    if (!emulated->recordFlags.empty()) flags = emulated->recordFlags;
    const auto about = document("emulate", {{"host", emulate.settings.address}, {"port", emulated->port}, {"record_flags", flags}});
    if (const Result<Done> written = writeDocument(emulate.json, about, false); !written) return failWith(written.error());
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(emulate.seconds);
    while (!interrupted() && (emulate.seconds <= 0 || std::chrono::steady_clock::now() < end)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return kDone;
}

} // namespace

void addEmulate(CLI::App& app, int& code) {
    auto emulate = std::make_shared<Emulate>();
    scanner::EmulatedScannerSettings& s = emulate->settings;
    CLI::App& command = *app.add_subcommand(
        "emulate",
        "Emulates an LMS511 or a robot's bridge that sends a scan's lines over TCP; prints host and port as JSON, runs until Ctrl+C");
    command.add_option("SCAN", emulate->file, "Scan to send")->required();
    addJsonFlag(command, emulate->json, "Host, port and the flags of record that give this scan again").capture_default_str();
#ifdef EDGESCAN_ROBOTS
    CLI::Option* bridge = command.add_flag("--bridge", emulate->bridge,
                                           "Emulate the Foxglove bridge of a robot with ROS 2 that turns a laser, instead of a scanner");
    command
        .add_flag("--cloud", emulate->cloud, "The robot's scanner sends the whole scan in each message (PointCloud2); --rate counts them")
        ->needs(bridge);
#endif
    addNumber(command, "--port", s.port, {0, 65535}, "TCP port; 0 = any that is free");
    command.add_option("--address", s.address, "Address to listen on")->type_name("HOST")->capture_default_str();
    addNumber(command, "--rate", s.linesPerSecond, {0, 1e6}, "Lines per second; 0 = as fast as the client reads");
    command.add_flag("--loop", emulate->loop, "Begin again with the first line at the end");
    addNumber(command, "--seconds", emulate->seconds, kSeconds, "End after this time [s]; 0 = run on");
    command.add_option("--dialect", emulate->dialect, "CoLa dialect that is answered")
        ->check(CLI::IsMember({"both", "a", "b"}))
        ->capture_default_str();
    command.add_flag("--remission", emulate->remission, "Send an RSSI channel, made up from the range");
    const char* faults = "Faults";
    constexpr NumberLimits kCount{0, 1e9};
    command.add_flag("--split-sends", s.faults.splitSends, "Telegrams go out in pieces of random length")->group(faults);
    command.add_flag("--merge-sends", s.faults.mergeSends, "Several telegrams go out at once")->group(faults);
    CLI::Option* lose = addNumber(command, "--lose-every", s.faults.loseEvery, kCount, "Every n-th telegram is not sent").group(faults);
    addNumber(command, "--lose-burst", s.faults.loseBurst, kCount, "How many in a row").needs(lose)->group(faults);
    addNumber(command, "--duplicate-every", s.faults.duplicateEvery, kCount, "Every n-th telegram is sent twice").group(faults);
    addNumber(command, "--garbage-every", s.faults.garbageEvery, kCount, "Random bytes before every n-th telegram").group(faults);
    addNumber(command, "--corrupt-every", s.faults.corruptEvery, kCount, "One bit of every n-th telegram is wrong").group(faults);
    CLI::Option* stall =
        addNumber(command, "--stall-every", s.faults.stallEvery, kCount, "Silence before every n-th telegram").group(faults);
    CLI::Option* silence = addNumber(command, "--stall-seconds", s.faults.stallS, {0, 3600}, "Length of each silence [s]").group(faults);
    stall->needs(silence);
    silence->needs(stall);
    addNumber(command, "--drop-every", s.faults.dropEvery, kCount, "All connections are closed at every n-th telegram").group(faults);
    addNumber(command, "--narrow-every", s.faults.narrowEvery, kCount, "Every n-th telegram has half of its beams").group(faults);
    addNumber(command, "--counter-step", s.faults.counterStep, {0, 65535}, "Step of both counters from line to line").group(faults);
    addNumber(command, "--clock-rate", s.faults.clockRate, {-1000, 1000}, "Rate of the device clock; 0 stops it, -1 runs it backward")
        .group(faults);
    CLI::Option* byChance =
        command.add_flag("--by-chance", s.faults.byChance, "Each fault once in n telegrams by chance, instead of at every n-th")
            ->group(faults);
    addNumber(command, "--fault-seed", s.faults.seed, {0, 4294967295}, "Seed of the chance").needs(byChance)->group(faults);
    command.add_flag("--contamination-warning", s.contaminationWarning, "Report a dirty window")->group(faults);
    command.add_flag("--contamination-error", s.contaminationError, "Report a window that is too dirty")->group(faults);
#ifdef EDGESCAN_ROBOTS
    for (const char* ofScanner :
         {"--dialect", "--remission", "--contamination-warning", "--contamination-error", "--split-sends", "--merge-sends", "--lose-burst",
          "--narrow-every", "--counter-step", "--clock-rate", "--by-chance", "--fault-seed"})
        command.get_option(ofScanner)->excludes(bridge);
#endif
    addReadFlags(command, emulate->read);
    command.callback([emulate, &code] { code = run(*emulate); });
}

} // namespace edgescan::cli
