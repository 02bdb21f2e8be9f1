// The scan telegram compared with real ones: every field, both dialects, and only an error sentence if it is damaged.
#include "core/scanner/sick_lms/scan_telegram.h"
#include "tests/support/beam_angles.h"
#include "tests/support/cola_vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

nlohmann::json channelJson(const ScanChannel& c, bool values) {
    nlohmann::json json = {{"content", c.content}, {"scale", c.scale},         {"offset", c.offset},   {"start_angle", c.startAngle},
                           {"step", c.step},       {"count", c.values.size()}, {"crc32", crc32Text(c)}};
    if (values) {
        json["data"] = c.values;
    } else {
        const std::size_t ends = std::min<std::size_t>(4, c.values.size());
        json["head"] = std::vector<std::uint16_t>(c.values.begin(), c.values.begin() + static_cast<long>(ends));
        json["tail"] = std::vector<std::uint16_t>(c.values.end() - static_cast<long>(ends), c.values.end());
    }
    return json;
}

/// With the key names of ../shared/protocol/tools/cola.py.
nlohmann::json telegramJson(const ScanTelegram& t, bool values) {
    nlohmann::json json = {{"cmd", t.polled ? "sRA" : "sSN"},
                           {"name", "LMDscandata"},
                           {"version", t.version},
                           {"device", t.deviceNumber},
                           {"serial", t.serialNumber},
                           {"status", t.status},
                           {"telegram_counter", t.telegramCounter},
                           {"scan_counter", t.scanCounter},
                           {"time_since_startup_us", t.sinceStartUs},
                           {"time_of_transmission_us", t.transmittedUs},
                           {"digital_in", t.digitalIn},
                           {"digital_out", t.digitalOut},
                           {"layer", t.layer},
                           {"scan_frequency", t.scanFrequency},
                           {"measurement_frequency", t.measurementFrequency},
                           {"encoders", nlohmann::json::array()},
                           {"ch16", nlohmann::json::array()},
                           {"ch8", nlohmann::json::array()},
                           {"position", nullptr},
                           {"device_name", nullptr},
                           {"comment", nullptr},
                           {"time", nullptr},
                           {"event", nullptr},
                           {"trailing", t.trailingBytes}};
    for (const ScanEncoder& e : t.encoders) json["encoders"].push_back({{"position", e.position}, {"speed", e.speed}});
    for (const ScanChannel& c : t.channels16) json["ch16"].push_back(channelJson(c, values));
    for (const ScanChannel& c : t.channels8) json["ch8"].push_back(channelJson(c, values));
    if (t.position) {
        const auto& p = *t.position;
        json["position"] = {{"x", p.xyz[0]},
                            {"y", p.xyz[1]},
                            {"z", p.xyz[2]},
                            {"rx", p.rotation[0]},
                            {"ry", p.rotation[1]},
                            {"rz", p.rotation[2]},
                            {"rotation_type", p.rotationType}};
    }
    if (t.deviceName) json["device_name"] = *t.deviceName;
    if (t.comment) json["comment"] = *t.comment;
    if (const auto& c = t.clock)
        json["time"] = {{"year", c->year},     {"month", c->month},   {"day", c->day},       {"hour", c->hour},
                        {"minute", c->minute}, {"second", c->second}, {"us", c->microsecond}};
    if (const auto& e = t.event) json["event"] = {{"type", e->type}, {"encoder", e->encoder}, {"time_us", e->timeUs}, {"angle", e->angle}};
    return json;
}

std::string told(const Result<ScanTelegram>& result) { return result ? "" : result.error().sentence(); }

