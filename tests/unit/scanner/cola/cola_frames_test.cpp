// Frames from a byte stream: real, torn, corrupted, split and merged in every way.
#include "core/scanner/cola/frames.h"
#include "tests/support/cola_vectors.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

std::vector<ColaFrame> pushed(ColaStream& stream, ByteView bytes, const std::function<std::size_t()>& cut) {
    std::vector<ColaFrame> frames;
    while (!bytes.empty()) {
        const std::size_t count = std::min(cut(), bytes.size());
        for (ColaFrame& frame : stream.push(bytes.first(count))) frames.push_back(std::move(frame));
        bytes = bytes.subspan(count);
        EXPECT_LE(stream.waiting(), kLongestFrame);
    }
    return frames;
}

Bytes text(const std::string& characters) { return {characters.begin(), characters.end()}; }

Bytes joined(std::initializer_list<Bytes> parts) {
    Bytes all;
    for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// A stream of valid frames of both dialects; between them are random bytes with many STX, ETX and start marks.
Bytes roughStream(unsigned seed) {
    std::mt19937 random(seed);
    Bytes stream;
    for (int i = 0; i < 30; ++i) {
        const std::size_t length = random() % 60;
        Bytes payload = text("s");
        for (std::size_t k = 0; k < length; ++k) payload.push_back(static_cast<std::uint8_t>('0' + random() % 10));
        const Bytes frame = framed(payload, random() % 2 == 0 ? Dialect::A : Dialect::B);
        stream.insert(stream.end(), frame.begin(), frame.end());
        for (std::size_t k = random() % 12; k > 0; --k) {
            constexpr std::uint8_t kNasty[] = {0x02, 0x02, 0x02, 0x03, 's', 0x00, 0x00, 0xFF};
            stream.push_back(kNasty[random() % 8]);
        }
    }
    return stream;
}

} // namespace

TEST(ColaFrames, EveryTortureStreamGivesItsFrames) {
    EDGESCAN_NEEDS_VECTORS();
    int streams = 0;
    for (const auto& entry : std::filesystem::directory_iterator(vectorsFolder() / "torture")) {
        if (entry.path().extension() != ".json") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const nlohmann::json expected = fileJson(entry.path());
        const std::string mode = expected["mode"];
        const Bytes bytes = fileBytes(std::filesystem::path(entry.path()).replace_extension(".bin"));
        for (const bool detecting : {false, true}) {
            ColaStream stream(detecting || mode == "auto" ? std::nullopt : std::optional(mode == "A" ? Dialect::A : Dialect::B));
            std::vector<ColaFrame> frames = stream.push(bytes);
            // If the stream starts inside a frame, two ranges may look like a text frame; its start cannot be distinguished from a real
            // one.
            std::uint64_t inFrames = 0;
            for (const ColaFrame& frame : frames) inFrames += frame.bytes.size();
            EXPECT_EQ(stream.counts().skipped + inFrames + stream.waiting(), bytes.size());
            if (!detecting) {
                EXPECT_EQ(stream.counts().badChecksum, expected["bad_checksum"]);
                EXPECT_EQ(stream.counts().tooLong + (mode == "B" ? stream.counts().notCola : 0), expected["bad_length"]);
                ASSERT_EQ(frames.size(), expected["frames"].size());
            }
            std::erase_if(frames, [&](const ColaFrame& frame) { return mode == "B" && frame.dialect == Dialect::A; });
            ASSERT_EQ(frames.size(), expected["frames"].size());
            for (std::size_t i = 0; i < frames.size(); ++i) {
                EXPECT_EQ(frames[i].offset, expected["frames"][i]["offset"]);
                EXPECT_EQ(frames[i].payload().size(), expected["frames"][i]["payload_len"]);
                EXPECT_EQ(crc32Text(frames[i].payload()), expected["frames"][i]["payload_crc32"].get<std::string>());
                EXPECT_TRUE(
                    std::equal(frames[i].bytes.begin(), frames[i].bytes.end(), bytes.begin() + static_cast<long>(frames[i].offset)));
                EXPECT_EQ(frames[i].bytes, framed(frames[i].payload(), frames[i].dialect));
            }
        }
        ++streams;
    }
    EXPECT_EQ(streams, 10);
}

TEST(ColaFrames, HoweverTheBytesAreCutTheFramesAreTheSame) {
    std::vector<Bytes> streams;
    for (unsigned seed = 1; seed <= 40; ++seed) streams.push_back(roughStream(seed));
    if (std::filesystem::exists(vectorsFolder())) {
        for (const auto& entry : std::filesystem::directory_iterator(vectorsFolder() / "torture")) {
            if (entry.path().extension() == ".bin") streams.push_back(fileBytes(entry.path()));
        }
    }
    std::mt19937 random(5);
    for (const Bytes& bytes : streams) {
        for (const auto only : {std::optional<Dialect>(), std::optional(Dialect::A), std::optional(Dialect::B)}) {
            ColaStream whole(only), single(only), uneven(only);
            const auto expected = whole.push(bytes);
            EXPECT_EQ(pushed(single, bytes, [] { return std::size_t{1}; }), expected);
            EXPECT_EQ(single.counts(), whole.counts());
            EXPECT_EQ(pushed(uneven, bytes, [&] { return std::size_t{1} + random() % 3000; }), expected);
            EXPECT_EQ(uneven.counts(), whole.counts());
        }
    }
}

