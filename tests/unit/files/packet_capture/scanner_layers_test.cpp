// A scanner of several layers (MRS1000) sends a telegram per layer: those of a tilted fan are not lines of the motor. They are left out and
// reported, in whatever way the telegrams arrive.
#include "app/lab/emulator/emulator.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/recording/replay.h"
#include "tests/support/live_lines.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

constexpr int kLayeredLines = 30;
constexpr std::array<std::int16_t, 4> kLayers{0, 250, -250, 500}; // 1/100 degree

/// Four telegrams per rotation of the mirror, each counted; the layers see different ranges.
std::vector<scanner::ScanTelegram> layeredTelegrams() {
    std::vector<scanner::ScanTelegram> telegrams;
    for (int n = 0; n < kLayeredLines; ++n) {
        for (const std::int16_t layer : kLayers) {
            scanner::ScanTelegram telegram = telegramOfLine(static_cast<int>(telegrams.size()));
            telegram.channels16.front().values = telegramOfLine(layer == 0 ? n : n + 500).channels16.front().values;
            telegram.layer = layer;
            telegrams.push_back(std::move(telegram));
        }
    }
    return telegrams;
}

/// The layer without an angle is the sweep, line by line, without losses and without the others; the number of the others is reported.
void expectTheLevelLayer(const Scan& scan) {
    ASSERT_EQ(scan.lines(), kLayeredLines);
    for (int n = 0; n < kLayeredLines; ++n) EXPECT_TRUE(rowHolds(scan, n, n)) << n;
    const auto told = std::ranges::find_if(scan.warnings, [](const std::string& w) { return w.find("layer of the scanner") != w.npos; });
    ASSERT_NE(told, scan.warnings.end());
    EXPECT_EQ(told->find("90 telegrams had other beams than the sweep, or were of another layer of the scanner"), 0U) << *told;
    EXPECT_TRUE(std::ranges::none_of(scan.warnings, [](const std::string& w) { return w.find("lost") != w.npos; }));
}

} // namespace

TEST(ScannerLayers, AreLeftOutOfARecording) {
    std::vector<RecordingMessagePtr> messages;
    for (const scanner::ScanTelegram& telegram : layeredTelegrams()) {
        messages.push_back(std::make_shared<const RecordingMessage>(
            RecordingMessage{RecordingTopic::ColaRx, hostNsOfLine(static_cast<int>(messages.size())),
                             scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B)}));
    }
    const auto recording = Recording::fromBytes(recordingBytes({}, messages), "recording");
    ASSERT_TRUE(recording);
    const auto scan = scanOf(*recording, "recording");
    ASSERT_TRUE(scan) << scan.error().sentence();
    expectTheLevelLayer(*scan);
}

TEST(ScannerLayers, AreLeftOutOfACapture) {
    for (const scanner::Dialect dialect : {scanner::Dialect::A, scanner::Dialect::B}) {
        std::vector<std::byte> bytes;
        for (const scanner::ScanTelegram& telegram : layeredTelegrams()) {
            for (const std::uint8_t byte : scanner::framed(scanner::encodeScanTelegram(telegram, dialect), dialect))
                bytes.push_back(std::byte{byte});
        }
        const auto scan = readScanBytes(bytes, ".bin");
        ASSERT_TRUE(scan) << scan.error().sentence();
        expectTheLevelLayer(*scan);
    }
}

TEST(ScannerLayers, AreLeftOutLive) {
    scanner::EmulatedScannerSettings settings;
    settings.port = 0;
    settings.linesPerSecond = 0;
    settings.atEnd = scanner::AtEnd::Stop;
    const auto scanner = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(layeredTelegrams()), settings);
    ASSERT_TRUE(scanner) << scanner.error().sentence();
    scanner::ConnectionSettings session;
    session.host = "127.0.0.1";
    session.port = static_cast<std::uint16_t>((*scanner)->port());
    LiveFeed feed(session, scanner::SweepSettings{}, [] {});
    const auto all = static_cast<std::int64_t>(kLayers.size()) * kLayeredLines;
    EXPECT_TRUE(waitUntil([&] { return feed.status().sweep.account.telegrams >= all; })) << feed.status().connection.sentence;
    const auto scan = feed.snapshot();
    ASSERT_TRUE(scan);
    expectTheLevelLayer(*scan);
    EXPECT_EQ(feed.status().sweep.misfits, 90);
}

TEST(ScannerLayers, AloneTheyAreNoSweep) {
    std::vector<std::byte> bytes;
    for (const scanner::ScanTelegram& telegram : layeredTelegrams()) {
        if (telegram.layer == 0) continue;
        for (const std::uint8_t byte : scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B))
            bytes.push_back(std::byte{byte});
    }
    const auto scan = readScanBytes(bytes, ".bin");
    ASSERT_FALSE(scan);
    EXPECT_NE(scan.error().sentence().find("the 90 scan telegrams in this recording hold no line"), std::string::npos)
        << scan.error().sentence();
}
