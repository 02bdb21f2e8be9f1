// The cost of a line without drawing: thread CPU time per line, stage by stage. build/release/bin/edgescan_live_bench [LINES]
#include "app/lab/emulator/telegram.h"
#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/writer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>

using namespace edgescan;

namespace {

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of several runs: the cost without disturbances by the machine.
template <class Run>
double perLine(int lines, Run run) {
    double best = 1e9;
    for (int round = 0; round < 5; ++round) best = std::min(best, run());
    return best / lines;
}

void tell(const char* what, double seconds) {
    std::printf("%-66s %7.1f us per line, %5.2f %% of a core at 100 lines/s\n", what, seconds * 1e6, seconds * 1e4);
}

/// Bytes of the lines as an LMS511 sends them.
std::vector<Bytes> framesOf(const Scan& scan) {
    std::vector<Bytes> frames;
    const auto telegrams = scanner::telegramsOf(scan);
    if (!telegrams) std::exit(1);
    for (const scanner::ScanTelegram& telegram : *telegrams)
        frames.push_back(scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B));
    return frames;
}

double receive(const std::vector<Bytes>& frames, int snapshotEvery) {
    scanner::SweepSettings settings;
    settings.expectedLines = static_cast<int>(frames.size());
    scanner::ColaStream stream;
    scanner::SweepFeed feed(settings);
    std::int64_t ns = 1'700'000'000'000'000'000;
    std::shared_ptr<const Scan> shown;
    const double start = threadSeconds();
    int line = 0;
    for (const Bytes& frame : frames) {
        for (const scanner::ColaFrame& received : stream.push(frame)) feed.frame(received, ns += 10'000'000);
        if (snapshotEvery > 0 && ++line % snapshotEvery == 0) shown = feed.assembler().snapshot();
    }
    return threadSeconds() - start;
}

double record(const std::vector<Bytes>& frames) {
    const files::RecordingClock clock;
    files::RecentMessages recent;
    const double start = threadSeconds();
    for (const Bytes& frame : frames)
        recent.push(files::receivedMessage(scanner::ColaFrame{scanner::Dialect::B, frame, scanner::hostNow(), 0, 0}, clock));
    return threadSeconds() - start;
}

/// One picture of the whole sweep: while the sweep grows, the edges are recomputed for each picture.
double pictureSeconds(const std::shared_ptr<const Scan>& scan, edges::Method method) {
    edges::Settings settings;
    settings.method = method;
    double best = 1e9;
    for (int round = 0; round < 5; ++round) {
        const double start = threadSeconds();
        static_cast<void>(edges::detectEdges(scan, settings));
        best = std::min(best, threadSeconds() - start);
    }
    return best;
}

} // namespace

int main(int argc, char** argv) {
    sim::SimulationSettings simulation;
    if (argc > 1) simulation.lines = std::max(8, std::atoi(argv[1]));
    const auto simulated = sim::simulate(simulation);
    if (!simulated) {
        std::fprintf(stderr, "edgescan_live_bench: %s\n", simulated.error().sentence().c_str());
        return 1;
    }
    const Scan& scan = simulated->scan;
    const std::vector<Bytes> frames = framesOf(scan);
    std::printf("%d lines x %d beams\n", scan.lines(), scan.beams());
    const double received = perLine(scan.lines(), [&] { return receive(frames, 0); });
    tell("bytes to line: frames, telegram, sweep assembly", received);
    const double snapshots = perLine(scan.lines(), [&] { return receive(frames, 10); }) - received;
    tell("a snapshot every 10 lines", std::max(0.0, snapshots));
    const double kept = perLine(scan.lines(), [&] { return record(frames); });
    tell("the last minute kept", kept);
    tell("together", received + std::max(0.0, snapshots) + kept);
    const auto whole = std::make_shared<const Scan>(scan);
    for (const auto& [name, method] : {std::pair{"EdgeScan+", edges::Method::EdgeScanPlus}, std::pair{"Canny", edges::Method::Canny}}) {
        const double seconds = pictureSeconds(whole, method);
        std::printf("edges of the whole sweep by %-9s %6.0f ms, %5.1f pictures per second at most\n", name, 1e3 * seconds, 1.0 / seconds);
    }
    return 0;
}
