// Twenty minutes of a scanner with random faults, as fast as the machine allows: every line is received or reported as lost, memory is
// constant, every reconnect is counted.
#include "core/files/live_feed/live_feed.h"
#include "tests/support/live_session.h"
#include "tests/support/own_sockets.h"
#include "tests/support/point_lists.h"
#include "tests/support/python_peer.h"

#include <boost/asio.hpp>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

constexpr int kLines = 30'000; // 20 minutes at 25 Hz
constexpr int kBeams = 40;
constexpr int kSweep = 1000;
constexpr std::size_t kKeptBytes = 2U << 20U;
constexpr double kMostGrowthMb = 8.0;

double residentMb() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// The ranges of the first two beams identify the line.
Scan numberedScan(int lines) {
    return makeScan(lines, kBeams, [](int i, int j) { return 1000 + (j == 0 ? i / 500 : j == 1 ? i % 500 : (i * 7 + j) % 3000); });
}
int numberOf(const Scan& scan, int row) {
    return 500 * (static_cast<int>(scan.rangeMm.at(row, 0)) - 1000) + static_cast<int>(scan.rangeMm.at(row, 1)) - 1000;
}

/// The output of a feed, sweep by sweep.
struct Collected {
    std::int64_t rows = 0, received = 0, lost = 0;
    int sweeps = 0;
    int first = -1; ///< number of the first line; with numbered lines
    bool inPlace = true;

    void take(const std::vector<scanner::FinishedSweep>& finished, bool numbered) {
        for (const scanner::FinishedSweep& sweep : finished) {
            ++sweeps;
            received += sweep.progress.received;
            lost += static_cast<std::int64_t>(sweep.progress.lost.size());
            for (int row = 0; numbered && row < sweep.scan->lines(); ++row) {
                if (sweep.scan->state.at(row, 0) == CellState::Lost) continue;
                const int number = numberOf(*sweep.scan, row);
                if (first < 0) first = number - row;
                inPlace = inPlace && number == first + rows + row;
            }
            rows += sweep.progress.lines;
        }
    }
};

scanner::SweepSettings soakSweep() {
    scanner::SweepSettings settings;
    settings.expectedLines = kSweep;
    return settings;
}

} // namespace

TEST(LiveSoak, TwentyMinutesOfTheEmulatedScanner) {
    scanner::EmulatedScannerSettings settings;
    settings.linesPerSecond = 0;
    settings.atEnd = scanner::AtEnd::Stop;
    settings.faults.byChance = true;
    settings.faults.seed = 20;
    settings.faults.splitSends = settings.faults.mergeSends = true;
    settings.faults.loseEvery = 400;
    settings.faults.loseBurst = 3;
    settings.faults.duplicateEvery = 300;
    settings.faults.garbageEvery = 200;
    settings.faults.corruptEvery = 500;
    settings.faults.dropEvery = 2000;
    settings.faults.stallEvery = 6000;
    settings.faults.stallS = 0.6;
    const auto scanner = served(numberedScan(kLines), settings);
    LiveFeed feed(settingsFor(*scanner, hasty()), soakSweep(), [] {}, {.keptBytes = kKeptBytes});
    Collected all;
    double early = 0.0;
    const auto start = std::chrono::steady_clock::now();
    for (std::int64_t before = -1, quiet = 0; quiet < 60 && std::chrono::steady_clock::now() - start < kPatience;) {
        all.take(feed.popFinished(), true);
        const std::int64_t lines = feed.status().lines;
        if (early == 0.0 && lines > kLines / 4) early = residentMb();
        const bool waits = !scanner->statistics().finished || lines != before ||
                           std::ranges::any_of(ownTcpSockets(), [](const OwnSocket& socket) { return socket.underWay; });
        quiet = waits ? 0 : quiet + 1;
        before = lines;
        std::this_thread::sleep_for(5ms);
    }
    const double late = residentMb();
    feed.stop();
    all.take(feed.popFinished(), true);
    const LiveStatus status = feed.status();
    const scanner::EmulatedScannerStatistics sent = scanner->statistics();
    ASSERT_TRUE(sent.finished) << status.lines << " lines";
    EXPECT_EQ(sent.lines, static_cast<std::uint64_t>(kLines));
    EXPECT_GT(sent.drops, 5U);
    EXPECT_GT(sent.stalls, 1U);
    // Every row is where the scanner measured it, received or lost; only the very first and last may be missing.
    EXPECT_TRUE(all.inPlace);
    EXPECT_EQ(all.received + all.lost, all.rows);
    EXPECT_GE(all.rows, kLines - 20);
    EXPECT_LE(all.rows, kLines);
    EXPECT_GE(all.lost, static_cast<std::int64_t>(sent.lost + sent.corrupted) - 20);
    EXPECT_EQ(all.received + status.sweep.duplicates, status.lines);
    EXPECT_EQ(status.undecodable, 0);
    EXPECT_EQ(status.statistics.scans, static_cast<std::uint64_t>(status.lines));
    // The scanner may have accepted a last connection that stop() ended before it was made here.
    EXPECT_LE(status.statistics.connections, sent.clients);
    EXPECT_GE(status.statistics.connections + 1, sent.clients);
    EXPECT_EQ(status.statistics.reconnects + 1, status.statistics.connections);
    EXPECT_GE(status.statistics.reconnects, sent.drops);
    EXPECT_GT(early, 0.0);
    EXPECT_LT(late - early, kMostGrowthMb);
    std::printf("[ measured ] %lld of %d lines, %lld lost, %llu reconnects, %d sweeps; memory %.1f MB after 5 minutes, %.1f MB after 20\n",
                static_cast<long long>(all.received), kLines, static_cast<long long>(all.lost),
                static_cast<unsigned long long>(status.statistics.reconnects), all.sweeps, early, late);
}

