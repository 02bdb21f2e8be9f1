// The scanner session with the emulated scanner, with every fault that it can produce.
#include "tests/support/beam_angles.h"
#include "tests/support/live_session.h"

#include <boost/asio.hpp>

#include <set>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

std::uint16_t freePort() {
    boost::asio::io_context context;
    const boost::asio::ip::tcp::acceptor acceptor(context, {boost::asio::ip::address_v4::loopback(), 0});
    return acceptor.local_endpoint().port();
}

/// Runs a session until the last of `lines` has come: the scanners of these tests never leave that one out.
void receiveAll(EmulatedScanner& scanner, Listener& listener, const ConnectionSettings& settings, std::size_t lines,
                ConnectionStatistics* statistics = nullptr) {
    ScannerConnection session(settings, listener.events());
    const auto last = [&](const Listener&) {
        const auto telegrams = listener.telegrams();
        return !telegrams.empty() && telegrams.back().encoders.at(0).position + 1 == lines;
    };
    EXPECT_TRUE(listener.waitFor(last));
    EXPECT_TRUE(waitUntil([&] { return scanner.statistics().finished; }));
    if (statistics != nullptr) *statistics = session.statistics();
    session.stop();
}

} // namespace

TEST(ScannerConnection, FindsTheDialectAndReceivesEveryLine) {
    const Scan scan = countingScan(40, 60);
    for (const auto only : {std::optional<Dialect>(), std::optional(Dialect::A), std::optional(Dialect::B)}) {
        EmulatedScannerSettings settings;
        settings.only = only;
        settings.linesPerSecond = 0;
        settings.atEnd = AtEnd::Stop;
        const auto scanner = served(scan, settings);
        Listener listener;
        receiveAll(*scanner, listener, settingsFor(*scanner), 40);
        EXPECT_EQ(listener.story(), "CONNECTING IDENTIFYING LIVE STOPPED");
        ASSERT_EQ(listener.identities().size(), 1U);
        const ScannerIdentity& who = listener.identities()[0];
        EXPECT_EQ(who.dialect, only.value_or(Dialect::B));
        EXPECT_EQ(who.firmware, "V1.80    ");
        EXPECT_EQ(who.location, "SN 18110550");
        EXPECT_EQ(who.deviceState, 1);
        EXPECT_TRUE(who.refused.empty());
        EXPECT_NE(who.words().find("LMS511 emulated"), std::string::npos) << who.words();
        EXPECT_NE(who.words().find("25 Hz"), std::string::npos) << who.words();
        const auto telegrams = listener.telegrams();
        ASSERT_EQ(telegrams.size(), 40U);
        for (std::size_t line = 0; line < telegrams.size(); ++line) {
            EXPECT_EQ(telegrams[line].encoders.at(0).position, line);
            const LineRanges ranges = rangesMm(telegrams[line].channels16.at(0));
            const std::size_t first = line * 60;
            EXPECT_TRUE(std::equal(ranges.rangeMm.begin(), ranges.rangeMm.end(), scan.rangeMm.cells.begin() + static_cast<long>(first)));
            EXPECT_TRUE(std::equal(ranges.state.begin(), ranges.state.end(), scan.state.cells.begin() + static_cast<long>(first)));
            const auto angles = beamAnglesDeg(beamGrid(telegrams[line].channels16[0]));
            for (std::size_t beam = 0; beam < angles.size(); ++beam)
                EXPECT_NEAR(angles[beam], std::get<PolarGeometry>(scan.geometry).beamDeg[beam], 1e-9);
        }
    }
}

TEST(ScannerConnection, SendsNothingButReadsAndSubscriptions) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 500;
    settings.faults.dropEvery = 20;
    const auto scanner = served(countingScan(30, 20), settings);
    Listener listener;
    {
        ScannerConnection session(settingsFor(*scanner), listener.events());
        EXPECT_TRUE(listener.waitFor([](const Listener& l) { return l.entered(ConnectionPhase::Live) >= 3; }));
    }
    EXPECT_EQ(scanner->statistics().writes, 0U);
    const auto commands = listener.sentCommands();
    EXPECT_GE(commands.size(), 20U);
    for (const std::string& command : commands) EXPECT_TRUE(command.starts_with("sRN ") || command == "sEN LMDscandata") << command;
}

