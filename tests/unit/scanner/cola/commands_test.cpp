// Requests byte for byte as a real LMS511 received them, and its answers.
#include "core/scanner/cola/commands.h"
#include "tests/support/cola_vectors.h"

#include <gtest/gtest.h>

#include <random>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

Bytes fromHex(const std::string& hex) {
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}
std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

ColaRequest read(const char* name) { return {ColaRequest::Kind::Read, name}; }

ColaAnswer answered(const std::string& text) {
    const auto answer = parseAnswer(Bytes(text.begin(), text.end()), Dialect::A);
    EXPECT_TRUE(answer) << text;
    return answer ? *answer : ColaAnswer{};
}

} // namespace

TEST(ColaCommands, TheRealDialogueByteForByte) {
    EDGESCAN_NEEDS_VECTORS();
    const std::vector<ColaRequest> known{read("FirmwareVersion"), read("SCdevicestate"),  read("ODoprh"),
                                         read("LMPoutputRange"),  read("LMDscandatacfg"), {ColaRequest::Kind::Subscribe, "LMDscandata"}};
    std::ifstream file(vectorsFolder() / "lms511_a_dialogue.jsonl");
    std::vector<bool> seen(known.size(), false);
    std::optional<ColaRequest> asked; // empty: a request that would change the scanner
    int refused = 0, answeredCount = 0;
    for (std::string line; std::getline(file, line);) {
        const nlohmann::json entry = nlohmann::json::parse(line);
        const Bytes frame = fromHex(entry["hex"]);
        if (frame.size() != entry["len"]) continue; // long answers are truncated in the file
        ColaStream stream;
        const auto frames = stream.push(frame);
        ASSERT_EQ(frames.size(), 1U);
        if (entry["dir"] == "h2d") {
            const std::string words = entry["text"];
            const std::string name = words.substr(4, words.find_first_of(" ", 4) - 4);
            asked.reset();
            if (words.starts_with("sRN")) asked = {ColaRequest::Kind::Read, name};
            if (words.starts_with("sEN")) asked = {ColaRequest::Kind::Subscribe, name};
            for (std::size_t i = 0; i < known.size(); ++i) {
                if (framed(encodeRequest(known[i], Dialect::B), Dialect::B) == frame) seen[i] = true;
            }
            continue;
        }
        const auto answer = parseAnswer(frames[0].payload(), Dialect::B);
        ASSERT_TRUE(answer) << line;
        if (answer->kind == AnswerKind::Telegram) {
            EXPECT_FALSE(asked && answers(*answer, *asked));
            continue;
        }
        EXPECT_EQ(answer->kind == AnswerKind::Other, !asked) << line;
        if (asked) {
            EXPECT_TRUE(answers(*answer, *asked)) << line;
        }
        ++answeredCount;
        if (answer->kind == AnswerKind::Refused) {
            EXPECT_EQ(answer->refusal, 3);
            ++refused;
        }
        if (answer->name == "FirmwareVersion") {
            EXPECT_EQ(*parseText(*answer), "V1.80    ");
        }
        if (answer->name == "LocationName") {
            EXPECT_EQ(*parseText(*answer), "SN 18110550");
        }
        if (answer->name == "ODoprh") {
            EXPECT_EQ(*parseNumber32(*answer), 1085U);
        }
        if (answer->name == "SCdevicestate") {
            EXPECT_EQ(*parseNumber8(*answer), 0);
        }
        if (answer->name == "LMPoutputRange" && answer->kind == AnswerKind::Read) {
            EXPECT_TRUE(*parseOutputRange(*answer) == OutputRange{});
        }
        if (answer->name == "LMDscandatacfg" && answer->kind == AnswerKind::Read) {
            EXPECT_TRUE(*parseTelegramContent(*answer) == TelegramContent{});
        }
    }
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_TRUE(seen[i]) << requestText(known[i]);
    EXPECT_EQ(refused, 18);
    EXPECT_GE(answeredCount, 60);
}

TEST(ColaCommands, RequestsInBothDialects) {
    const auto text = [](const ColaRequest& request) { return textOf(encodeRequest(request, Dialect::A)); };
    EXPECT_EQ(text(read("SCdevicestate")), "sRN SCdevicestate");
    EXPECT_EQ(text({ColaRequest::Kind::Subscribe, "LMDscandata"}), "sEN LMDscandata 1");
    EXPECT_EQ(requestText({ColaRequest::Kind::Subscribe, "LMDscandata"}), "sEN LMDscandata 1");
    EXPECT_EQ(encodeRequest(read("ODoprh"), Dialect::B).back(), 'h'); // a name at the end is not followed by a blank
}