/// Small, with every block: truncated and with flipped bits at every position.
ScanTelegram fullTelegram() {
    ScanTelegram t;
    t.serialNumber = 18110550;
    t.status = {2, 0};
    t.telegramCounter = 0xFFFE;
    t.sinceStartUs = 0x80000002;
    t.scanFrequency = 2500;
    t.measurementFrequency = 540;
    t.encoders = {{0xFFFFFFFF, -3}, {7, 2}};
    t.channels16 = {{"DIST1", 2.0F, 0.0F, -50000, 1667, {0, 1, 15, 16, 514, 65535}}, {"DIST2", 1.0F, 0.0F, -50000, 1667, {}}};
    t.channels8 = {{"RSSI1", 1.0F, 0.0F, -50000, 1667, {0, 255, 2, 3, 254, 1}}};
    t.position = ScanPosition{{1.5F, -2.25F, 0.125F}, {10.0F, -20.5F, 359.0F}, 3};
    t.deviceName = "HANG UP 1";
    t.comment = "";
    t.clock = ScanClock{2023, 6, 28, 16, 21, 48, 212000};
    t.event = ScanEvent{"FDIN", 123456, 4000000000U, -900000};
    return t;
}

} // namespace

TEST(ScanTelegramDecode, EveryRealTelegramHasTheValuesOfTheTable) {
    EDGESCAN_NEEDS_VECTORS();
    for (const char* name : {"lms511_a_d2h.bin", "lms511_a_colaa.bin"}) {
        const bool binary = std::string(name) == "lms511_a_d2h.bin";
        const auto rows = csvRows(vectorsFolder() / (binary ? "lms511_a_scans.csv" : "lms511_a_colaa_scans.csv"));
        const auto frames = scanFramesOf(vectorsFolder() / name);
        ASSERT_EQ(frames.size(), rows.size());
        ASSERT_GE(frames.size(), binary ? 136U : 20U);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
            const auto telegram = decodeScanTelegram(frames[i]);
            ASSERT_TRUE(telegram) << told(telegram);
            const auto is = [&](const char* column, auto value) { EXPECT_EQ(rows[i].at(column), std::to_string(value)) << column; };
            const ScanChannel& dist = telegram->channels16.at(0);
            const ScanChannel& rssi = telegram->channels8.at(0);
            is("telegram_counter", telegram->telegramCounter);
            is("scan_counter", telegram->scanCounter);
            is("time_since_startup_us", telegram->sinceStartUs);
            is("time_of_transmission_us", telegram->transmittedUs);
            is("scan_freq", telegram->scanFrequency);
            is("meas_freq", telegram->measurementFrequency);
            is("n_enc", telegram->encoders.size());
            is("n16", telegram->channels16.size());
            is("n8", telegram->channels8.size());
            is("start_angle", dist.startAngle);
            is("step", dist.step);
            is("count", dist.values.size());
            is("dist1_max", *std::max_element(dist.values.begin(), dist.values.end()));
            is("dist1_zeros", std::count(dist.values.begin(), dist.values.end(), 0));
            EXPECT_EQ(rows[i].at("status"), std::to_string(telegram->status[0]) + " " + std::to_string(telegram->status[1]));
            EXPECT_EQ(rows[i].at("digital_out"), std::to_string(telegram->digitalOut[0]) + " " + std::to_string(telegram->digitalOut[1]));
            EXPECT_EQ(rows[i].at("dist1_crc32"), crc32Text(dist));
            EXPECT_EQ(rows[i].at("rssi1_crc32"), crc32Text(rssi));
            EXPECT_EQ(deviceFlags(*telegram).error, rows[i].at("status") == "1 0");
            EXPECT_EQ(scanFrequencyHz(*telegram), 25.0);
        }
    }
}

TEST(ScanTelegramDecode, FullDecodeOfSelectedTelegramsIsEqualToTheReference) {
    EDGESCAN_NEEDS_VECTORS();
    const auto frames = scanFramesOf(vectorsFolder() / "lms511_a_d2h.bin");
    const nlohmann::json reference = fileJson(vectorsFolder() / "lms511_a_full.json");
    ASSERT_GE(reference["scans"].size(), 2U);
    for (nlohmann::json expected : reference["scans"]) {
        const std::size_t index = expected["index"];
        expected.erase("index");
        const auto telegram = decodeScanTelegram(frames.at(index));
        ASSERT_TRUE(telegram) << told(telegram);
        for (const nlohmann::json& sample : expected["ch16"][0]["samples"]) {
            const ScanChannel& dist = telegram->channels16.at(0);
            const std::size_t beam = sample["beam"];
            EXPECT_NEAR(beamAnglesDeg(beamGrid(dist)).at(beam), sample["angle_deg"].get<double>(), 1e-9);
            EXPECT_EQ(rangesMm(dist).rangeMm.at(beam), sample["mm"].get<float>());
        }
        expected["ch16"][0].erase("samples");
        EXPECT_TRUE(telegramJson(*telegram, true) == expected) << index;
    }
}