TEST(ScannerConnection, HoweverTheBytesComeTheLinesAreTheSame) {
    const Scan scan = countingScan(200, 40);
    for (const Dialect dialect : {Dialect::A, Dialect::B}) {
        EmulatedScannerSettings settings;
        settings.only = dialect;
        settings.linesPerSecond = 0;
        settings.atEnd = AtEnd::Stop;
        settings.faults.splitSends = true;
        settings.faults.mergeSends = true;
        settings.faults.garbageEvery = 3;
        const auto scanner = served(scan, settings);
        Listener listener;
        ConnectionStatistics statistics;
        receiveAll(*scanner, listener, settingsFor(*scanner), 200, &statistics);
        const Account account = accountOf(listener.telegrams());
        EXPECT_EQ(account.received, 200);
        EXPECT_EQ(account.lost, 0);
        EXPECT_GT(statistics.stream.skipped, 0U);
        EXPECT_EQ(statistics.scans, 200U);
        EXPECT_EQ(statistics.reconnects, 0U);
    }
}

TEST(ScannerConnection, EveryLostLineIsCounted) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 0;
    settings.atEnd = AtEnd::Stop;
    settings.faults.loseEvery = 10;
    settings.faults.loseBurst = 3;
    settings.faults.duplicateEvery = 7;
    const auto scanner = served(countingScan(306, 20), settings);
    Listener listener;
    receiveAll(*scanner, listener, settingsFor(*scanner), 306);
    const auto statistics = scanner->statistics();
    const Account account = accountOf(listener.telegrams());
    EXPECT_EQ(account.lost, 90);
    EXPECT_EQ(static_cast<std::uint64_t>(account.lost), statistics.lost);
    EXPECT_EQ(static_cast<std::uint64_t>(account.duplicates), statistics.duplicated);
    EXPECT_EQ(account.received + account.lost, 306);
}

TEST(ScannerConnection, ADroppedConnectionIsMadeAgain) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 400;
    settings.atEnd = AtEnd::Stop;
    settings.faults.dropEvery = 25;
    const auto scanner = served(countingScan(101, 20), settings);
    Listener listener;
    ConnectionStatistics statistics;
    receiveAll(*scanner, listener, settingsFor(*scanner), 101, &statistics);
    EXPECT_EQ(statistics.reconnects, 4U);
    EXPECT_EQ(scanner->statistics().clients, 5U);
    EXPECT_EQ(listener.entered(ConnectionPhase::Lost), 4);
    const Account account = accountOf(listener.telegrams());
    EXPECT_EQ(account.restarts, 0);
    EXPECT_EQ(account.received + account.lost, 101); // the connection may end within a telegram
    for (const ConnectionState& state : listener.states()) EXPECT_TRUE(state.sentence.ends_with(".")) << state.sentence;
}

TEST(ScannerConnection, LinesThatPassWhileReconnectingAreLostAndCounted) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 200;
    settings.keepTurning = true;
    const auto scanner = served(countingScan(150, 20), settings);
    Listener listener;
    auto settingsOfSession = settingsFor(*scanner);
    settingsOfSession.timeouts.rests = {150ms};
    {
        const ScannerConnection session(settingsOfSession, listener.events());
        EXPECT_TRUE(listener.waitForScans(20));
        scanner->dropConnections();
        EXPECT_TRUE(listener.waitFor([](const Listener& l) { return l.entered(ConnectionPhase::Live) >= 2; }));
    }
    const Account account = accountOf(listener.telegrams());
    EXPECT_GE(account.lost, 20);
    EXPECT_EQ(account.received + account.lost, account.span);
}

TEST(ScannerConnection, SilenceIsStaleThenLostThenLiveAgain) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 200;
    settings.faults.stallEvery = 40;
    settings.faults.stallS = 0.9;
    const auto scanner = served(countingScan(30, 20), settings);
    Listener listener;
    {
        ScannerConnection session(settingsFor(*scanner, hasty()), listener.events());
        // On a busy machine other things may come before that.
        const char* const wanted = "LIVE STALE LOST CONNECTING IDENTIFYING LIVE";
        EXPECT_TRUE(listener.waitFor([&](const Listener& l) { return l.story().find(wanted) != std::string::npos; }));
    }
    // Watchdog: ten periods of 40 ms, never sooner.
    const auto& states = listener.states();
    for (std::size_t n = 1; n < states.size(); ++n) {
        if (states[n - 1].phase != ConnectionPhase::Stale || states[n].phase != ConnectionPhase::Lost) continue;
        EXPECT_GT(states[n].since.monotonicNs - states[n - 1].since.monotonicNs, 150'000'000);
    }
}

