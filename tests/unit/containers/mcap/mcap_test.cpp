// MCAP written and read: every byte as in the specification, and damage loses only the damaged part.
#include "core/containers/compression/chunks.h"
#include "core/containers/mcap/reader.h"
#include "core/containers/mcap/writer.h"
#include "core/files/recording/recording.h"
#include "tests/support/live_lines.h"
#include "tests/support/packed_files.h"
#include "tests/support/point_lists.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace edgescan;
using namespace edgescan::containers;
using namespace edgescan::test;

namespace {

const std::string kDemo = (edgescan::test::sharedFolder() / "protocol/vectors/sweep_demo.mcap").string();
const std::string kMcapMin = (edgescan::test::sharedFolder() / "protocol/tools/mcap_min.py").string();

Bytes bytesOfFile(const std::filesystem::path& path) {
    const std::string text = readText(path);
    return {text.begin(), text.end()};
}

Bytes payloadOf(int n, std::size_t size) {
    Bytes payload(size);
    for (std::size_t i = 0; i < size; ++i) payload[i] = static_cast<std::uint8_t>((static_cast<std::size_t>(n) * 7 + i * 31) % 251);
    return payload;
}

/// A file with `count` messages of all sizes on two channels.
Bytes sampleFile(int count, McapLimits limits = {}) {
    McapEncoder encoder("test", limits);
    encoder.schema({1, "a", "text", "schema"});
    encoder.channel({1, 1, "/a", "x-a", {{"key", "value"}}});
    encoder.channel({7, 0, "/b", "json", {}});
    encoder.metadata({"first", {{"one", "1"}, {"two", ""}}});
    for (int n = 0; n < count; ++n) {
        const Bytes payload = payloadOf(n, static_cast<std::size_t>(n * 37 % 3000));
        const auto logNs = static_cast<std::uint64_t>(1000 + n * 10'000'000LL);
        encoder.message({static_cast<std::uint16_t>(n % 3 == 0 ? 7 : 1), static_cast<std::uint32_t>(n), logNs, logNs - 5, payload});
    }
    encoder.metadata({"last", {}});
    encoder.finish();
    return encoder.popBytes();
}

/// Exactly the messages of `sampleFile`, from the first one on.
void expectPrefix(const McapContent& content) {
    for (std::size_t i = 0; i < content.messages.size(); ++i) {
        const McapMessage& message = content.messages[i];
        const int n = static_cast<int>(i);
        ASSERT_EQ(message.sequence, i);
        ASSERT_EQ(message.channel, n % 3 == 0 ? 7 : 1);
        ASSERT_EQ(message.logNs, static_cast<std::uint64_t>(1000 + n * 10'000'000LL));
        const Bytes expected = payloadOf(n, static_cast<std::size_t>(n * 37 % 3000));
        ASSERT_TRUE(std::equal(message.payload.begin(), message.payload.end(), expected.begin(), expected.end()));
    }
}

/// A file whose only chunk holds `records`, compressed as `compression`.
Bytes packedFile(const std::string& compression, const Bytes& packed, std::uint64_t size, std::uint32_t crc) {
    McapEncoder encoder("test");
    encoder.channel({1, 0, "/a", "x", {}});
    McapBytes file;
    file.raw(encoder.popBytes());
    McapBytes chunk;
    chunk.number64(1);
    chunk.number64(2);
    chunk.number64(size);
    chunk.number32(crc);
    chunk.string(compression);
    chunk.number64(packed.size());
    chunk.raw(packed);
    file.record(McapOpcode::Chunk, chunk.bytes());
    return file.popBytes();
}

Bytes fromHex(std::string_view hex) {
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    return bytes;
}

/// One message of 200 times 'a', and the same compressed by the programs zstd and lz4.
Bytes plainRecords() {
    McapBytes message;
    message.number16(1);
    message.number32(0);
    message.number64(1);
    message.number64(1);
    message.raw(std::string(200, 'a'));
    McapBytes records;
    records.record(McapOpcode::Message, message.bytes());
    return records.popBytes();
}
bool builtWith([[maybe_unused]] const std::string& compression) {
#ifdef EDGESCAN_ZSTD
    if (compression == "zstd") return true;
#endif
#ifdef EDGESCAN_LZ4
    if (compression == "lz4") return true;
#endif
    return false;
}

const std::vector<std::pair<std::string, std::string>> kPacked{
    {"zstd", "28b52ffd20e7b500004805de000100010000610400441c3531ef8280073004"},
    {"lz4", "04224d186040821b0000003205de000100110107000206000608001f610100af50616161616100000000"}};

} // namespace

