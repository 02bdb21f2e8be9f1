// Runs a PCL method in a separate process. The request and the answer are files in memory, so that neither process waits for the other to
// read.
#include "app/lab/peers/peer_messages.h"
#include "core/base/memory.h"

#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

extern char** environ;

namespace edgescan::lab {
namespace {

constexpr const char* kProgram = "edgescan-peers";
constexpr std::uint64_t kProgramBytes = 1ULL << 30U; // PCL's libraries alone map several hundred MB
constexpr std::uint64_t kBytesPerCell = 2000;
constexpr double kProgramSeconds = 60;
constexpr double kSecondsPerCell = 2e-4;

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) close(fd_);
    }
    [[nodiscard]] int get() const { return fd_; }

private:
    int fd_;
};

Result<std::filesystem::path> programPath() {
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
    for (const auto& path : {folder / kProgram, folder / ".." / "lib" / "edgescan" / kProgram}) {
        if (std::filesystem::exists(path, failed)) return path;
    }
    return Error{"there is no program with PCL inside, so the PCL peers are left out", (folder / kProgram).string(),
                 "install libpcl-dev and build again"};
}

// The exit status, or null if the process was killed after `seconds` (infinite = never).
std::optional<int> waitFor(pid_t child, double seconds) {
    const Descriptor handle(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
    bool late = false;
    if (handle.get() >= 0 && std::isfinite(seconds)) {
        pollfd ended{handle.get(), POLLIN, 0};
        late = poll(&ended, 1, static_cast<int>(std::min(seconds * 1000, 2e9))) == 0;
        if (late) kill(child, SIGKILL);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (late) return std::nullopt;
    return status;
}

} // namespace

Result<Done> checkPclIsAvailable() {
    const auto program = programPath();
    if (!program) return program.error();
    return Done{};
}

Result<PclEdges> runPclMethod(PclMethod peer, const PclScan& scan, const PclLimits& limits) {
    const auto program = programPath();
    if (!program) return program.error();
    const std::string name = pclMethodName(peer);
    const auto cells = static_cast<std::uint64_t>(scan.pointsM.size());
    const std::uint64_t bytes =
        limits.memoryBytes > 0 ? limits.memoryBytes : std::min(availableMemoryBytes(), kProgramBytes + kBytesPerCell * cells);
    const double seconds = kProgramSeconds + 6 * limits.seconds + kSecondsPerCell * static_cast<double>(cells);

    const Descriptor request(memfd_create("request", MFD_CLOEXEC));
    const Descriptor answer(memfd_create("answer", MFD_CLOEXEC));
    if (request.get() < 0 || answer.get() < 0 || !writeAll(request.get(), requestBytes(peer, scan, limits)) ||
        lseek(request.get(), 0, SEEK_SET) != 0)
        return Error{"there is no memory to hand the scan to PCL", name, "close other programs or choose a smaller scan"};

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, request.get(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, answer.get(), STDOUT_FILENO);
    std::string path = program->string();
    std::string memory = std::to_string(bytes);
    std::string time = std::isfinite(seconds) ? std::to_string(static_cast<std::uint64_t>(std::ceil(seconds))) : "0";
    char* arguments[]{path.data(), memory.data(), time.data(), nullptr};
    pid_t child = 0;
    const int failed = posix_spawn(&child, path.c_str(), &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) return Error{std::string("it cannot be started (") + std::strerror(failed) + ")", path, "build the project again"};

    const std::optional<int> status = waitFor(child, 4 * seconds); // on a busy machine the process reaches its limit of CPU time later
    if (!status || (WIFSIGNALED(*status) && WTERMSIG(*status) == SIGXCPU))
        return Error{"PCL did not come to an end in " + time + " s", name, "choose a smaller scan, or --slow"};
    if (WIFSIGNALED(*status))
        return Error{std::string("PCL crashed (") + strsignal(WTERMSIG(*status)) + ")", name, "compare the others, they are not affected"};
    if (auto edges = readAnswer(readAll(answer.get()))) return std::move(*edges);
    return Error{"PCL needed more than " + sizeText(bytes) + " of memory", name, "close other programs or choose a smaller scan"};
}

} // namespace edgescan::lab
