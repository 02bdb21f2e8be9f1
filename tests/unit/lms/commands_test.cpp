// Requests byte for byte as a real LMS511 took them, and its answers.
#include "core/lms/cola_commands.h"
#include "tests/support/cola_vectors.h"

#include <gtest/gtest.h>

#include <random>

using namespace edgescan;
using namespace edgescan::test;

namespace {

Bytes fromHex(const std::string& hex) {
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}
std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

ColaAnswer answered(const std::string& text) {
    const auto answer = parseAnswer(Bytes(text.begin(), text.end()), Dialect::A);
    EXPECT_TRUE(answer) << text;
    return answer ? *answer : ColaAnswer{};
}

} // namespace

TEST(ColaCommands, TheRealDialogueByteForByte) {
    EDGESCAN_NEEDS_VECTORS();
    const std::vector<ColaRequest> known{logInRequest(),
                                         {"sWN", "EIHstCola", {std::uint8_t{1}}},
                                         readRequest("FirmwareVersion"),
                                         readRequest("SCdevicestate"),
                                         readRequest("ODoprh"),
                                         readRequest("LMPoutputRange"),
                                         readRequest("LMDscandatacfg"),
                                         outputRangeRequest({}),
                                         telegramContentRequest({}),
                                         {"sMN", "LMCstartmeas", {}},
                                         {"sMN", "Run", {}},
                                         subscribeRequest("LMDscandata", true)};
    std::ifstream file(vectorsFolder() / "lms511_a_dialogue.jsonl");
    std::vector<bool> seen(known.size(), false);
    ColaRequest asked;
    int refused = 0, answeredCount = 0;
    for (std::string line; std::getline(file, line);) {
        const nlohmann::json entry = nlohmann::json::parse(line);
        const Bytes frame = fromHex(entry["hex"]);
        if (frame.size() != entry["len"]) continue; // long answers are cut in the file
        ColaStream stream;
        const auto frames = stream.push(frame);
        ASSERT_EQ(frames.size(), 1U);
        if (entry["dir"] == "h2d") {
            const std::string words = entry["text"];
            asked = {words.substr(0, 3), words.substr(4, words.find_first_of(" ", 4) - 4), {}};
            for (std::size_t i = 0; i < known.size(); ++i) {
                if (framed(encodeRequest(known[i], Dialect::B), Dialect::B) == frame) seen[i] = true;
            }
            continue;
        }
        const auto answer = parseAnswer(frames[0].payload(), Dialect::B);
        ASSERT_TRUE(answer) << line;
        if (answer->kind == AnswerKind::Telegram) {
            EXPECT_FALSE(answers(*answer, asked));
            continue;
        }
        EXPECT_TRUE(answers(*answer, asked)) << line;
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
        if (answer->name == "Run") {
            EXPECT_EQ(*parseNumber8(*answer), 1);
        }
    }
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_TRUE(seen[i]) << requestText(known[i]);
    EXPECT_EQ(refused, 18);
    EXPECT_GE(answeredCount, 60);
}