TEST(Mcap, Crc32IsThatOfZip) {
    const std::string digits = "123456789";
    const Bytes bytes(digits.begin(), digits.end());
    EXPECT_EQ(crc32(bytes), 0xCBF43926U);
    EXPECT_EQ(crc32({}), 0U);
}

TEST(Mcap, WhatIsWrittenIsRead) {
    const Bytes file = sampleFile(300);
    const auto content = readMcap(file, "test");
    ASSERT_TRUE(content);
    EXPECT_TRUE(content->clean);
    EXPECT_TRUE(content->warnings.empty());
    EXPECT_EQ(content->library, "test");
    EXPECT_EQ(content->schemas.at(1), (McapSchema{1, "a", "text", "schema"}));
    EXPECT_EQ(content->channels.at(1), (McapChannel{1, 1, "/a", "x-a", {{"key", "value"}}}));
    ASSERT_EQ(content->metadata.size(), 2U);
    EXPECT_EQ(content->metadata[0], (McapMetadata{"first", {{"one", "1"}, {"two", ""}}}));
    ASSERT_EQ(content->messages.size(), 300U);
    expectPrefix(*content);
}

TEST(Mcap, ChunksStayWithinTheirLimits) {
    const Bytes file = sampleFile(400);
    std::size_t chunks = 0;
    for (std::size_t at = kMcapMagic.size(); at + kMcapRecordHead < file.size();) {
        McapCursor cursor(ByteView(file).subspan(at));
        const auto opcode = static_cast<McapOpcode>(cursor.number8());
        const std::uint64_t length = cursor.number64();
        if (opcode == McapOpcode::Chunk) {
            ++chunks;
            const std::uint64_t first = cursor.number64();
            const std::uint64_t last = cursor.number64();
            EXPECT_LE(last - first, 200'000'000U);
            EXPECT_LE(cursor.number64(), 64U * 1024);
            EXPECT_NE(cursor.number32(), 0U) << "CRC";
        }
        if (opcode == McapOpcode::DataEnd) break;
        at += kMcapRecordHead + static_cast<std::size_t>(length);
    }
    EXPECT_GT(chunks, 15U);
}

TEST(Mcap, FiveHundredCutsGiveAnExactPrefix) {
    const Bytes file = sampleFile(120);
    std::mt19937 random(2);
    std::size_t last = 0;
    std::vector<std::size_t> cuts;
    for (int i = 0; i < 500; ++i) cuts.push_back(8 + random() % (file.size() - 8));
    std::sort(cuts.begin(), cuts.end());
    for (const std::size_t cut : cuts) {
        const auto content = readMcap(ByteView(file).first(cut), "test");
        ASSERT_TRUE(content);
        EXPECT_FALSE(content->clean);
        expectPrefix(*content);
        EXPECT_GE(content->messages.size(), last) << "a longer piece holds no less";
        last = content->messages.size();
    }
    EXPECT_EQ(last, 120U);
    for (std::size_t cut = 0; cut < 8; ++cut) EXPECT_FALSE(readMcap(ByteView(file).first(cut), "test"));
}

TEST(Mcap, FlippedBytesNeverCrashAndSoundChunksStay) {
    const Bytes file = sampleFile(200);
    std::mt19937 random(3);
    int told = 0;
    for (int round = 0; round < 2000; ++round) {
        Bytes damaged = file;
        const auto flips = 1 + random() % (round % 4 == 0 ? 40 : 1);
        for (std::size_t i = 0; i < flips; ++i)
            damaged[8 + random() % (damaged.size() - 8)] ^= static_cast<std::uint8_t>(1 + random() % 255);
        const auto content = readMcap(damaged, "test");
        ASSERT_TRUE(content);
        EXPECT_LE(content->messages.size(), 200U);
        if (flips > 1) continue;
        // One damaged byte costs at most one chunk (as many messages as fit 64 KiB or 200 ms), and all messages read are as written.
        EXPECT_GE(content->messages.size(), 200U - 45);
        EXPECT_EQ(content->channels.size(), 2U) << "also when their records are damaged: the summary repeats them";
        if (content->messages.size() < 200) {
            EXPECT_FALSE(content->warnings.empty() && content->clean);
            ++told;
        }
    }
    EXPECT_GT(told, 500);
}

