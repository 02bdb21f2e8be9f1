// The emulated scanner: telegrams from a scan, and the independent Python codec's reading of them.
#include "app/lab/emulator/sent_sweep.h"
#include "tests/support/live_session.h"
#include "tests/support/point_lists.h"
#include "tests/support/python_peer.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

/// A client that shares no code with the program: tries to change settings, reads, polls, subscribes.
constexpr const char* kPythonClient = R"(
import json, socket, struct, sys, zlib
sys.path.insert(0, sys.argv[1])
import cola
mode, port, out = sys.argv[2], int(sys.argv[3]), sys.argv[4]
s = socket.create_connection(('127.0.0.1', port), 5)
s.settimeout(5)
d, waiting = cola.Deframer(mode), []
def put(p): s.sendall(cola.frame_a(p) if mode == 'A' else cola.frame_b(p))
def get():
    while not waiting: waiting.extend(p for _, _, p in d.feed(s.recv(65536)))
    return waiting.pop(0)
def ask(a, b):
    put(a.encode() if mode == 'A' else b)
    return get()
log = []
def note(p): log.append(p.decode('latin1') if mode == 'A' else p.hex())
note(ask('sWN LMPoutputRange 1 1388 C9B28 EDCE8', b'sWN LMPoutputRange ' + bytes.fromhex('000100001388000c9b28000edce8')))
note(ask('sMN SetAccessMode 03 F4724744', b'sMN SetAccessMode ' + bytes.fromhex('03f4724744')))
note(ask('sRN LMDscandatacfg', b'sRN LMDscandatacfg'))
note(ask('sRN nonsense', b'sRN nonsense'))
note(ask('sMN nonsense', b'sMN nonsense'))
note(ask('sEN nonsense 1', b'sEN nonsense \x01'))
polled = cola.decode(ask('sRN LMDscandata', b'sRN LMDscandata'), mode)
note(ask('sEN LMDscandata 1', b'sEN LMDscandata \x01'))
scans = [polled] + [cola.decode(get(), mode) for _ in range(int(sys.argv[5]))]
for t in scans:
    for c in t['ch16'] + t['ch8']: c['angles'] = [cola.beam_angles_deg(c)[0], cola.beam_angles_deg(c)[-1]] if c['data'] else []
json.dump({'log': log, 'scans': scans, 'skipped': d.skipped, 'bad': d.bad_checksum}, open(out, 'w'))
)";

} // namespace

TEST(EmulatedTelegram, CarriesTheScan) {
    Scan scan = test::makeScan(3, 8, [](int i, int j) { return 5000 + 100 * i + j; });
    scan.rangeMm.at(1, 0) = 70001.0F; // beyond 16 bits: all in steps of 2 mm
    scan.state.at(1, 1) = CellState::NoReturn;
    scan.rangeMm.at(1, 2) = 3.0F;
    scan.state.at(1, 2) = CellState::DeviceStatus;
    scan.rangeMm.at(1, 3) = 20.0F; // nearer than 16 counts
    const auto telegrams = telegramsOf(scan, {});
    ASSERT_TRUE(telegrams);
    ASSERT_EQ(telegrams->size(), 3U);
    const ScanTelegram* const telegram = &(*telegrams)[1];
    const ScanChannel& dist = telegram->channels16.at(0);
    EXPECT_EQ(dist.scale, 2.0F);
    EXPECT_EQ(dist.values, (std::vector<std::uint16_t>{35001, 0, 3, 0, 2552, 2553, 2553, 2554}));
    EXPECT_EQ(dist.step, 2500);
    EXPECT_EQ(telegram->encoders.at(0).position, 1U);
    EXPECT_EQ(telegram->sinceStartUs - (*telegrams)[0].sinceStartUs, 40000U);
    EXPECT_TRUE(telegram->channels8.empty());
    for (CellState* cell = scan.state.line(1); cell != scan.state.line(2); ++cell) *cell = CellState::Lost;
    const auto all = telegramsOf(scan, {});
    ASSERT_TRUE(all);
    ASSERT_EQ(all->size(), 2U);
    EXPECT_EQ((*all)[1].telegramCounter, (*all)[0].telegramCounter + 2);
    auto& beams = std::get<PolarGeometry>(scan.geometry).beamDeg;
    beams[4] += 0.1;
    EXPECT_NE(telegramsOf(scan, {}).error().sentence().find("unevenly"), std::string::npos);
    std::reverse(beams.begin(), beams.end());
    beams[3] -= 0.1;
    EXPECT_FALSE(telegramsOf(scan, {}));
    scan.geometry = PointGeometry{};
    EXPECT_FALSE(telegramsOf(scan, {}));
}