/// Each NAME.json of the folder says what is in NAME.colaa.bin and in NAME.colab.bin. How many there are.
int expectEqualToTheReferences(const std::filesystem::path& folder) {
    int variants = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".json") continue;
        const nlohmann::json expected = fileJson(entry.path())["scans"];
        for (const char* extension : {".colaa.bin", ".colab.bin"}) {
            const auto path = std::filesystem::path(entry.path()).replace_extension(extension);
            SCOPED_TRACE(path.filename().string());
            const auto frames = scanFramesOf(path);
            EXPECT_EQ(frames.size(), expected.size());
            for (std::size_t i = 0; i < std::min(frames.size(), expected.size()); ++i) {
                const auto telegram = decodeScanTelegram(frames[i]);
                EXPECT_TRUE(telegram) << told(telegram);
                if (!telegram) continue;
                EXPECT_EQ(telegramJson(*telegram, false), expected[i]);
            }
        }
        ++variants;
    }
    return variants;
}

TEST(ScanTelegramDecode, TheProjectsOwnTelegramsAreEqualToTheReferenceInBothDialects) {
    EXPECT_EQ(expectEqualToTheReferences(ownTelegrams()), 8);
}

TEST(ScanTelegramDecode, EveryDerivedVariantIsEqualToTheReferenceInBothDialects) {
    EDGESCAN_NEEDS_VECTORS();
    EXPECT_EQ(expectEqualToTheReferences(vectorsFolder() / "derived"), 15);
}

/// How many telegrams there are in the folder.
std::size_t expectTheSameBytesAgain(const std::filesystem::path& folder) {
    std::size_t telegrams = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".bin" || entry.path().parent_path().filename() == "torture") continue;
        SCOPED_TRACE(entry.path().filename().string());
        for (const ColaFrame& frame : scanFramesOf(entry.path())) {
            const auto telegram = decodeScanTelegram(frame);
            EXPECT_TRUE(telegram) << told(telegram);
            if (!telegram) continue;
            EXPECT_EQ(framed(encodeScanTelegram(*telegram, frame.dialect), frame.dialect), frame.bytes);
            const Dialect other = frame.dialect == Dialect::A ? Dialect::B : Dialect::A;
            const auto back = decodeScanTelegram(encodeScanTelegram(*telegram, other), other);
            EXPECT_TRUE(back && *back == *telegram) << told(back);
            ++telegrams;
        }
    }
    return telegrams;
}

TEST(ScanTelegramDecode, EncodingGivesTheSameBytesAgain) { EXPECT_EQ(expectTheSameBytesAgain(ownTelegrams()), 2 * 18U); }

TEST(ScanTelegramDecode, EncodingGivesTheSameBytesOfRealTelegramsAgain) {
    EDGESCAN_NEEDS_VECTORS();
    EXPECT_GE(expectTheSameBytesAgain(vectorsFolder()), 136U + 20U + 2 * 28U);
}

TEST(ScanTelegramDecode, CutAtEveryByteItIsAnErrorThatNamesTheByte) {
    for (const Dialect dialect : {Dialect::A, Dialect::B}) {
        const ScanTelegram telegram = fullTelegram();
        const Bytes whole = encodeScanTelegram(telegram, dialect);
        ASSERT_TRUE(*decodeScanTelegram(whole, dialect) == telegram);
        ScanTelegram without = telegram;
        without.event.reset();
        const std::size_t flag = encodeScanTelegram(without, dialect).size() - (dialect == Dialect::A ? 1 : 2);
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto cut = decodeScanTelegram(ByteView(whole).first(length), dialect);
            // Telegrams of old firmware have no event flag; a text truncated inside its last number is a shorter number: the framing
            // detects these.
            if (dialect == Dialect::B ? length == flag : length + 6 >= flag) continue;
            ASSERT_FALSE(cut) << length;
            EXPECT_NE(cut.error().sentence().find("byte "), std::string::npos);
            EXPECT_TRUE(cut.error().sentence().ends_with("."));
        }
    }
}