TEST(Mcap, HostileLengthsAllocateNothing) {
    const Bytes file = sampleFile(3);
    std::mt19937_64 random(5);
    for (int round = 0; round < 3000; ++round) {
        Bytes damaged = file;
        const std::size_t at = 8 + random() % (damaged.size() - 16);
        const std::uint64_t length = round % 2 == 0 ? random() >> (random() % 60) : ~std::uint64_t{0} - random() % 64;
        for (unsigned i = 0; i < 8; ++i) damaged[at + i] = static_cast<std::uint8_t>(length >> (8 * i));
        EXPECT_TRUE(readMcap(damaged, "test"));
    }
}

TEST(Mcap, UnknownRecordsAreSkipped) {
    McapBytes file;
    McapEncoder encoder("test");
    encoder.channel({1, 0, "/a", "x", {}});
    file.raw(encoder.popBytes());
    file.record(static_cast<McapOpcode>(0x09), Bytes(100, 1)); // an attachment
    file.record(static_cast<McapOpcode>(0x90), Bytes(5, 2));   // a private record type
    encoder.message({1, 9, 1, 1, Bytes(10, 3)});
    encoder.endChunk();
    file.raw(encoder.popBytes());
    const auto content = readMcap(file.bytes(), "test");
    ASSERT_TRUE(content);
    EXPECT_EQ(content->messages.size(), 1U);
    EXPECT_TRUE(content->warnings.empty());
}

TEST(Mcap, CompressedChunksAreReadOrRefusedInWords) {
    const Bytes plain = plainRecords();
    for (const auto& [name, hex] : kPacked) {
        const Bytes packed = fromHex(hex);
        const auto unpacked = unpackChunk(name, packed, plain.size(), "test");
        const Bytes file = packedFile(name, packed, plain.size(), crc32(plain));
        const auto content = readMcap(file, "test");
        ASSERT_TRUE(content);
        EXPECT_TRUE(unpacked || !builtWith(name)) << name;
        if (!unpacked) {
            EXPECT_NE(unpacked.error().sentence().find("built without"), std::string::npos);
            EXPECT_EQ(content->badChunks, 1U);
            EXPECT_NE(content->warnings.at(0).find("built without"), std::string::npos);
            continue;
        }
        EXPECT_EQ(*unpacked, plain);
        ASSERT_EQ(content->messages.size(), 1U);
        EXPECT_EQ(content->messages[0].payload.size(), 200U);
        // Sizes that are too small or too large, and damage.
        for (const std::uint64_t size :
             {std::uint64_t{0}, std::uint64_t{10}, std::uint64_t{plain.size() - 1}, std::uint64_t{plain.size() + 1}, ~std::uint64_t{0}}) {
            EXPECT_FALSE(unpackChunk(name, packed, size, "test"));
            EXPECT_EQ(readMcap(packedFile(name, packed, size, 0), "test")->messages.size(), 0U);
        }
        for (std::size_t cut = 0; cut < packed.size(); ++cut)
            EXPECT_FALSE(unpackChunk(name, Bytes(packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(cut)), plain.size(), "test"));
    }
    EXPECT_FALSE(unpackChunk("brotli", {}, 0, "test"));
}