TEST(LiveSoak, TwentyMinutesOfTheMockScanner) {
    EDGESCAN_NEEDS_PYTHON();
    const Folder folder;
    {
        // Narrow telegrams, so that Python keeps up.
        const auto telegrams = scanner::telegramsOf(numberedScan(500));
        ASSERT_TRUE(telegrams);
        std::ofstream file(folder / "stream.bin", std::ios::binary);
        for (const scanner::ScanTelegram& telegram : *telegrams) {
            const Bytes frame = scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B);
            file.write(reinterpret_cast<const char*>(frame.data()), static_cast<std::streamsize>(frame.size()));
        }
    }
    boost::asio::io_context context;
    boost::asio::ip::tcp::acceptor acceptor(context, {boost::asio::ip::address_v4::loopback(), 0});
    const std::uint16_t port = acceptor.local_endpoint().port();
    acceptor.close();
    constexpr double kLoss = 0.01;
    const Process mock({"python3", (protocolFolder() / "tools" / "mock_lms511.py").string(), "--port", std::to_string(port), "--rate",
                        "1e9", "--stream", (folder / "stream.bin").string(), "--chunk", "random", "--garbage", "0.02", "--telegram-loss",
                        "0.01", "--drop-after", "3000"});
    scanner::ConnectionSettings settings;
    settings.host = "127.0.0.1";
    settings.port = port;
    settings.timeouts = hasty();
    settings.timeouts.detect = 1s;
    LiveFeed feed(settings, soakSweep(), [] {}, {.keptBytes = kKeptBytes});
    Collected all;
    double early = 0.0;
    const auto start = std::chrono::steady_clock::now();
    while (feed.status().lines < kLines && std::chrono::steady_clock::now() - start < kPatience) {
        all.take(feed.popFinished(), false);
        if (early == 0.0 && feed.status().lines > kLines / 4) early = residentMb();
        std::this_thread::sleep_for(5ms);
    }
    const double late = residentMb();
    feed.stop();
    all.take(feed.popFinished(), false);
    const LiveStatus status = feed.status();
    ASSERT_GE(status.lines, kLines) << status.connection.sentence;
    // The mock restarts its counters at every connection: losses between two connections are unknown, all others are reported.
    EXPECT_EQ(all.received + all.lost, all.rows);
    EXPECT_EQ(all.received + status.sweep.duplicates + status.sweep.misfits, status.lines);
    EXPECT_EQ(status.statistics.scans, static_cast<std::uint64_t>(status.lines));
    EXPECT_GE(static_cast<double>(all.lost), 0.5 * kLoss * kLines);
    EXPECT_GE(status.statistics.reconnects, static_cast<std::uint64_t>(kLines / 3000 - 1));
    EXPECT_GT(early, 0.0);
    EXPECT_LT(late - early, kMostGrowthMb);
    std::printf("[ measured ] %lld lines, %lld lost, %llu reconnects; memory %.1f MB after 5 minutes, %.1f MB after 20; %.0f s\n",
                static_cast<long long>(status.lines), static_cast<long long>(all.lost),
                static_cast<unsigned long long>(status.statistics.reconnects), early, late,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}