void expectCutNeverPassesForWhole(const std::filesystem::path& folder, const std::vector<const char*>& names) {
    for (const char* name : names) {
        for (const char* extension : {".colaa.bin", ".colab.bin"}) {
            const ColaFrame frame = scanFramesOf(folder / (std::string(name) + extension)).at(0);
            const auto whole = decodeScanTelegram(frame);
            ASSERT_TRUE(whole);
            for (std::size_t length = 0; length<frame.bytes.size(); length += frame.bytes.size()> 10000 ? 17 : 1) {
                ColaStream stream;
                EXPECT_TRUE(stream.push(ByteView(frame.bytes).first(length)).empty());
            }
            int passed = 0;
            for (std::size_t length = 0;
                 length<frame.payload().size(); length += frame.payload().size()> 10000 && length + 200 < frame.payload().size() ? 17 : 1) {
                if (decodeScanTelegram(frame.payload().first(length), frame.dialect)) ++passed;
            }
            // Truncated exactly before the event flag; of a text also in the last token before the flag (6 bytes) or at the end (8 digits).
            EXPECT_LE(passed, frame.dialect == Dialect::B ? 1 : 14) << name << extension;
        }
    }
}

TEST(ScanTelegramDecode, CutAnywhereNoTelegramPassesForWhole) {
    expectCutNeverPassesForWhole(ownTelegrams(), {"blocks", "echoes", "encoders", "bare"});
}

TEST(ScanTelegramDecode, RealTelegramsCutAnywhereNeverPassForWhole) {
    EDGESCAN_NEEDS_VECTORS();
    expectCutNeverPassesForWhole(vectorsFolder() / "derived", {"blocks", "echo5", "encoder3", "empty", "minimal"});
}

TEST(ScanTelegramDecode, FlippedBytesNeverCrash) {
    std::vector<ColaFrame> frames;
    for (const Dialect dialect : {Dialect::A, Dialect::B})
        frames.push_back({dialect, framed(encodeScanTelegram(fullTelegram(), dialect), dialect), {}, 0, 0});
    std::mt19937 random(11);
    int decoded = 0, refused = 0;
    for (const ColaFrame& frame : frames) {
        const Bytes payload(frame.payload().begin(), frame.payload().end());
        for (std::size_t at = 0; at < payload.size(); ++at) {
            for (const unsigned value : {0U, 0x20U, 0x2BU, 0x2DU, 0x46U, 0x7FU, 0xFFU, static_cast<unsigned>(random() & 0xFFU)}) {
                Bytes damaged = payload;
                damaged[at] = static_cast<std::uint8_t>(value);
                const auto telegram = decodeScanTelegram(damaged, frame.dialect);
                ++(telegram ? decoded : refused);
                if (!telegram) continue;
                for (const ScanChannel& channel : telegram->channels16) {
                    const LineRanges ranges = rangesMm(channel);
                    for (std::size_t beam = 0; beam < ranges.rangeMm.size(); ++beam)
                        ASSERT_TRUE(std::isfinite(ranges.rangeMm[beam]) && ranges.rangeMm[beam] >= 0.0F);
                    (void)beamAnglesDeg(beamGrid(channel));
                }
                (void)encodeScanTelegram(*telegram, frame.dialect);
            }
        }
    }
    EXPECT_GT(decoded, 0);
    EXPECT_GT(refused, 0);
}