TEST(Mcap, UnpackingAndReadingAreCancelled) {
    int asked = 0;
    const auto twice = [&] { return ++asked < 3; };
    const auto whole = readMcap(sampleFile(300, {.chunkBytes = 100}), "test", twice);
    ASSERT_FALSE(whole);
    EXPECT_EQ(whole.error().what, "cancelled");
    if (!builtWith("zstd")) GTEST_SKIP();
    constexpr std::uint64_t kSize = 6U << 20U;
    const std::string zeros = zstdZeros(6);
    const Bytes packed(zeros.begin(), zeros.end());
    EXPECT_TRUE(unpackChunk("zstd", packed, kSize, "test", [] { return true; }));
    asked = 0;
    const auto unpacked = unpackChunk("zstd", packed, kSize, "test", twice);
    ASSERT_FALSE(unpacked);
    EXPECT_EQ(unpacked.error().what, "cancelled");
    EXPECT_EQ(asked, 3);
    asked = 0;
    const auto content = readMcap(packedFile("zstd", packed, kSize, 0), "test", twice); // not as without a damaged chunk
    ASSERT_FALSE(content);
    EXPECT_EQ(content.error().what, "cancelled");
}

TEST(Mcap, ChecksumsOfPartsAreThoseOfTheirBytes) {
    std::mt19937_64 random(7);
    Bytes bytes(50'000);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1023}, std::size_t{1024}, std::size_t{5000}, bytes.size()}) {
        const ByteView all = ByteView(bytes).first(size);
        const PartChecksums sums(all);
        for (int round = 0; round < 300; ++round) {
            const std::size_t from = random() % (size + 1);
            const std::size_t count = round == 0 ? size - from : random() % (size - from + 1);
            ASSERT_EQ(sums.of(from, count), crc32(all.subspan(from, count))) << size << ' ' << from << ' ' << count;
        }
        EXPECT_EQ(sums.of(0, size), crc32(all));
    }
}