TEST(ColaCommands, RequestsInBothDialects) {
    const auto text = [](const ColaRequest& request) { return textOf(encodeRequest(request, Dialect::A)); };
    EXPECT_EQ(text(logInRequest()), "sMN SetAccessMode 3 F4724744");
    EXPECT_EQ(text(scanConfigurationRequest({})), "sMN mLMPsetscancfg 9C4 1 683 FFFF3CB0 1C3A90");
    EXPECT_EQ(text(outputRangeRequest({})), "sWN LMPoutputRange 1 683 FFFF3CB0 1C3A90");
    EXPECT_EQ(text(telegramContentRequest({})), "sWN LMDscandatacfg 1 0 1 0 0 0 0 0 0 0 1 1");
    EXPECT_EQ(text(echoFilterRequest(EchoFilter::Last)), "sWN FREchoFilter 2");
    EXPECT_EQ(text({"sWN", "LICencres", {1.0F}}), "sWN LICencres 3F800000");
    EXPECT_EQ(text(readRequest("SCdevicestate")), "sRN SCdevicestate");
    EXPECT_EQ(requestText(scanConfigurationRequest({})), "sMN mLMPsetscancfg 2500 1 1667 -50000 1850000");
    const Bytes range = encodeRequest(outputRangeRequest({}), Dialect::B);
    EXPECT_EQ(Bytes(range.end() - 14, range.end()), fromHex("000100000683ffff3cb0001c3a90"));
    EXPECT_EQ(encodeRequest(readRequest("ODoprh"), Dialect::B).back(), 'h'); // no blank behind a bare name
    EXPECT_TRUE(subscribeRequest("LMDscandata", true).readsOnly());
    EXPECT_FALSE(logInRequest().readsOnly());
    EXPECT_FALSE(outputRangeRequest({}).readsOnly());
}

TEST(ColaCommands, AnswersInText) {
    const auto taken = parseScanConfigurationTaken(answered("sAN mLMPsetscancfg 0 9C4 1 683 FFFF3CB0 1C3A90"));
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->status, 0);
    EXPECT_TRUE(taken->configuration == ScanConfiguration{});
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
    EXPECT_EQ(answerText(*binary), "sFA 3 (the variable is not known)");
    EXPECT_TRUE(answers(*binary, readRequest("field030")));
    EXPECT_FALSE(parseText(*binary));
    for (int code = -1; code < 300; ++code) EXPECT_GT(std::string(refusalText(code)).size(), 5U);
    for (const char* bad : {"sFA", "sFA x", "sXX name", "sRA", "", "hello"}) {
        EXPECT_FALSE(parseAnswer(Bytes(bad, bad + std::string(bad).size()), Dialect::A)) << bad;
    }
    EXPECT_FALSE(parseAnswer(fromHex("73464100"), Dialect::B));
}

TEST(ColaCommands, OnlyTheRightAnswerAnswers) {
    const ColaRequest read = readRequest("LMDscandata");
    EXPECT_FALSE(answers(answered("sSN LMDscandata 0"), read));
    EXPECT_TRUE(answers(answered("sRA LMDscandata 0"), read));
    EXPECT_FALSE(answers(answered("sRA LMDscandatacfg 0"), read)); // one name is the start of the other
    EXPECT_FALSE(answers(answered("sWA LMDscandata"), read));
    EXPECT_FALSE(answers(answered("sMA Run"), {"sMN", "Run", {}}));
    EXPECT_TRUE(answers(answered("sAN Run 1"), {"sMN", "Run", {}}));
}

TEST(ColaCommands, DamagedAnswersNeverCrash) {
    std::mt19937 random(3);
    for (const char* text : {"sRA LMPscancfg 9C4 1 683 FFFF3CB0 1C3A90", "sRA STlms 7 0 8 16:21:48 A 28.06.2023 0 0 0", "sFA 3",
                             "sRA DeviceIdent 10 LMS10x_FieldEval 10 V1.36-21.10.2010", "sRA LMDscandatacfg 1 0 1 0 0 0 0 0 0 0 1 1"}) {
        for (int round = 0; round < 2000; ++round) {
            Bytes bytes(text, text + std::string(text).size());
            bytes.resize(random() % (bytes.size() + 1));
            if (!bytes.empty()) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
            for (const Dialect dialect : {Dialect::A, Dialect::B}) {
                const auto answer = parseAnswer(bytes, dialect);
                if (!answer) continue;
                (void)parseNumber8(*answer);
                (void)parseText(*answer);
                (void)parseScanConfiguration(*answer);
                (void)parseTelegramContent(*answer);
                (void)parseDeviceIdentity(*answer);
                (void)parseMeasuringState(*answer);
                (void)parseScanConfigurationTaken(*answer);
                EXPECT_FALSE(answerText(*answer).empty());
            }
        }
    }
}