TEST(ScanTelegramDecode, ToleratesWhatOthersSend) {
    ScanTelegram telegram = fullTelegram();
    telegram.event.reset();
    Bytes text = encodeScanTelegram(telegram, Dialect::A);
    text.resize(text.size() - 2); // " 0": no event flag
    EXPECT_TRUE(*decodeScanTelegram(text, Dialect::A) == telegram);
    Bytes binary = encodeScanTelegram(telegram, Dialect::B);
    binary.insert(binary.end(), {1, 2, 3});
    const auto trailing = decodeScanTelegram(binary, Dialect::B);
    ASSERT_TRUE(trailing);
    EXPECT_EQ(trailing->trailingBytes, 3U);
    // Signed decimals, lower-case letters and leading zeros are also numbers.
    const std::string words = "sSN LMDscandata 00 1 11458 0 0 +10 A 5 6 0 0 0 0 -500 9c4 21C 0 1 DIST1 3F800000 00000000 -50000 "
                              "+1667 3 10 +17 ff 0 0 0 0 0 0";
    const auto loose = decodeScanTelegram(Bytes(words.begin(), words.end()), Dialect::A);
    ASSERT_TRUE(loose) << told(loose);
    EXPECT_EQ(loose->telegramCounter, 10);
    EXPECT_EQ(loose->layer, -500);
    EXPECT_EQ(loose->channels16[0].startAngle, -50000);
    EXPECT_EQ(loose->channels16[0].values, (std::vector<std::uint16_t>{16, 17, 255}));
    for (const char* bad : {"sSN LMDscandata 10000", "sSN LMDscandata G", "sSN LMDscandata -1", "sSN LMDscandata +-1", "sSN LMDscandata  1",
                            "sSN LMDscandatacfg 1", "sFA 3", ""}) {
        EXPECT_FALSE(decodeScanTelegram(Bytes(bad, bad + std::strlen(bad)), Dialect::A)) << bad;
    }
}

TEST(ScanTelegramValues, RangesHonourScaleAndOffset) {
    const ScanChannel channel{"DIST1", 2.0F, 0.0F, 0, 1667, {0, 1, 15, 16, 65535}};
    const LineRanges ranges = rangesMm(channel);
    EXPECT_EQ(ranges.rangeMm, (std::vector<float>{0, 2, 30, 32, 131070}));
    EXPECT_EQ(ranges.state, (std::vector<CellState>{CellState::NoReturn, CellState::DeviceStatus, CellState::DeviceStatus, CellState::Valid,
                                                    CellState::Valid}));
    const LineRanges shifted = rangesMm({"DIST1", 1.0F, -20.0F, 0, 1667, {16, 100}});
    EXPECT_EQ(shifted.state, (std::vector<CellState>{CellState::NoReturn, CellState::Valid}));
    EXPECT_EQ(shifted.rangeMm[1], 80.0F);
}

TEST(ScanTelegramValues, AnglesLieOnTheGridOfTheMirror) {
    const auto grid = [](std::int32_t start, std::uint16_t step, std::size_t count) {
        return beamGrid({"DIST1", 1.0F, 0.0F, start, step, std::vector<std::uint16_t>(count)});
    };
    const auto plain = beamAnglesDeg(grid(-50000, 1667, 1141));
    EXPECT_EQ(plain.front(), -5.0);
    EXPECT_NEAR(plain.back(), 185.0, 1e-12);
    const auto odd = beamAnglesDeg(grid(-48333, 3333, 570));
    EXPECT_NEAR(odd.front(), -29.0 / 6.0, 1e-12);
    EXPECT_NEAR(odd.back(), -29.0 / 6.0 + 569.0 / 3.0, 1e-10);
    for (int k = 1; k <= 24; ++k) EXPECT_NEAR(snappedDeg(std::round(k / 24.0 * 1e4) / 1e4), k / 24.0, 1e-15);
    EXPECT_EQ(snappedDeg(0.1), 0.1);
    EXPECT_TRUE(grid(-50000, 1667, 3) == grid(-50000, 1667, 3));
    EXPECT_FALSE(grid(-50000, 3333, 571) == grid(-48333, 3333, 570));
}

TEST(ScanTelegramValues, StatusAndChannels) {
    ScanTelegram telegram;
    for (unsigned bits = 0; bits < 8; ++bits) {
        telegram.status[0] = static_cast<std::uint8_t>(bits);
        EXPECT_TRUE((deviceFlags(telegram) == DeviceFlags{(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0}));
    }
    EXPECT_EQ(findChannel(telegram, "DIST1"), nullptr);
    const ScanTelegram full = fullTelegram();
    EXPECT_EQ(findChannel(full, "RSSI1"), &full.channels8[0]);
}