TEST(ColaFrames, AStreamOfTelegramsHasNothingButFrames) {
    for (const char* name : {"plain.colaa.bin", "plain.colab.bin", "encoders.colab.bin", "blocks.colab.bin"}) {
        ColaStream stream;
        const Bytes bytes = fileBytes(ownTelegrams() / name);
        std::size_t size = 0;
        for (const ColaFrame& frame : stream.push(bytes)) {
            EXPECT_TRUE(isScanTelegram(frame.payload())) << name;
            EXPECT_EQ(frame.offset, size) << name;
            size += frame.bytes.size();
        }
        EXPECT_EQ(size, bytes.size()) << name;
        EXPECT_EQ(stream.counts().skipped, 0U) << name;
        EXPECT_EQ(stream.waiting(), 0U) << name;
    }
}

TEST(ColaFrames, RealCaptureHasNothingButFrames) {
    EDGESCAN_NEEDS_VECTORS();
    ColaStream stream;
    const auto frames = stream.push(fileBytes(vectorsFolder() / "lms511_a_d2h.bin"));
    EXPECT_EQ(stream.counts().skipped, 0U);
    EXPECT_EQ(stream.waiting(), 0U);
    const auto rows = csvRows(vectorsFolder() / "lms511_a_scans.csv");
    std::size_t scans = 0;
    for (const ColaFrame& frame : frames) {
        if (!isScanTelegram(frame.payload())) continue;
        ASSERT_LT(scans, rows.size());
        EXPECT_EQ(std::to_string(frame.offset), rows[scans].at("offset"));
        EXPECT_EQ(std::to_string(frame.bytes.size()), rows[scans].at("frame_len"));
        ++scans;
    }
    EXPECT_EQ(scans, rows.size());
}

TEST(ColaFrames, AFrameHasTheTimeOfItsFirstByte) {
    const Bytes a = framed(text("sRA one"), Dialect::A);
    const Bytes b = framed(text("sRA two"), Dialect::B);
    const Bytes bytes = joined({a, b, a});
    ColaStream stream;
    const auto at = [](std::int64_t ns) { return HostTime{ns, 1000 + ns}; };
    EXPECT_TRUE(stream.push(ByteView(bytes).first(3), at(10)).empty());
    const auto first = stream.push(ByteView(bytes).subspan(3, a.size() - 2), at(20)); // ends with the first byte of the second frame
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(first[0].received, at(10));
    const auto others = stream.push(ByteView(bytes).subspan(a.size() + 1), at(30));
    ASSERT_EQ(others.size(), 2U);
    EXPECT_EQ(others[0].received, at(20));
    EXPECT_EQ(others[1].received, at(30));
}

TEST(ColaFrames, ABadFrameNeverHidesAGoodOne) {
    Bytes corrupt = framed(text("sRA three"), Dialect::B);
    corrupt[10] ^= 1U;
    Bytes greedy = framed(text("sRA four"), Dialect::B);
    greedy[6] = 0x01; // claims 256 bytes more than it has
    const Bytes good = framed(text("sRA good"), Dialect::B);
    Bytes filler;
    for (int i = 0; i < 300; ++i) filler.push_back(static_cast<std::uint8_t>('a' + i % 19));
    ColaStream stream;
    const auto frames = stream.push(joined({corrupt, good, greedy, good, good, filler, good}));
    ASSERT_EQ(frames.size(), 4U);
    EXPECT_EQ(stream.counts().badChecksum, 2U);
    EXPECT_EQ(frames[0].skippedBefore, corrupt.size());
    EXPECT_EQ(frames[1].skippedBefore, greedy.size());
    EXPECT_EQ(frames[3].skippedBefore, filler.size());
}

TEST(ColaFrames, AnEndlessTextDoesNotFillTheMemory) {
    ColaStream stream;
    const Bytes endless(5000, 's');
    EXPECT_TRUE(stream.push(Bytes{0x02}).empty());
    for (int i = 0; i < 200; ++i) {
        EXPECT_TRUE(stream.push(endless).empty());
        EXPECT_LE(stream.waiting(), kLongestFrame);
    }
    EXPECT_EQ(stream.counts().tooLong, 1U);
    EXPECT_EQ(stream.push(framed(text("sAN x"), Dialect::A)).size(), 1U);
    // The longest allowed payload passes, one byte more does not.
    for (const Dialect dialect : {Dialect::A, Dialect::B}) {
        EXPECT_EQ(stream.push(framed(Bytes(kLongestPayload, 's'), dialect)).size(), 1U);
        EXPECT_TRUE(stream.push(framed(Bytes(kLongestPayload + 1, 's'), dialect)).empty());
    }
}
