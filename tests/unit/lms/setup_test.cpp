// Configuring a scanner: only when asked, everything read back, nothing stored unless asked in so many words.
#include "tests/support/live_session.h"

using namespace edgescan;
using namespace edgescan::test;

TEST(ScannerSetup, ConfiguresOnlyWhenAskedAndReadsBack) {
    TelegramStyle style;
    style.remission = true;
    for (const Dialect dialect : {Dialect::A, Dialect::B}) {
        EmulatedScannerSettings settings;
        settings.only = dialect;
        settings.linesPerSecond = 200;
        const auto scanner = served(countingScan(20, 60), settings, style);
        auto session = settingsFor(*scanner);
        ScannerSetup setup;
        setup.scan = {5000, 1, 2500, 826250, 973750};
        setup.range = {1, 2500, 850000, 950000};
        setup.content.remission = false;
        setup.echoes = EchoFilter::First;
        setup.encoder = EncoderInput{};
        session.setup = setup;
        Listener listener;
        {
            const ScannerSession live(session, listener.events());
            EXPECT_TRUE(listener.waitForScans(3));
        }
        const auto telegrams = listener.telegrams();
        ASSERT_GE(telegrams.size(), 3U);
        EXPECT_EQ(telegrams[0].scanFrequency, 5000U);
        EXPECT_EQ(telegrams[0].channels16[0].startAngle, 851250); // the first beam inside
        EXPECT_EQ(telegrams[0].channels16[0].values.size(), 40U);
        EXPECT_TRUE(telegrams[0].channels8.empty());
        EXPECT_EQ(telegrams[0].encoders.size(), 1U);
        ASSERT_TRUE(telegrams[0].clock);
        for (const SetupStep& step : listener.steps()) EXPECT_FALSE(step.refused) << step.command << " -> " << step.answer;
        const auto commands = listener.sentCommands();
        EXPECT_EQ(std::count(commands.begin(), commands.end(), "sMN mEEwriteall"), 0);
        EXPECT_EQ(std::count(commands.begin(), commands.end(), "sWN EIHstCola"), 0);
        const auto sentFirst = [&](const char* name) { return std::find(commands.begin(), commands.end(), name) - commands.begin(); };
        EXPECT_LT(sentFirst("sMN SetAccessMode"), sentFirst("sWN LMPoutputRange"));
        EXPECT_LT(sentFirst("sWN LMPoutputRange"), sentFirst("sRN LMPoutputRange"));
        EXPECT_LT(sentFirst("sRN FREchoFilter"), sentFirst("sMN LMCstartmeas"));
        EXPECT_LT(sentFirst("sMN LMCstartmeas"), sentFirst("sMN Run"));
        EXPECT_GE(listener.steps().size(), 16U);
    }
}

TEST(ScannerSetup, StoresOnlyWhenAskedInSoManyWords) {
    EmulatedScannerSettings settings;
    const auto scanner = served(countingScan(5, 60), settings);
    auto session = settingsFor(*scanner);
    ScannerSetup setup;
    setup.scan.step = setup.range.step = 2500;
    setup.range.startAngle = 826250;
    setup.range.stopAngle = 973750;
    setup.content.encoder = 1;
    setup.storePermanently = true;
    session.setup = setup;
    Listener listener;
    {
        const ScannerSession live(session, listener.events());
        EXPECT_TRUE(listener.waitForPhase(SessionPhase::Live));
    }
    const auto commands = listener.sentCommands();
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "sMN mEEwriteall"), 1);
}

TEST(ScannerSetup, ARefusedSetupEndsWithASentenceAndTheScannerRunning) {
    EmulatedScannerSettings settings;
    const auto scanner = served(countingScan(5, 60), settings);
    auto session = settingsFor(*scanner);
    session.setup = ScannerSetup{}; // 1/6 degree, which this scanner cannot do
    session.setup->storePermanently = true;
    Listener listener;
    {
        const ScannerSession live(session, listener.events());
        EXPECT_TRUE(listener.waitForPhase(SessionPhase::Stopped));
        EXPECT_EQ(live.state().sentence.find("127.0.0.1:"), 0U);
        EXPECT_NE(live.state().sentence.find("the angle step is not possible; correct the settings"), std::string::npos)
            << live.state().sentence;
    }
    const auto commands = listener.sentCommands();
    EXPECT_EQ(commands.back(), "sRN SCdevicestate");
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "sMN Run"), 1);
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "sMN mEEwriteall"), 0);
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "sWN LMPoutputRange"), 0);
    const auto refused =
        std::count_if(listener.steps().begin(), listener.steps().end(), [](const SetupStep& step) { return step.refused; });
    EXPECT_EQ(refused, 1);
}
