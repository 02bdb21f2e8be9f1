// Clients that send requests and never read, clients that do nothing, and a system without free descriptors: the emulated scanner's memory
// stays bounded, and it serves the next client.
#include "tests/support/live_session.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

/// A TCP client that shares no code with the program.
class RawClient {
public:
    explicit RawClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    ~RawClient() { ::close(socket_); }
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    [[nodiscard]] bool connected() const { return connected_; }
    /// Sends without waiting; returns the number of bytes sent.
    std::size_t put(const Bytes& bytes) {
        const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        return count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    /// Receives frames until `count` are there.
    std::size_t frames(std::size_t count) {
        timeval wait{kPatience.count(), 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
        ColaStream stream;
        Bytes piece(65536);
        while (stream.counts().frames < count) {
            const ssize_t length = ::recv(socket_, piece.data(), piece.size(), 0);
            if (length <= 0) break;
            static_cast<void>(stream.push(ByteView(piece).first(static_cast<std::size_t>(length))));
        }
        return stream.counts().frames;
    }

private:
    int socket_;
    bool connected_ = false;
};

Bytes request(std::string_view text) { return framed(Bytes(text.begin(), text.end()), Dialect::B); }

bool answers(std::uint16_t port) {
    RawClient client(port);
    return client.connected() && client.put(request("sRN DeviceIdent")) > 0 && client.frames(1) == 1;
}

double residentBytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace

TEST(EmulatedScanner, AClientThatAsksAndNeverReadsCostsNoMemory) {
    for (const bool pieces : {false, true}) {
        EmulatedScannerSettings settings;
        settings.faults.splitSends = pieces;
        settings.linesPerSecond = 0;
        const auto scanner = served(countingScan(50, 200), settings);
        const Bytes one = request("sRN LMDscandata");
        constexpr std::size_t kAtOnce = 1000;
        Bytes many;
        for (std::size_t i = 0; i < kAtOnce; ++i) many.insert(many.end(), one.begin(), one.end());
        RawClient greedy(scanner->port());
        ASSERT_TRUE(greedy.connected());
        const double before = residentBytes();
        // Sends until the scanner accepts nothing more; on a busy machine it may only be late before that.
        std::size_t asked = 0;
        int quiet = 0;
        EXPECT_TRUE(waitUntil([&] {
            // A request that was sent in part is completed with the next piece.
            const Bytes rest(many.begin() + static_cast<std::ptrdiff_t>(asked % one.size()), many.end());
            const std::size_t went = greedy.put(rest);
            asked += went;
            quiet = went > 0 ? 0 : quiet + 1;
            return quiet >= 250 && asked > 50'000 * one.size();
        }));
        const std::size_t requests = asked / one.size();
        const auto answered = scanner->statistics().lines;
        const double grown = residentBytes() - before;
        std::printf("[ measured ] %zu requests for %zu MB of answers: %llu answered, %.1f MB more memory\n", requests,
                    requests * 520 / 1'000'000, static_cast<unsigned long long>(answered), grown / 1e6);
        EXPECT_LT(answered, requests / 2); // the contents of the sockets' own buffers, with a margin
        EXPECT_LT(grown, 24e6);
        EXPECT_TRUE(answers(scanner->port())) << "another client is served meanwhile";
        // When it reads, it gets all the answers.
        EXPECT_EQ(greedy.frames(requests), requests);
    }
}

TEST(EmulatedScanner, AcceptsAgainOnceThereAreDescriptors) {
    const auto scanner = served(countingScan(5, 9), {}); // without a client before: its descriptor could be closed later than it leaves
    rlimit before{};
    getrlimit(RLIMIT_NOFILE, &before);
    rlimit few = before;
    few.rlim_cur = std::min<rlim_t>(before.rlim_cur, 256);
    setrlimit(RLIMIT_NOFILE, &few);
    {
        std::vector<int> fillers;
        for (int filler = ::dup(0); filler >= 0; filler = ::dup(0)) fillers.push_back(filler);
        ASSERT_GT(fillers.size(), 10U);
        ::close(fillers.back());
        fillers.pop_back();
        RawClient waiting(scanner->port()); // it takes the last descriptor; the scanner has none for the other end
        RawClient unlucky(scanner->port()); // no descriptor at all
        EXPECT_FALSE(unlucky.connected());
        waiting.put(request("sRN DeviceIdent"));
        EXPECT_TRUE(waitUntil([&] { return scanner->statistics().failedAccepts >= 2; })); // it tries, fails, and tries again
        for (const int filler : fillers) ::close(filler);
        EXPECT_EQ(waiting.frames(1), 1U);
    }
    setrlimit(RLIMIT_NOFILE, &before);
    EXPECT_TRUE(answers(scanner->port()));
}

TEST(EmulatedScanner, ClientsThatVanishedGiveWay) {
    EmulatedScannerSettings settings;
    settings.silentS = 0.3;
    const auto scanner = served(countingScan(5, 9), settings);
    std::vector<std::unique_ptr<RawClient>> silent;
    for (int i = 0; i < 8; ++i) silent.push_back(std::make_unique<RawClient>(scanner->port()));
    EXPECT_TRUE(waitUntil([&] { return scanner->statistics().clients == 8; }));
    EXPECT_TRUE(waitUntil([&] { return answers(scanner->port()); }));
    EXPECT_TRUE(answers(scanner->port()));
}