TEST(EmulatedScanner, SatisfiesThePythonCodec) {
    EDGESCAN_NEEDS_PYTHON();
    const Scan scan = countingScan(50, 60);
    for (const char* mode : {"A", "B"}) {
        SCOPED_TRACE(mode);
        EmulatedScannerSettings settings;
        settings.linesPerSecond = 0;
        settings.contaminationWarning = true;
        settings.faults.splitSends = true;
        const auto scanner = served(scan, settings, {.remission = true});
        const Folder folder;
        writeText(folder / "client.py", kPythonClient);
        const std::string command = "python3 " + (folder / "client.py").string() + " " + (protocolFolder() / "tools").string() + " " +
                                    mode + " " + std::to_string(scanner->port()) + " " + (folder / "out.json").string() + " 60 2>" +
                                    (folder / "err").string();
        ASSERT_EQ(std::system(command.c_str()), 0) << readText(folder / "err");
        const nlohmann::json told = fileJson(folder / "out.json");
        EXPECT_EQ(told["skipped"], 0);
        EXPECT_EQ(told["bad"], 0);
        const nlohmann::json expected = mode[0] == 'A' ? nlohmann::json{"sFA A",
                                                                        "sFA 1",
                                                                        "sRA LMDscandatacfg 1 0 1 0 0 1 0 0 0 0 0 1",
                                                                        "sFA 3",
                                                                        "sFA 1",
                                                                        "sFA F",
                                                                        "sEA LMDscandata 1"}
                                                       : nlohmann::json();
        if (mode[0] == 'A') {
            EXPECT_EQ(told["log"], expected);
        } else {
            EXPECT_EQ(told["log"][0], "734641000a");
            EXPECT_EQ(told["log"][1], "7346410001");
            EXPECT_EQ(told["log"][6], "734541204c4d447363616e646174612001"); // as the real device answered
        }
        ASSERT_EQ(told["scans"].size(), 61U);
        EXPECT_EQ(told["scans"][0]["cmd"], "sRA");
        for (std::size_t i = 0; i < 61; ++i) {
            const nlohmann::json& t = told["scans"][i];
            const std::size_t line = i % 50;
            EXPECT_EQ(t["telegram_counter"], 10203 + i);
            EXPECT_EQ(t["scan_frequency"], 2500);
            EXPECT_EQ(t["status"], (std::vector<int>{2, 0}));
            EXPECT_EQ(t["encoders"][0]["position"], line);
            EXPECT_EQ(t["trailing"], 0);
            const auto values = t["ch16"][0]["data"].get<std::vector<float>>();
            EXPECT_TRUE(std::equal(values.begin(), values.end(), scan.rangeMm.line(static_cast<int>(line))));
            EXPECT_NEAR(t["ch16"][0]["angles"][1].get<double>(), std::get<PolarGeometry>(scan.geometry).beamDeg.back(), 1e-9);
            EXPECT_EQ(t["ch8"][0]["data"].size(), 60U);
        }
    }
}

TEST(EmulatedScanner, TurnsBackAtTheEndWhenAsked) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 0;
    settings.atEnd = AtEnd::Reverse;
    const auto scanner = served(countingScan(10, 5), settings);
    Listener listener;
    {
        const ScannerConnection session(settingsFor(*scanner), listener.events());
        EXPECT_TRUE(listener.waitForScans(45));
    }
    const auto telegrams = listener.telegrams();
    for (std::size_t i = 0; i < 45; ++i) EXPECT_EQ(telegrams[i].encoders[0].position, i % 20 < 10 ? i % 20 : 19 - i % 20);
    EXPECT_EQ(accountOf(telegrams).lost, 0);
}