// Until it looks again, more time passes than that after which a silent scanner counts as lost; the lines wait in the socket meanwhile.
TEST(ScannerConnection, AComputerThatWasBusyForLongerThanTheTimeoutReadsWhatCameMeanwhile) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 200;
    const auto scanner = served(countingScan(30, 20), settings);
    Listener listener;
    ConnectionEvents events = listener.events();
    const auto record = events.stateChanged;
    events.stateChanged = [&](const ConnectionState& state) {
        record(state);
        if (state.phase != ConnectionPhase::Live) return;
        const std::uint64_t sent = scanner->statistics().sent;
        EXPECT_TRUE(waitUntil([&] { return scanner->statistics().sent >= sent + 300; })); // 1.5 s; the timeout is ten periods: 0.4 s
    };
    ScannerTimeouts shortSilence = patient();
    shortSilence.silence = 100ms;
    {
        const ScannerConnection session(settingsFor(*scanner, shortSilence), events);
        EXPECT_TRUE(listener.waitFor([](const Listener& l) { return l.entered(ConnectionPhase::Live) > 0; }));
        EXPECT_TRUE(listener.waitForScans(300));
    }
    EXPECT_EQ(listener.entered(ConnectionPhase::Lost), 0) << listener.story();
    EXPECT_EQ(accountOf(listener.telegrams()).lost, 0);
}

TEST(ScannerConnection, AShortSilenceIsStaleOnly) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 200;
    settings.faults.stallEvery = 40;
    settings.faults.stallS = 4.2;
    const auto scanner = served(countingScan(30, 20), settings);
    Listener listener;
    ConnectionSettings staleInAStall = settingsFor(*scanner);
    staleInAStall.timeouts.silence = 6s; // stale after half of it, lost after the whole
    {
        ScannerConnection session(staleInAStall, listener.events());
        EXPECT_TRUE(listener.waitFor([](const Listener& l) { return l.entered(ConnectionPhase::Live) >= 2; }));
    }
    EXPECT_TRUE(listener.story().starts_with("CONNECTING IDENTIFYING LIVE STALE LIVE")) << listener.story();
    EXPECT_EQ(listener.entered(ConnectionPhase::Lost), 0);
}

TEST(ScannerConnection, StopsAtOnceWhateverItWaitsFor) {
    EmulatedScannerSettings mute;
    mute.faults.mute = true;
    const auto silent = served(countingScan(5, 5), mute);
    EmulatedScannerSettings plain;
    const auto sending = served(countingScan(5, 5), plain);
    // It does not wait for any of these, or this test would not end.
    ScannerTimeouts endless;
    endless.connect = endless.detect = endless.answer = endless.firstScan = endless.silence = 1h;
    endless.rests = {1h};
    const auto detecting = settingsFor(*silent, endless);
    const auto live = settingsFor(*sending, endless);
    auto backingOff = settingsFor(*sending, endless);
    backingOff.port = freePort();
    for (const auto& [settings, phase] : {std::pair(detecting, ConnectionPhase::Identifying), std::pair(live, ConnectionPhase::Live),
                                          std::pair(backingOff, ConnectionPhase::Lost)}) {
        Listener listener;
        ScannerConnection session(settings, listener.events());
        ASSERT_TRUE(listener.waitForPhase(phase));
        session.stop();
        EXPECT_EQ(session.state().phase, ConnectionPhase::Stopped);
        EXPECT_EQ(listener.states().back().phase, ConnectionPhase::Stopped);
    }
}

TEST(ScannerConnection, MayBeStoppedFromWithinAnEvent) {
    const auto scanner = served(countingScan(5, 5), {});
    Listener listener;
    ConnectionEvents events = listener.events();
    std::atomic<ScannerConnection*> self{nullptr};
    const auto record = events.frameReceived;
    events.frameReceived = [&](const ColaFrame& frame) {
        record(frame);
        if (self != nullptr && isScanTelegram(frame.payload())) self.load()->stop();
    };
    ScannerConnection session(settingsFor(*scanner), events);
    self = &session;
    EXPECT_TRUE(listener.waitForPhase(ConnectionPhase::Stopped));
}

