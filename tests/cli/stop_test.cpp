// Ctrl+C and SIGTERM end every reader and every live source at once, whatever comes in or does not come.
#include "tests/support/costly_files.h"
#include "tests/support/run_program.h"
#include "tests/support/seed_files.h"
#include "tests/support/served_program.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <thread>
#include <tuple>

namespace edgescan {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kAtOnce{5}; // a second, on a machine that has other work

/// edgescan-cli as a process that was not ended yet.
class Running {
public:
    explicit Running(const std::string& arguments) {
        const std::string command = "exec " + test::programFolder() + "/edgescan-cli " + arguments + " >/dev/null 2>&1 </dev/null";
        process_ = fork();
        if (process_ != 0) return;
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::signal(SIGINT, SIG_DFL); // a shell in the background passes on that it is ignored
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    ~Running() {
        if (hasEnded()) return;
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    [[nodiscard]] bool hasEnded() {
        ended_ = ended_ || waitpid(process_, nullptr, WNOHANG) == process_;
        return ended_;
    }
    /// How long it takes to end.
    [[nodiscard]] Clock::duration endsAfter(int signal) {
        const auto start = Clock::now();
        kill(process_, signal);
        static_cast<void>(test::waitUntil([&] { return hasEnded(); }));
        return Clock::now() - start;
    }
    /// Seconds of processor that it has used; it reads when they grow.
    [[nodiscard]] double seconds() const {
        std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
        std::string text{std::istreambuf_iterator<char>(file), {}};
        std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 2)));
        std::string skipped;
        for (int n = 0; n < 11; ++n) fields >> skipped;
        double user = 0, system = 0;
        fields >> user >> system;
        return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
    }

private:
    pid_t process_ = 0;
    bool ended_ = false;
};

/// A pipe that gives the beginning of a file and then nothing, without an end.
class SlowPipe {
public:
    SlowPipe(const fs::path& path, const std::string& beginning) {
        ::mkfifo(path.c_str(), 0600);
        pipe_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC); // never an end, as there is always a writer
        ::fcntl(pipe_, F_SETPIPE_SZ, 1 << 20);
        const std::string part = beginning.substr(0, std::min<std::size_t>(beginning.size(), 60'000));
        EXPECT_EQ(::write(pipe_, part.data(), part.size()), static_cast<ssize_t>(part.size()));
    }
    ~SlowPipe() { ::close(pipe_); }
    SlowPipe(const SlowPipe&) = delete;
    SlowPipe& operator=(const SlowPipe&) = delete;
    /// All that was written has been taken.
    [[nodiscard]] bool isEmpty() const {
        int left = 0;
        return ::ioctl(pipe_, FIONREAD, &left) == 0 && left == 0;
    }

private:
    int pipe_ = -1;
};

/// Answers everyone who connects with these bytes, over and over or once, and then says nothing more.
class Peer {
public:
    Peer(std::string answer, bool again) : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        const auto plain = reinterpret_cast<sockaddr*>(&address);
        if (::bind(listening_, plain, size) != 0 || ::listen(listening_, 4) != 0 || ::getsockname(listening_, plain, &size) != 0) return;
        address_ = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
        answering_ = std::thread([this, answer = std::move(answer), again] {
            for (int peer = 0; (peer = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC)) >= 0; ::close(peer)) {
                connected_ = true;
                bool open = answer.empty() || ::send(peer, answer.data(), answer.size(), MSG_NOSIGNAL) > 0;
                while (open && again) open = ::send(peer, answer.data(), answer.size(), MSG_NOSIGNAL) > 0;
                char byte = 0;
                while (open && ::recv(peer, &byte, 1, 0) > 0) {
                }
            }
        });
    }
    ~Peer() {
        ::shutdown(listening_, SHUT_RDWR);
        if (answering_.joinable()) answering_.join();
        ::close(listening_);
    }
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    [[nodiscard]] const std::string& address() const { return address_; }
    [[nodiscard]] bool isConnected() const { return connected_; }

private:
    int listening_;
    std::atomic<bool> connected_{false};
    std::string address_;
    std::thread answering_;
};

} // namespace