TEST(EmulatedScanner, KeepsItsRate) {
    using Clock = std::chrono::steady_clock;
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 100;
    auto start = Clock::now();
    const auto scanner = served(countingScan(10, 5), settings);
    Listener listener;
    const ScannerConnection session(settingsFor(*scanner), listener.events());
    EXPECT_TRUE(listener.waitForScans(101));
    const auto measured = [&] { return static_cast<double>(scanner->statistics().lines); };
    const auto due = [&] { return settings.linesPerSecond * std::chrono::duration<double>(Clock::now() - start).count(); };
    const double lines = measured();
    EXPECT_LE(lines, due() + 1.0) << "never faster";
    // Nor slower: what a busy machine delays by less than a second follows at once.
    double before = lines;
    start = Clock::now();
    EXPECT_TRUE(waitUntil([&] {
        const double came = measured() - before, wanted = due();
        if (came < 50) return false;
        if (came > 0.9 * wanted) return true;
        before = measured(); // it did not get the processor for longer
        start = Clock::now();
        return false;
    }));
}

TEST(EmulatedScanner, ItsClockRunsAsRealTimeDoesAtAnyRate) {
    for (const double rate : {12.5, 25.0, 100.0, 0.0, 20000.0}) { // the last two: as the scan frequency says
        EmulatedScannerSettings settings;
        settings.linesPerSecond = rate;
        auto telegrams = telegramsOf(countingScan(10, 5));
        ASSERT_TRUE(telegrams);
        const std::uint32_t sentAfter = (*telegrams)[0].transmittedUs - (*telegrams)[0].sinceStartUs;
        EmulatedSweep sweep(std::make_shared<const std::vector<ScanTelegram>>(*std::move(telegrams)), settings);
        const ScanTelegram first = sweep.next()->telegram, second = sweep.next()->telegram;
        const double hz = rate > 0.0 && rate <= 100.0 ? rate : 25.0;
        EXPECT_EQ(second.sinceStartUs - first.sinceStartUs, std::lround(1e6 / hz)) << rate;
        EXPECT_EQ(second.scanFrequency, std::lround(100.0 * hz)) << rate;
        EXPECT_EQ(second.transmittedUs - second.sinceStartUs, std::lround(sentAfter * 25.0 / hz)) << rate;
    }
}

TEST(EmulatedScanner, ContaminationCanBeSwitched) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 300;
    const auto scanner = served(countingScan(10, 5), settings);
    Listener listener;
    {
        const ScannerConnection session(settingsFor(*scanner), listener.events());
        EXPECT_TRUE(listener.waitForScans(5));
        scanner->setContamination(true, true);
        EXPECT_TRUE(listener.waitForScans(50));
    }
    const auto telegrams = listener.telegrams();
    EXPECT_TRUE((deviceFlags(telegrams.front()) == DeviceFlags{}));
    EXPECT_TRUE((deviceFlags(telegrams.back()) == DeviceFlags{false, true, true}));
}

TEST(EmulatedScanner, SaysWhenItCannotServe) {
    const auto first = served(countingScan(2, 5), {});
    EmulatedScannerSettings settings;
    settings.port = first->port();
    auto telegrams = std::make_shared<const std::vector<ScanTelegram>>(1);
    const auto taken = serveTelegrams(telegrams, settings);
    ASSERT_FALSE(taken);
    EXPECT_NE(taken.error().sentence().find("choose another port"), std::string::npos);
    settings.address = "nowhere";
    EXPECT_FALSE(serveTelegrams(telegrams, settings));
    EXPECT_FALSE(serveTelegrams(nullptr, {}));
    EXPECT_FALSE(serveTelegrams(std::make_shared<const std::vector<ScanTelegram>>(), {}));
}

TEST(EmulatedScanner, AClientThatDoesNotReadIsNotSavedUpFor) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 20000;
    const auto scanner = served(countingScan(4, 800), settings);
    Listener listener;
    std::atomic<bool> hold{true};
    ConnectionEvents events = listener.events();
    const auto record = events.frameReceived;
    events.frameReceived = [&](const ColaFrame& frame) {
        while (isScanTelegram(frame.payload()) && hold) std::this_thread::sleep_for(1ms);
        record(frame);
    };
    {
        const ScannerConnection session(settingsFor(*scanner), events);
        EXPECT_TRUE(waitUntil([&] { return scanner->statistics().lost > 0; }));
        const std::uint64_t measured = scanner->statistics().lines;
        hold = false;
        EXPECT_GT(scanner->statistics().lost, 0U);
        // The contents of the sockets come first; their size depends on the machine, but they cannot exceed what was measured.
        EXPECT_TRUE(listener.waitForScans(measured + 100));
    }
    const Account account = accountOf(listener.telegrams());
    EXPECT_GT(account.lost, 0);
    EXPECT_EQ(account.received + account.lost, account.span);
}
