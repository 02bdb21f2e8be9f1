// Captures: in whatever way packets arrive, the sweep is that of the recording with the same telegrams.
#include "core/base/utc_time.h"
#include "core/files/packet_capture/tcp_streams.h"
#include "core/files/recording/replay.h"
#include "core/scan/grid/acquisition.h"
#include "tests/support/cola_vectors.h"
#include "tests/support/live_lines.h"
#include "tests/support/packet_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

constexpr int kCapturedLines = 40;

std::string telegramBytes(int line, scanner::Dialect dialect) {
    const Bytes frame = scanner::framed(scanner::encodeScanTelegram(telegramOfLine(line), dialect), dialect);
    return {frame.begin(), frame.end()};
}

/// The telegrams of a sweep, concatenated.
std::string telegramStream(scanner::Dialect dialect = scanner::Dialect::B, int lines = kCapturedLines) {
    std::string bytes;
    for (int line = 0; line < lines; ++line) bytes += telegramBytes(line, dialect);
    return bytes;
}

/// The same telegrams as a recording that contains no more than a capture does.
Scan recordedSweep(scanner::Dialect dialect = scanner::Dialect::B) {
    std::vector<RecordingMessagePtr> messages;
    for (int line = 0; line < kCapturedLines; ++line) messages.push_back(lineMessage(line, {}, dialect));
    const auto recording = Recording::fromBytes(recordingBytes({}, messages), "recording");
    return *scanOf(*recording, "recording");
}

/// A stream split into segments of any length, with the times of its lines.
std::vector<TcpPart> segmentsOf(const std::string& stream, unsigned seed, std::uint32_t first = 4'294'960'000U,
                                std::size_t longest = 1448) {
    std::mt19937 random(seed);
    std::vector<TcpPart> parts{{first - 1, "", true, kEpochNs}};
    for (std::size_t at = 0; at < stream.size();) {
        const std::size_t length = std::min(stream.size() - at, 1 + random() % longest);
        const std::int64_t time = kEpochNs + static_cast<std::int64_t>(at) * 250'000;
        parts.push_back({first + static_cast<std::uint32_t>(at), stream.substr(at, length), false, time}); // the sequence numbers wrap
        at += length;
    }
    return parts;
}

bool captureTold(const Scan& scan, const std::string& part) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

std::string joined(const TcpStream& stream) {
    std::string text;
    for (const StreamPiece& piece : stream.pieces) text.append(piece.bytes.begin(), piece.bytes.end());
    return text;
}

/// Packets made by packetOf(), as the reader returns them.
struct MadePackets {
    std::vector<std::string> bytes;
    std::vector<Packet> packets;
    explicit MadePackets(const std::vector<TcpPart>& parts) {
        for (const TcpPart& part : parts) bytes.push_back(packetOf(part, {}));
        for (std::size_t n = 0; n < parts.size(); ++n)
            packets.push_back(
                {parts[n].timeNs, LinkType::Ethernet, ByteView(reinterpret_cast<const std::uint8_t*>(bytes[n].data()), bytes[n].size())});
    }
};

} // namespace

TEST(Capture, EveryKindOfCaptureGivesTheSweepOfItsTelegrams) {
    for (const scanner::Dialect dialect : {scanner::Dialect::A, scanner::Dialect::B}) {
        const Scan expected = recordedSweep(dialect);
        const std::vector<TcpPart> parts = segmentsOf(telegramStream(dialect), 5);
        std::vector<PacketStyle> styles;
        for (const Link link : {Link::Ethernet, Link::Cooked, Link::Cooked2, Link::Null, Link::Loop, Link::Raw}) {
            for (const bool ipv6 : {false, true}) styles.push_back({link, ipv6});
        }
        for (const int vlans : {1, 2}) styles.push_back({.vlans = vlans});
        for (const bool bigEndian : {false, true}) {
            styles.push_back({.bigEndian = bigEndian, .nanoseconds = true});
            styles.push_back({.bigEndian = bigEndian});
            for (const int resolution : {3, 6, 9, 128 + 20})
                styles.push_back({.bigEndian = bigEndian, .pcapng = true, .resolution = resolution});
        }
        for (const PacketStyle& style : styles) {
            SCOPED_TRACE(std::to_string(static_cast<int>(style.link)) + (style.ipv6 ? " IPv6" : "") + (style.pcapng ? " pcapng " : " ") +
                         std::to_string(style.resolution) + (style.bigEndian ? " big" : ""));
            const auto scan = readBytes(captureOf(parts, style), ".pcap");
            ASSERT_TRUE(scan) << scan.error().sentence();
            EXPECT_EQ(scan->format, "capture");
            EXPECT_TRUE(sameScan(*scan, expected));
            ASSERT_TRUE(scan->acquisition);
            EXPECT_EQ(scan->acquisition->serial, "18110550");
            EXPECT_EQ(scan->acquisition->startUtc.substr(0, 14), "2023-11-14T22:");
            EXPECT_TRUE(captureTold(*scan, "ASSUMED"));
        }
    }
}