TEST(Mcap, AfterDamageTheRestIsReadWhateverLiesBetween) {
    const Bytes file = sampleFile(60, {2000, 1'000'000'000});
    const auto whole = readMcap(file, "test");
    ASSERT_TRUE(whole);
    // Many false starts of chunks that claim the rest of the file, in place of one chunk.
    const McapMessage& third = whole->messages[10];
    const auto at = static_cast<std::size_t>(third.payload.data() - file.data());
    Bytes damaged(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(at));
    for (int n = 0; n < 400; ++n) {
        const std::size_t rest = (400 - static_cast<std::size_t>(n)) * 49 + (file.size() - at) - 49;
        McapBytes head;
        head.number8(6);
        head.number64(rest + 40);
        head.number64(1);
        head.number64(2);
        head.number64(rest);
        head.number32(12345);
        head.string("");
        head.number64(rest);
        damaged.insert(damaged.end(), head.bytes().begin(), head.bytes().end());
    }
    damaged.insert(damaged.end(), file.begin() + static_cast<std::ptrdiff_t>(at), file.end());
    const auto content = readMcap(damaged, "test");
    ASSERT_TRUE(content);
    EXPECT_FALSE(content->clean);
    EXPECT_FALSE(content->warnings.empty());
    ASSERT_GT(content->messages.size(), 40U);
    EXPECT_EQ(content->messages.back().sequence, 59U); // more than 64 false starts before it
}

TEST(Mcap, CompressedChunksBehindDamageAreFound) {
    if (std::ranges::none_of(kPacked, [](const auto& each) { return builtWith(each.first); })) GTEST_SKIP() << "built without lz4 and zstd";
    const Bytes plain = plainRecords();
    for (const auto& [name, hex] : kPacked) {
        if (!builtWith(name)) continue;
        const Bytes one = packedFile(name, fromHex(hex), plain.size(), crc32(plain));
        const Bytes head(one.begin(), one.begin() + 8);
        Bytes damaged = head;
        damaged.insert(damaged.end(), 100, 0x77); // not a record
        damaged.insert(damaged.end(), one.begin() + 8, one.end());
        const auto content = readMcap(damaged, "test");
        ASSERT_TRUE(content);
        EXPECT_EQ(content->messages.size(), 1U) << name;
        EXPECT_NE(content->warnings.at(0).find("are damaged and were left out"), std::string::npos);
    }
}

TEST(Mcap, WhatWasLeftOutIsTheReasonThatNothingIsThere) {
    const Bytes plain = plainRecords();
    const auto refusal = [](const Bytes& file) {
        const auto recording = files::Recording::fromBytes(file, "x.mcap");
        return recording ? std::string() : recording.error().sentence();
    };
    const std::string wrong = refusal(packedFile("", plain, plain.size(), crc32(plain) + 1));
    EXPECT_NE(wrong.find("was left out: its checksum does not fit"), std::string::npos) << wrong;
    const std::string unknown = refusal(packedFile("brotli", plain, plain.size(), 0));
    EXPECT_NE(unknown.find("compressed with \"brotli\", which is not known here"), std::string::npos) << unknown;
    const std::string large = refusal(packedFile("zstd", plain, std::uint64_t{1} << 40U, 0));
    EXPECT_NE(large.find("promises to unpack to 1.1 TB"), std::string::npos) << large;
    for (const auto& [name, hex] : kPacked) {
        if (!builtWith(name)) continue;
        Bytes cut = fromHex(hex);
        cut.resize(cut.size() / 2);
        const std::string torn = refusal(packedFile(name, cut, plain.size(), crc32(plain)));
        EXPECT_NE(torn.find(std::string("compressed with ") + name + " and damaged or cut off"), std::string::npos) << torn;
    }
    // A valid chunk next to a damaged one is read.
    Bytes both = packedFile("brotli", plain, plain.size(), 0);
    const Bytes good = packedFile("", plain, plain.size(), crc32(plain));
    both.insert(both.end(), good.begin() + 8, good.end());
    const auto content = readMcap(both, "test");
    ASSERT_TRUE(content);
    EXPECT_EQ(content->messages.size(), 1U);
    EXPECT_EQ(content->badChunks, 1U);
}

TEST(Mcap, TheDemoHoldsWhatTheIndependentReaderSays) {
    EDGESCAN_NEEDS_SHARED("protocol/vectors");
    const auto recording = files::Recording::open(kDemo);
    ASSERT_TRUE(recording) << recording.error().sentence();
    EXPECT_TRUE((*recording)->clean());
    EXPECT_EQ((*recording)->messages().size(), 84U);
    EXPECT_EQ((*recording)->metadata().at("stepper.deg_per_step"), "0.18");
    if (std::system("command -v python3 >/dev/null 2>&1") != 0) GTEST_SKIP() << "no python3 for the independent reader";
    const Folder folder;
    const std::string script =
        "import sys,zlib; sys.dont_write_bytecode=True; sys.path.insert(0,sys.argv[1]); import mcap_min\n"
        "for k,d in mcap_min.read(open(sys.argv[2],'rb').read()):\n"
        "  if k=='message': print(d['topic'],d['seq'],d['log_ns'],d['pub_ns'],zlib.crc32(d['data']),len(d['data']))\n";
    writeText(folder / "list.py", script);
    const auto listed = [&](const std::string& file) {
        const std::string tools = std::filesystem::path(kMcapMin).parent_path().string();
        EXPECT_EQ(std::system(
                      ("python3 " + (folder / "list.py").string() + " " + tools + " " + file + " > " + (folder / "list").string()).c_str()),
                  0);
        return readText(folder / "list");
    };
    const auto ours = [](const Bytes& bytes) {
        const auto content = readMcap(bytes, "test");
        std::string text;
        for (const McapMessage& m : content->messages) {
            text += channelOf(*content, m)->topic + " " + std::to_string(m.sequence) + " " + std::to_string(m.logNs) + " " +
                    std::to_string(m.publishNs) + " " + std::to_string(crc32(m.payload)) + " " + std::to_string(m.payload.size()) + "\n";
        }
        return text;
    };
    EXPECT_EQ(ours(bytesOfFile(kDemo)), listed(kDemo));
    // And in the other direction: the independent reader reads our files, whole and truncated.
    std::vector<files::RecordingMessagePtr> messages;
    for (int n = 0; n < 40; ++n) {
        messages.push_back(lineMessage(n));
        messages.push_back(files::stepperMessage({n, 0.18 * n, 4.5, true, hostNsOfLine(n)}));
    }
    const Bytes whole = files::recordingBytes(scanner::metadataOf(scanner::SweepSettings{}), messages);
    for (const double share : {1.0, 0.9, 0.5, 0.31}) {
        const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(whole.size())));
        writeText(folder / "ours.mcap", std::string(part.begin(), part.end()));
        EXPECT_EQ(ours(part), listed((folder / "ours.mcap").string())) << share;
    }
}
