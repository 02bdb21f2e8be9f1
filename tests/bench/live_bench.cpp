// What a line costs beside drawing: thread CPU time per line, stage by stage. build/release/bin/edgescan_live_bench [LINES]
#include "core/live/live_edges.h"
#include "core/recording/recording.h"
#include "core/recording/replay.h"
#include "core/emulator/emulated_telegram.h"
#include "core/sim/simulate.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>

using namespace edgescan;

namespace {

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of a few runs: what it costs, not what the machine was disturbed by.
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
    const auto telegrams = telegramsOf(scan);
    if (!telegrams) std::exit(1);
    for (const ScanTelegram& telegram : *telegrams) frames.push_back(framed(encodeScanTelegram(telegram, Dialect::B), Dialect::B));
    return frames;
}

double receive(const std::vector<Bytes>& frames, int snapshotEvery) {
    SweepSettings settings;
    settings.expectedLines = static_cast<int>(frames.size());
    ColaStream stream;
    SweepFeed feed(settings);
    std::int64_t ns = 1'700'000'000'000'000'000;
    std::shared_ptr<const Scan> shown;
    const double start = threadSeconds();
    int line = 0;
    for (const Bytes& frame : frames) {
        for (const ColaFrame& received : stream.push(frame)) feed.frame(received, ns += 10'000'000);
        if (snapshotEvery > 0 && ++line % snapshotEvery == 0) shown = feed.assembler().snapshot();
    }
    return threadSeconds() - start;
}

double record(const std::vector<Bytes>& frames) {
    const RecordingClock clock;
    RecentMessages recent;
    const double start = threadSeconds();
    for (const Bytes& frame : frames) recent.push(receivedMessage(ColaFrame{Dialect::B, frame, hostNow(), 0, 0}, clock));
    return threadSeconds() - start;
}

/// Edges while the lines come `together` at a time.
double grow(const Scan& whole, const Settings& settings, int together) {
    Scan part;
    part.rangeMm = Grid<float>(0, whole.beams());
    part.state = Grid<CellState>(0, whole.beams());
    auto live = LiveEdges::make(settings);
    if (!live) std::exit(1);
    double spent = 0.0;
    for (int lines = together; lines <= whole.lines(); lines += together) {
        const auto cells = static_cast<std::ptrdiff_t>(whole.rangeMm.index(lines, 0));
        const auto before = static_cast<std::ptrdiff_t>(part.cells());
        part.rangeMm.lines = part.state.lines = lines;
        part.rangeMm.cells.insert(part.rangeMm.cells.end(), whole.rangeMm.cells.begin() + before, whole.rangeMm.cells.begin() + cells);
        part.state.cells.insert(part.state.cells.end(), whole.state.cells.begin() + before, whole.state.cells.begin() + cells);
        const double start = threadSeconds();
        live->update(part);
        spent += threadSeconds() - start;
    }
    return spent;
}

} // namespace

int main(int argc, char** argv) {
    SimulationSettings simulation;
    if (argc > 1) simulation.lines = std::max(8, std::atoi(argv[1]));
    const auto simulated = simulate(simulation);
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
    Settings settings;
    settings.method = Method::Canny;
    double edges = 0.0;
    for (const int kernel : {3, 5}) {
        for (const int together : {1, 4, 10}) {
            settings.kernel = kernel;
            const Settings fixed = withFixedWindow(settings, scan);
            const double cost = perLine(scan.lines(), [&] { return grow(scan, fixed, together); });
            char what[80];
            std::snprintf(what, sizeof what, "edges, kernel %d, %d line%s at a time", kernel, together, together == 1 ? "" : "s");
            tell(what, cost);
            if (kernel == 3 && together == 1) edges = cost;
        }
    }
    tell("together, edges one line at a time with kernel 3", received + std::max(0.0, snapshots) + kept + edges);
    return 0;
}