TEST(CliStop, EndsEveryReaderOfAPipeThatGivesNoMore) {
    const TemporaryFolder folder;
    int number = 0;
    for (const test::SeedFile& seed : test::seedFiles()) {
        if (seed.extension.empty() || seed.extension == ".json") continue; // a description has its counts in a second file
        const fs::path path = folder / (std::to_string(number) + seed.extension);
        const int signal = number++ % 2 == 0 ? SIGINT : SIGTERM;
        const SlowPipe pipe(path, seed.bytes.substr(0, seed.bytes.size() / 2));
        Running running("info " + path.string());
        ASSERT_TRUE(test::waitUntil([&] { return pipe.isEmpty(); })) << seed.reader << seed.extension;
        EXPECT_FALSE(running.hasEnded()) << seed.reader;
        EXPECT_LT(running.endsAfter(signal), kAtOnce) << seed.reader << seed.extension;
    }
    EXPECT_GT(number, 15);
}

TEST(CliStop, EndsEveryCommandThatReads) {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    fs::create_directory(out);
    // Rows of points in all directions: of this many, a grid is searched for seconds.
    std::ofstream(folder / "slow.xyz", std::ios::binary) << test::costly::looseText(30'000'000);
    const std::string slow = (folder / "slow.xyz").string();
    for (const std::string& line :
         {"info " + slow, "detect " + slow, "rocks " + slow, "convert " + slow + " " + out + "/c.pcd",
          "thumbnail " + slow + " " + out + "/t.png", "report " + slow + " -o " + out + "/r.html", "why " + slow + " --cell 1,1",
          "compare " + slow + " " + slow, "batch " + slow + " -o " + out + "/batch --jobs 1", "emulate " + slow + " --port 0",
          "replay " + slow}) {
        for (const int signal : {SIGINT, SIGTERM}) {
            Running running(line);
            ASSERT_TRUE(test::waitUntil([&] { return running.hasEnded() || running.seconds() > 0.1 || line.starts_with("batch"); }))
                << line;
            EXPECT_LT(running.endsAfter(signal), kAtOnce) << line;
        }
    }
    EXPECT_FALSE(fs::exists(out + "/c.pcd"));
}

TEST(CliStop, EndsEveryLiveSource) {
    const TemporaryFolder folder;
    std::string telegrams;
    while (telegrams.size() < 100'000) telegrams += "\x02sRA SCdevicestate 1\x03";
    const std::string switching = "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"; // the rest never comes
    int number = 0;
    for (const auto& [scheme, answer, again] : {std::tuple("", std::string(), false),
                                                {"", telegrams, true},
                                                {"", std::string("\x02\x02\x02\x02\xff\xff\xff\xff"), false},
                                                {"ws://", std::string(), false},
                                                {"ws://", switching, false},
                                                {"ws://", std::string(1000, 'x'), true}}) {
        for (const int signal : {SIGINT, SIGTERM}) {
            const Peer peer(answer, again);
            Running running("record " + (scheme + peer.address()) + " -o " + (folder / (std::to_string(number++) + ".mcap")).string());
            ASSERT_TRUE(test::waitUntil([&] { return peer.isConnected(); })) << scheme;
            EXPECT_LT(running.endsAfter(signal), kAtOnce) << number;
        }
    }
    const std::string scan = (folder / "scan.json").string();
    ASSERT_EQ(test::runLab("simulate --lines 40 --beams 60 -o " + scan).code, 0);
    for (const char* kind : {"", " --bridge", " --bridge --cloud"}) {
        const test::ServedProgram served(scan + kind + " --loop --rate 100");
        const fs::path recording = folder / (std::to_string(number++) + ".mcap");
        Running running("record " + (*kind == '\0' ? served.address() : "ws://" + served.address()) + " -o " + recording.string());
        ASSERT_TRUE(test::waitUntil([&] { return fs::exists(recording) && fs::file_size(recording) > 20'000; })) << kind;
        EXPECT_LT(running.endsAfter(SIGINT), kAtOnce) << kind;
        EXPECT_EQ(test::runCli("info " + recording.string()).code, 0) << kind; // and what came is whole
    }
}

} // namespace edgescan
