// edgescan-cli serve: an emulated LMS511 that sends a scan's lines over TCP.
#include "app/cli/commands.h"
#include "app/shared/interrupt.h"
#include "app/shared/options.h"
#include "core/emulator/emulated_scanner.h"
#include "core/emulator/emulated_telegram.h"

#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

namespace edgescan::cli {
namespace {

struct Serve {
    std::string file;
    bool loop = false;
    bool remission = false;
    std::string dialect = "both";
    double seconds = 0.0;
    EmulatedScannerSettings settings;
    ReadFlags read;
};

Result<std::unique_ptr<EmulatedScanner>> start(const Serve& serve) {
    const Result<Scan> scan = openAsAsked(serve.file, readingOptions(serve.read));
    if (!scan) return scan.error();
    TelegramStyle style;
    style.remission = serve.remission;
    Result<std::vector<ScanTelegram>> telegrams = telegramsOf(*scan, style);
    if (!telegrams) return telegrams.error();
    EmulatedScannerSettings settings = serve.settings;
    settings.atEnd = serve.loop ? AtEnd::Again : AtEnd::Stop;
    if (serve.dialect != "both") settings.only = serve.dialect == "a" ? Dialect::A : Dialect::B;
    return serveTelegrams(std::make_shared<const std::vector<ScanTelegram>>(std::move(*telegrams)), settings);
}

int run(const Serve& serve) {
    const auto scanner = start(serve);
    if (!scanner) {
        complain(scanner.error());
        return kRefused;
    }
    catchInterrupt();
    std::cout << "{\"host\":\"" << serve.settings.address << "\",\"port\":" << (*scanner)->port() << "}" << std::endl;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(serve.seconds);
    while (!interrupted() && (serve.seconds <= 0 || std::chrono::steady_clock::now() < end)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return kDone;
}

} // namespace

void addServe(CLI::App& app, int& code) {
    auto serve = std::make_shared<Serve>();
    EmulatedScannerSettings& s = serve->settings;
    CLI::App& command =
        *app.add_subcommand("serve", "An emulated LMS511 that sends a scan's lines over TCP; prints host and port, runs until Ctrl+C");
    command.add_option("FILE", serve->file, "Scan to send")->required();
    command.add_option("--port", s.port, "TCP port; 0 = any that is free")->capture_default_str();
    command.add_option("--address", s.address, "Address to listen on")->capture_default_str();
    command.add_option("--rate", s.linesPerSecond, "Lines per second; 0 = as fast as the client reads")->capture_default_str();
    command.add_flag("--loop", serve->loop, "From the first line again at the end");
    command.add_option("--seconds", serve->seconds, "End after so many seconds; 0 = run on")->capture_default_str();
    command.add_option("--dialect", serve->dialect, "CoLa dialect that is answered")
        ->check(CLI::IsMember({"both", "a", "b"}))
        ->capture_default_str();
    command.add_flag("--remission", serve->remission, "Send an RSSI channel, made up from the range");
    const char* faults = "Faults";
    command.add_flag("--split", s.faults.splitSends, "Telegrams go out in pieces of random length")->group(faults);
    command.add_flag("--merge", s.faults.mergeSends, "Several telegrams go out at once")->group(faults);
    command.add_option("--lose-every", s.faults.loseEvery, "Every n-th telegram is not sent")->group(faults);
    command.add_option("--lose-burst", s.faults.loseBurst, "How many in a row")->group(faults);
    command.add_option("--duplicate-every", s.faults.duplicateEvery, "Every n-th telegram is sent twice")->group(faults);
    command.add_option("--garbage-every", s.faults.garbageEvery, "Random bytes before every n-th telegram")->group(faults);
    command.add_option("--corrupt-every", s.faults.corruptEvery, "One bit of every n-th telegram is wrong")->group(faults);
    command.add_option("--stall-every", s.faults.stallEvery, "Silence at every n-th telegram ...")->group(faults);
    command.add_option("--stall-seconds", s.faults.stallS, "... for so long")->group(faults);
    command.add_option("--drop-every", s.faults.dropEvery, "All connections are closed at every n-th telegram")->group(faults);
    command.add_flag("--contamination-warning", s.contaminationWarning, "The window is dirty")->group(faults);
    command.add_flag("--contamination-error", s.contaminationError, "The window is too dirty")->group(faults);
    addReadFlags(command, serve->read);
    command.callback([serve, &code] { code = run(*serve); });
}

} // namespace edgescan::cli
