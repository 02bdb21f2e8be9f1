// The scanner session with the independent mock scanner in ../shared/protocol/tools, with each of its faults.
#include "tests/support/live_session.h"
#include "tests/support/python_peer.h"

#include <boost/asio.hpp>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

class Mock {
public:
    explicit Mock(std::vector<std::string> faults) : port_(freePort()), process_(words(std::move(faults))) {}
    [[nodiscard]] ConnectionSettings settings(const ScannerTimeouts& timeouts = patient()) const {
        ConnectionSettings settings;
        settings.host = "127.0.0.1";
        settings.port = port_;
        settings.timeouts = timeouts;
        settings.timeouts.detect = 3s;
        return settings;
    }

private:
    static std::uint16_t freePort() {
        boost::asio::io_context context;
        const boost::asio::ip::tcp::acceptor acceptor(context, {boost::asio::ip::address_v4::loopback(), 0});
        return acceptor.local_endpoint().port();
    }
    [[nodiscard]] std::vector<std::string> words(std::vector<std::string> faults) const {
        std::vector<std::string> all{
            "python3",  (protocolFolder() / "tools" / "mock_lms511.py").string(), "--port", std::to_string(port_), "--rate", "100",
            "--stream", (vectorsFolder() / "lms511_a_d2h.bin").string()};
        all.insert(all.end(), faults.begin(), faults.end());
        return all;
    }

    std::uint16_t port_;
    Process process_;
};

/// Only real telegrams, in order, and all gaps counted.
void expectRealLines(const Listener& listener) {
    const auto telegrams = listener.telegrams();
    for (const ScanTelegram& telegram : telegrams) EXPECT_EQ(telegram.serialNumber, 18110550U);
    LineCounter counter;
    std::int64_t previous = 0;
    for (const ScanTelegram& telegram : telegrams) {
        const LineStamp stamp = counter.stamp(countOf(telegram), 0);
        if (stamp.step == LineStep::Next) {
            EXPECT_EQ(stamp.telegram - previous - 1, stamp.lost);
        }
        if (stamp.step != LineStep::Duplicate) previous = stamp.telegram;
    }
}

} // namespace

TEST(MockScanner, BothDialectsAndEveryWayOfCutting) {
    EDGESCAN_NEEDS_PYTHON();
    for (const auto& [chunk, dialect] : {std::pair("whole", std::optional<Dialect>()), std::pair("random", std::optional(Dialect::B)),
                                         std::pair("random", std::optional(Dialect::A))}) {
        const Mock mock({"--chunk", chunk});
        auto settings = mock.settings();
        settings.dialect = dialect;
        Listener listener;
        {
            const ScannerConnection session(settings, listener.events());
            EXPECT_TRUE(listener.waitForScans(40));
        }
        ASSERT_FALSE(listener.identities().empty());
        EXPECT_EQ(listener.identities()[0].dialect, dialect.value_or(Dialect::B));
        EXPECT_EQ(listener.identities()[0].firmware, "V1.80    ");
        EXPECT_EQ(listener.identities()[0].location, "SN 18110550");
        EXPECT_EQ(listener.identities()[0].refused.size(), 2U); // DeviceIdent and STlms
        EXPECT_EQ(accountOf(listener.telegrams()).lost, 0);
        expectRealLines(listener);
    }
}

TEST(MockScanner, GarbageAndLoss) {
    EDGESCAN_NEEDS_PYTHON();
    const Mock mock({"--garbage", "0.3", "--telegram-loss", "0.2", "--chunk", "random"});
    Listener listener;
    ConnectionStatistics statistics;
    {
        ScannerConnection session(mock.settings(), listener.events());
        EXPECT_TRUE(listener.waitForScans(80));
        session.stop();
        statistics = session.statistics();
    }
    expectRealLines(listener);
    const Account account = accountOf(listener.telegrams());
    EXPECT_EQ(account.received + account.lost, account.span);
    EXPECT_GE(account.lost, 5);
    EXPECT_GT(statistics.stream.skipped, 20U);
    EXPECT_EQ(statistics.reconnects, 0U);
}

TEST(MockScanner, DropsAndReconnects) {
    EDGESCAN_NEEDS_PYTHON();
    const Mock mock({"--drop-after", "20"});
    Listener listener;
    {
        const ScannerConnection session(mock.settings(), listener.events());
        EXPECT_TRUE(listener.waitFor([](const Listener& l) { return l.entered(ConnectionPhase::Live) >= 3; }));
    }
    expectRealLines(listener); // the mock restarts its counters at every connection
}

TEST(MockScanner, StallsAndIsNoticed) {
    EDGESCAN_NEEDS_PYTHON();
    const Mock mock({"--stall-after", "20"});
    Listener listener;
    {
        const ScannerConnection session(mock.settings(hasty()), listener.events());
        const char* const wanted = "LIVE STALE LOST CONNECTING IDENTIFYING LIVE";
        EXPECT_TRUE(listener.waitFor([&](const Listener& l) { return l.story().find(wanted) != std::string::npos; }));
    }
}