TEST(ScannerConnection, SaysWhatIsWrongWhereAndWhatToDo) {
    EmulatedScannerSettings mute;
    mute.faults.mute = true;
    const auto silent = served(countingScan(5, 5), mute);
    EmulatedScannerSettings refusing;
    refusing.refusals["LMDscandata"] = 15;
    const auto stubborn = served(countingScan(5, 5), refusing);
    const auto lostSentence = [](ConnectionSettings settings) {
        Listener listener;
        ScannerConnection session(settings, listener.events());
        EXPECT_TRUE(listener.waitForPhase(ConnectionPhase::Lost));
        session.stop();
        for (const ConnectionState& state : listener.states()) {
            if (state.phase == ConnectionPhase::Lost) return state.sentence;
        }
        return std::string();
    };
    auto settings = settingsFor(*silent, hasty());
    std::string sentence = lostSentence(settings);
    EXPECT_EQ(sentence.find("127.0.0.1:" + std::to_string(silent->port()) + ": something accepts the connection but does not answer"), 0U)
        << sentence;
    settings = settingsFor(*stubborn, hasty());
    EXPECT_NE(lostSentence(settings).find("refuses to send scans: the event is not known"), std::string::npos);
    settings.port = freePort();
    sentence = lostSentence(settings);
    EXPECT_EQ(sentence.find("127.0.0.1:" + std::to_string(settings.port) + ": the connection is refused; check the port"), 0U) << sentence;
    EXPECT_NE(sentence.find("Trying again in"), std::string::npos);
    settings.host = "no-such-scanner.invalid";
    sentence = lostSentence(settings);
    EXPECT_EQ(sentence.find("no-such-scanner.invalid:"), 0U) << sentence;
    EXPECT_NE(sentence.find("IP address"), std::string::npos) << sentence;
    settings.host = "";
    EXPECT_NE(lostSentence(settings).find("no scanner is given"), std::string::npos);
}

TEST(ScannerConnection, HostNamesAndIpv6) {
    for (const auto& [serve, host] : {std::pair("127.0.0.1", "localhost"), std::pair("::1", "::1"), std::pair("::1", "[::1]")}) {
        EmulatedScannerSettings settings;
        settings.address = serve;
        auto telegrams = telegramsOf(countingScan(5, 5));
        const auto scanner = serveTelegrams(std::make_shared<const std::vector<ScanTelegram>>(*telegrams), settings);
        if (!scanner && std::string(serve) == "::1") GTEST_SKIP() << scanner.error().sentence();
        ASSERT_TRUE(scanner);
        auto session = settingsFor(**scanner);
        session.host = host;
        Listener listener;
        const ScannerConnection live(session, listener.events());
        EXPECT_TRUE(listener.waitForPhase(ConnectionPhase::Live)) << host;
    }
}

TEST(ScannerConnection, TwentyMinutesOfFaultsAsFastAsPossible) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 0;
    settings.only = Dialect::B; // text has no checksum: a flipped bit in it looks like a measurement
    settings.faults = {.splitSends = true,
                       .mergeSends = true,
                       .loseEvery = 50,
                       .loseBurst = 4,
                       .duplicateEvery = 40,
                       .garbageEvery = 20,
                       .corruptEvery = 100,
                       .stallEvery = 0,
                       .stallS = 0,
                       .dropEvery = 1500,
                       .mute = false,
                       .byChance = true,
                       .seed = 9};
    const auto scanner = served(countingScan(1000, 30), settings);
    auto session = settingsFor(*scanner, hasty());
    session.timeouts.rests = {1ms};
    Listener listener;
    ConnectionStatistics statistics;
    {
        ScannerConnection live(session, listener.events());
        EXPECT_TRUE(listener.waitForScans(30000));
        live.stop();
        statistics = live.statistics();
    }
    const Account account = accountOf(listener.telegrams());
    EXPECT_EQ(account.restarts, 0);
    EXPECT_EQ(account.received + account.lost, account.span);
    EXPECT_GE(account.received, 25000);
    EXPECT_LE(account.received + account.lost, static_cast<std::int64_t>(scanner->statistics().lines));
    EXPECT_GE(statistics.reconnects, 5U);
    EXPECT_GE(statistics.stream.badChecksum, 100U);
}