TEST(ColaCommands, AnswersInText) {
    const auto state = parseMeasuringState(answered("sRA STlms 7 0 8 16:21:48 A 28.06.2023 0 0 0"));
    ASSERT_TRUE(state);
    EXPECT_EQ(state->state, 7);
    EXPECT_EQ(state->time, "16:21:48");
    EXPECT_EQ(state->date, "28.06.2023");
    const auto identity = parseDeviceIdentity(answered("sRA DeviceIdent 10 LMS10x_FieldEval 10 V1.36-21.10.2010"));
    ASSERT_TRUE(identity);
    EXPECT_EQ(identity->name, "LMS10x_FieldEval");
    EXPECT_EQ(identity->version, "V1.36-21.10.2010");
    EXPECT_EQ(*parseText(answered("sRA LocationName B SN 18110550")), "SN 18110550");
    EXPECT_EQ(*parseText(answered("sRA LocationName 0 ")), "");
    EXPECT_FALSE(parseText(answered("sRA LocationName 20 short")));
    EXPECT_FALSE(parseScanConfiguration(answered("sRA LMPscancfg 9C4 1")));
    EXPECT_EQ(parseScanConfiguration(answered("sRA LMPscancfg 9C4 1")).error().sentence(),
              "the scanner's answer to LMPscancfg: the angle step is cut off.");
}

TEST(ColaCommands, RefusalsHaveWords) {
    const ColaAnswer text = answered("sFA A");
    EXPECT_EQ(text.refusal, 10);
    const auto binary = parseAnswer(fromHex("7346410003"), Dialect::B);
    ASSERT_TRUE(binary);
    EXPECT_EQ(binary->refusal, 3);
    EXPECT_STREQ(refusalText(binary->refusal), "the variable is not known");
    EXPECT_TRUE(answers(*binary, read("field030")));
    EXPECT_FALSE(parseText(*binary));
    for (int code = -1; code < 300; ++code) EXPECT_GT(std::string(refusalText(code)).size(), 5U);
    for (const char* bad : {"sFA", "sFA x", "sXX name", "sRA", "", "hello"}) {
        EXPECT_FALSE(parseAnswer(Bytes(bad, bad + std::string(bad).size()), Dialect::A)) << bad;
    }
    EXPECT_FALSE(parseAnswer(fromHex("73464100"), Dialect::B));
}

TEST(ColaCommands, OnlyTheRightAnswerAnswers) {
    const ColaRequest request = read("LMDscandata");
    EXPECT_FALSE(answers(answered("sSN LMDscandata 0"), request));
    EXPECT_TRUE(answers(answered("sRA LMDscandata 0"), request));
    EXPECT_FALSE(answers(answered("sRA LMDscandatacfg 0"), request)); // one name is the beginning of the other
    EXPECT_FALSE(answers(answered("sWA LMDscandata"), request));
    EXPECT_FALSE(answers(answered("sEA LMDscandata 1"), request));
    EXPECT_TRUE(answers(answered("sEA LMDscandata 1"), {ColaRequest::Kind::Subscribe, "LMDscandata"}));
}

TEST(ColaCommands, DamagedAnswersAreTakenOrRefusedWithASentence) {
    constexpr unsigned kSeed = 3;
    SCOPED_TRACE(kSeed);
    std::mt19937 random(kSeed);
    int taken = 0, refused = 0;
    const auto count = [&](const auto& read) {
        ++(read ? taken : refused);
        EXPECT_TRUE(read || !read.error().what.empty());
    };
    for (const char* text : {"sRA LMPscancfg 9C4 1 683 FFFF3CB0 1C3A90", "sRA STlms 7 0 8 16:21:48 A 28.06.2023 0 0 0", "sFA 3",
                             "sRA DeviceIdent 10 LMS10x_FieldEval 10 V1.36-21.10.2010", "sRA LMDscandatacfg 1 0 1 0 0 0 0 0 0 0 1 1"}) {
        for (int round = 0; round < 2000; ++round) {
            Bytes bytes(text, text + std::string(text).size());
            bytes.resize(random() % (bytes.size() + 1));
            if (!bytes.empty()) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
            for (const Dialect dialect : {Dialect::A, Dialect::B}) {
                const auto answer = parseAnswer(bytes, dialect);
                if (!answer) continue;
                count(parseNumber8(*answer));
                count(parseNumber32(*answer));
                count(parseScanConfiguration(*answer));
                count(parseOutputRange(*answer));
                count(parseTelegramContent(*answer));
                count(parseDeviceIdentity(*answer));
                count(parseMeasuringState(*answer));
                const auto words = parseText(*answer);
                count(words);
                EXPECT_TRUE(!words || words->size() <= bytes.size()); // nothing that was not sent
            }
        }
    }
    EXPECT_GT(taken, 0);
    EXPECT_GT(refused, 0);
}