TEST(Capture, TimesOfLaterYearsAreRightOrReported) {
    const auto startOf = [](std::int64_t seconds, const PacketStyle& style) {
        std::vector<TcpPart> parts = segmentsOf(telegramStream(), 5);
        for (TcpPart& part : parts) part.timeNs += seconds * 1'000'000'000 - kEpochNs;
        auto scan = readBytes(captureOf(parts, style), ".pcap");
        EXPECT_TRUE(scan && scan->acquisition);
        return std::pair(scan->acquisition->startUtc, captureTold(*scan, "a time before 1970 or after 2262"));
    };
    constexpr std::int64_t kMinute = 60;
    for (const char* from : {"2038-01-19T03:14", "2043-01-25T23:58", "2043-01-26T08:00", "2100-03-01T00:00", "2106-02-07T06:20"}) {
        const auto seconds = static_cast<std::int64_t>(*parseUtc(std::string(from) + ":10Z"));
        for (const PacketStyle& style : {PacketStyle{}, PacketStyle{.nanoseconds = true}, PacketStyle{.pcapng = true, .resolution = 6}}) {
            const auto [start, reported] = startOf(seconds, style);
            EXPECT_LT(std::abs(parseUtc(start).value_or(0) - static_cast<double>(seconds)), kMinute) << from << " became " << start;
            EXPECT_FALSE(reported);
        }
    }
    for (const char* from : {"2116-02-20T23:58", "2262-03-28T12:00"}) { // later than the 32 bits of PCAP
        const auto seconds = static_cast<std::int64_t>(*parseUtc(std::string(from) + ":10Z"));
        const auto [start, reported] = startOf(seconds, {.pcapng = true, .resolution = 9});
        EXPECT_LT(std::abs(parseUtc(start).value_or(0) - static_cast<double>(seconds)), kMinute) << from << " became " << start;
        EXPECT_FALSE(reported);
    }
    EXPECT_TRUE(startOf(9'223'000'000, {.pcapng = true, .resolution = 6}).second); // 2262-04-07
}

TEST(Capture, ARecordingReportsTimesThatItCannotHold) {
    std::vector<RecordingMessagePtr> messages;
    const std::string payload = "\x02sRA x\x03";
    const auto message = [&](std::int64_t ns) {
        messages.push_back(
            std::make_shared<const RecordingMessage>(RecordingMessage{RecordingTopic::ColaRx, ns, {payload.begin(), payload.end()}}));
    };
    message(kLatestNs - 1'000'000'000);
    auto recording = Recording::fromBytes(recordingBytes({}, messages), "x.mcap");
    ASSERT_TRUE(recording);
    EXPECT_TRUE((*recording)->warnings().empty());
    message(std::numeric_limits<std::int64_t>::max());
    recording = Recording::fromBytes(recordingBytes({}, messages), "x.mcap");
    ASSERT_TRUE(recording);
    ASSERT_EQ((*recording)->warnings().size(), 1U);
    EXPECT_NE((*recording)->warnings()[0].find("are after 2262-03-29T"), std::string::npos) << (*recording)->warnings()[0];
}

TEST(Capture, PacketsOutOfOrderTwiceAndOverlappingArePutInOrder) {
    const std::string stream = telegramStream();
    const Scan expected = recordedSweep();
    for (unsigned seed = 1; seed <= 12; ++seed) {
        std::mt19937 random(seed);
        std::vector<TcpPart> parts = segmentsOf(stream, seed);
        const std::size_t count = parts.size();
        for (std::size_t n = 1; n < count; n += 1 + random() % 6) {
            const std::size_t at = parts[n].sequence - parts[1].sequence;
            parts.push_back(
                {parts[n].sequence, stream.substr(at, parts[n].payload.size() + random() % 900), false, parts[n].timeNs}); // longer
            parts.push_back({parts[n].sequence - 1, "x", false, parts[n].timeNs});                                         // a keep-alive
        }
        for (std::size_t n = 1; n + 8 < parts.size(); n += 4)
            std::shuffle(parts.begin() + static_cast<std::ptrdiff_t>(n), parts.begin() + static_cast<std::ptrdiff_t>(n + 8), random);
        const MadePackets made(parts);
        const TcpStreams streams = tcpStreams(made.packets);
        ASSERT_EQ(streams.streams.size(), 1U);
        EXPECT_EQ(streams.streams[0].missing, 0U);
        EXPECT_EQ(streams.streams[0].bytes, stream.size());
        EXPECT_EQ(joined(streams.streams[0]), stream);
        const auto scan = readBytes(captureOf(parts, {}), ".pcapng");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_TRUE(sameScan(*scan, expected));
        EXPECT_TRUE(captureTold(*scan, "brought bytes again"));
    }
}

TEST(Capture, LostSegmentsAreCountedAndTheirLinesAreLost) {
    const std::string stream = telegramStream();
    const std::size_t frame = telegramBytes(0, scanner::Dialect::B).size();
    std::vector<TcpPart> parts = segmentsOf(stream, 3, 1000, 60);
    // Damages the telegrams 7 and 20 to 22 except for some bytes.
    std::uint64_t lost = 0;
    std::erase_if(parts, [&](const TcpPart& part) {
        const std::size_t at = part.sequence - 1000;
        const bool hit =
            !part.syn && ((at / frame == 7 && at % frame > 70 && at % frame < 130) || (at > 20 * frame + 61 && at + 61 < 23 * frame));
        lost += hit ? part.payload.size() : 0;
        return hit;
    });
    const auto scan = readBytes(captureOf(parts, {}), ".pcap");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(captureTold(*scan, std::to_string(lost) + " bytes that the scanner sent are missing in the capture, in 2 places"));
    ASSERT_EQ(scan->lines(), kCapturedLines);
    for (int line = 0; line < kCapturedLines; ++line) {
        const bool gone = line == 7 || (line >= 20 && line <= 22);
        EXPECT_TRUE(gone ? rowIsLost(*scan, line) : rowHolds(*scan, line, line)) << line;
    }
}

TEST(Capture, TheConnectionWithScansIsTakenAndAReconnectedScannerIsOne) {
    const std::string stream = telegramStream();
    const std::size_t half = 17 * telegramBytes(0, scanner::Dialect::B).size();
    std::vector<TcpPart> parts = segmentsOf(stream.substr(0, half), 2, 5000);
    std::vector<TcpPart> again = segmentsOf(stream.substr(half), 4, 900'000); // another connection between the same ports
    const std::int64_t later = parts.back().timeNs + 40'000'000 - kEpochNs;
    for (TcpPart& part : again) part.timeNs += later;
    std::vector<TcpPart> web = segmentsOf("HTTP/1.1 200 OK\r\n\r\n" + std::string(5000, '\x02'), 6, 77);
    for (TcpPart& part : web) {
        part.fromPort = 80;
        part.host = 9;
    }
    parts.insert(parts.begin() + 5, web.begin(), web.end());
    parts.insert(parts.end(), again.begin(), again.end());
    const auto scan = readBytes(captureOf(parts, {}), ".pcap");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(captureTold(*scan, "3 streams; that of 192.168.0.1:2112 with 40 scan telegrams was opened."));
    for (int line = 0; line < kCapturedLines; ++line) EXPECT_TRUE(rowHolds(*scan, line, line)) << line;
    // Two programs are connected to one scanner: each telegram counts once.
    std::vector<TcpPart> twice = segmentsOf(stream, 8, 100);
    std::vector<TcpPart> other = segmentsOf(stream, 9, 200);
    for (TcpPart& part : other) part.toPort = 50001;
    twice.insert(twice.end(), other.begin(), other.end());
    const auto once = readBytes(captureOf(twice, {}), ".pcap");
    ASSERT_TRUE(once) << once.error().sentence();
    EXPECT_TRUE(sameScan(*once, recordedSweep()));
}

TEST(Capture, StreamsAsTheyCameInEitherDialect) {
    for (const scanner::Dialect dialect : {scanner::Dialect::A, scanner::Dialect::B}) {
        const Scan expected = recordedSweep(dialect);
        const std::string stream = telegramStream(dialect);
        const auto scan = readBytes(stream, ".bin");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->format, "CoLa stream");
        EXPECT_TRUE(sameScan(*scan, expected));
        ASSERT_TRUE(scan->acquisition);
        EXPECT_EQ(scan->acquisition->serial, "18110550");
        EXPECT_EQ(scan->acquisition->startUtc, "") << "the stream says no time";
        EXPECT_TRUE(captureTold(*scan, "ASSUMED: the axis (spin), the step from line to line (0.18 degrees"));
        // Begins in the middle of a telegram and ends in the middle of another.
        const auto part = readBytes(stream.substr(20, stream.size() - 30), ".bin");
        ASSERT_TRUE(part) << part.error().sentence();
        EXPECT_EQ(part->lines(), kCapturedLines - 2);
        EXPECT_TRUE(captureTold(*part, "bytes of the stream belong to no whole telegram"));
    }
}

TEST(Capture, WhatTheUserSaysOfTheMountingIsNotAssumed) {
    ReadingOptions options;
    options.axis = Axis::Sweep;
    options.lineStartDeg = -30;
    options.lineStepDeg = -0.5;
    const auto scan = readBytes(telegramStream(), ".bin", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    EXPECT_EQ(polar.axis, Axis::Sweep);
    EXPECT_NEAR(polar.lineDeg[0], -30, 1e-12);
    EXPECT_NEAR(polar.lineDeg[10], -35, 1e-9);
    EXPECT_FALSE(captureTold(*scan, "ASSUMED"));
    options.axis.reset();
    const auto half = readBytes(telegramStream(), ".bin", options);
    EXPECT_TRUE(captureTold(*half, "ASSUMED: the axis (spin). Give --axis"));
}

TEST(Capture, WhatHoldsNoScanIsRefusedWithASentence) {
    const std::vector<TcpPart> web = segmentsOf("HTTP/1.1 200 OK\r\n\r\n" + std::string(5000, 'x'), 6, 77);
    EXPECT_NE(refusalOf(captureOf(web, {}), ".pcap").find("no scan telegram of a SICK scanner"), std::string::npos);
    const Bytes answer = scanner::framed(Bytes{'s', 'R', 'A', ' ', 'x'}, scanner::Dialect::B);
    EXPECT_NE(refusalOf(std::string(answer.begin(), answer.end()), ".bin").find("1 telegram of a SICK device and none is a scan"),
              std::string::npos);
    EXPECT_NE(refusalOf(std::string("\0\1\2\3\4\5\6\7\2\2\2\2", 12), ".bin").find("a binary file without a telegram of a SICK scanner"),
              std::string::npos);
    std::string broken = captureOf(segmentsOf(telegramStream(), 1), {.pcapng = true});
    putAt(broken, 28 + 32 + 4, std::uint32_t{7});
    EXPECT_NE(refusalOf(broken, ".pcapng").find("byte 60: a block of this PCAPNG capture says that it has 7 bytes"), std::string::npos);
}

TEST(Capture, CutOffItOpensWithAllBeforeTheCut) {
    const std::string file = captureOf(segmentsOf(telegramStream(), 1), {});
    const auto scan = readBytes(file.substr(0, file.size() * 2 / 3), ".pcap");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(captureTold(*scan, "cut off"));
    EXPECT_GT(scan->lines(), kCapturedLines / 2);
    for (int line = 0; line < scan->lines(); ++line) EXPECT_TRUE(rowHolds(*scan, line, line)) << line;
}

TEST(Capture, RealTelegramsHoldWhatAnotherProgramFoundInThem) {
    if (!std::filesystem::exists(vectorsFolder())) GTEST_SKIP() << vectorsFolder() << " is not there";
    for (const auto& [stream, table] :
         {std::pair("lms511_a_d2h.bin", "lms511_a_scans.csv"), std::pair("lms511_a_colaa.bin", "lms511_a_colaa_scans.csv")}) {
        const Bytes bytes = fileBytes(vectorsFolder() / stream);
        // Unchanged, and split into packets.
        const std::string text(bytes.begin(), bytes.end());
        for (const bool packets : {false, true}) {
            const auto scan = readBytes(packets ? captureOf(segmentsOf(text, 1), {.pcapng = true}) : text, ".bin");
            ASSERT_TRUE(scan) << scan.error().sentence();
            std::ifstream rows(vectorsFolder() / table);
            std::string row, cell;
            std::getline(rows, row);
            std::vector<std::string> names;
            for (std::istringstream cells(row); std::getline(cells, cell, ',');) names.push_back(cell);
            const auto sum = static_cast<std::size_t>(std::ranges::find(names, "dist1_sum") - names.begin());
            ASSERT_LT(sum, names.size());
            int line = 0;
            for (; std::getline(rows, row); ++line) {
                ASSERT_LT(line, scan->lines());
                std::istringstream cells(row);
                for (std::size_t n = 0; n <= sum; ++n) std::getline(cells, cell, ',');
                double found = 0;
                for (int beam = 0; beam < scan->beams(); ++beam) found += static_cast<double>(scan->rangeMm.at(line, beam));
                EXPECT_EQ(found, std::stod(cell)) << stream << " line " << line;
            }
            EXPECT_EQ(line, scan->lines());
            EXPECT_GT(line, 19);
        }
    }
}
