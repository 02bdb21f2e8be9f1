// Worker processes made by fork, each connected by a pair of sockets. A message is its length followed by its bytes.
#include "core/batch/archive/worker_processes.h"

#include "core/base/bands.h"
#include "core/base/memory.h"

#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <vector>

namespace edgescan::batch {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMostAnswer = 1ULL << 28U;
constexpr int kOutOfMemoryExit = 86;
constexpr char kGoesOn = 'g', kWantsSuccessor = 's'; // last byte of an answer

struct WorkerProcess {
    pid_t process = -1;
    int socket = -1;
    std::optional<std::size_t> job;
    Clock::time_point since;
    std::string arrived; // bytes of the answer so far
    bool ranOut = false; // it exceeded its time
};

bool sendAll(int socket, const void* bytes, std::size_t count) {
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t sent = ::send(socket, at, count, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += sent;
        count -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool receiveAll(int socket, void* bytes, std::size_t count) {
    char* at = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = ::recv(socket, at, count, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

// Bytes of address space of this process.
std::uint64_t addressSpace() {
    const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    std::array<char, 64> text{};
    const ssize_t count = file < 0 ? 0 : ::read(file, text.data(), text.size() - 1);
    if (file >= 0) ::close(file);
    std::uint64_t pages = 0;
    for (ssize_t i = 0; i < count && text[static_cast<std::size_t>(i)] >= '0'; ++i)
        pages = pages * 10 + static_cast<std::uint64_t>(text[static_cast<std::size_t>(i)] - '0');
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// A sanitizer maps shadow memory for the whole address space, so a limit would leave no memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsAddresses = false;
#else
constexpr bool kLimitsAddresses = true;
#endif

[[noreturn]] void workFor(const Jobs& jobs, int number, int socket, std::uint64_t memoryBytes) {
    const std::uint64_t before = addressSpace();
    if (memoryBytes > 0 && kLimitsAddresses) {
        rlimit limit{};
        ::getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = std::min<rlim_t>(before + memoryBytes, limit.rlim_max);
        ::setrlimit(RLIMIT_AS, &limit);
    }
    std::uint64_t job = 0;
    while (receiveAll(socket, &job, sizeof job)) {
        std::string answer;
        try {
            answer = jobs.work(job, number);
        } catch (const std::bad_alloc&) {
            ::_exit(kOutOfMemoryExit);
        } catch (const std::exception&) {
            ::_exit(1);
        }
        const bool large = memoryBytes > 0 && addressSpace() > before + memoryBytes / 2;
        answer += large ? kWantsSuccessor : kGoesOn;
        const std::uint64_t size = answer.size();
        if (!sendAll(socket, &size, sizeof size) || !sendAll(socket, answer.data(), answer.size())) break;
        if (large) break;
    }
    ::_exit(0);
}

// Threads that fork() does not copy may hold a lock for ever. 0 if the system does not report the number.
std::size_t threadsOfThisProcess() {
    std::error_code none;
    std::size_t threads = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", none)) threads += entry.path().empty() ? 0 : 1;
    return threads;
}

class WorkerPool {
public:
    WorkerPool(const WorkerLimits& limits, const Jobs& jobs) : limits_(limits), jobs_(jobs) {
        workers_.resize(static_cast<std::size_t>(std::max(1, limits.processes)));
    }
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    ~WorkerPool() {
        for (WorkerProcess& worker : workers_) {
            if (worker.socket >= 0) ::close(worker.socket);
            if (worker.process > 0) {
                ::kill(worker.process, SIGKILL);
                ::waitpid(worker.process, nullptr, 0);
            }
        }
    }

    Result<Done> run() {
        while (true) {
            for (std::size_t i = 0; i < workers_.size(); ++i) {
                if (workers_[i].job) continue;
                if (auto given = giveJob(static_cast<int>(i)); !given) return given.error();
            }
            if (std::ranges::none_of(workers_, [](const WorkerProcess& worker) { return worker.job.has_value(); })) return Done{};
            if (hasWaitedEnough()) return Done{}; // the jobs in work end with this object
            listen();
        }
    }

private:
    /// After the wish to stop, a job that nearly ends may do so.
    bool hasWaitedEnough() {
        constexpr std::chrono::milliseconds kWaits{400};
        if (!jobs_.goOn() && !stopped_) stopped_ = Clock::now();
        return stopped_ && Clock::now() - *stopped_ > kWaits;
    }

    Result<Done> giveJob(int number) {
        if (finished_ || !jobs_.goOn()) return Done{};
        const auto job = jobs_.next();
        finished_ = !job;
        if (!job) return Done{};
        WorkerProcess& worker = workers_[static_cast<std::size_t>(number)];
        const std::uint64_t index = *job;
        for (int attempt = 0; attempt < 2; ++attempt) { // the process may have been killed from outside
            if (worker.process < 0) {
                if (auto made = start(number); !made) return made.error();
            }
            worker.job = *job;
            worker.since = Clock::now();
            if (sendAll(worker.socket, &index, sizeof index)) return Done{};
            worker.job.reset();
            static_cast<void>(reap(worker));
        }
        return Error{"the processes that do the work end at once", "", "look what ends them, and run the command again"};
    }

    Result<Done> start(int number) {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            return Error{std::string("no process can be talked to (") + std::strerror(errno) + ")", "", "use fewer --jobs"};
        const pid_t parent = ::getpid();
        const pid_t child = ::fork();
        if (child < 0) {
            const std::string reason = std::strerror(errno);
            ::close(ends[0]);
            ::close(ends[1]);
            return Error{"no process can be made (" + reason + ")", "", "use fewer --jobs"};
        }
        if (child == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL); // workers end when the run is killed
            if (::getppid() != parent) ::_exit(0);
            ::signal(SIGINT, SIG_IGN); // the run ends in order, and ends its workers
            ::signal(SIGTERM, SIG_IGN);
            ::signal(SIGHUP, SIG_IGN);
            ::close(ends[0]);
            for (const WorkerProcess& other : workers_) {
                if (other.socket >= 0) ::close(other.socket);
            }
            workFor(jobs_, number, ends[1], limits_.memoryBytes);
        }
        ::close(ends[1]);
        workers_[static_cast<std::size_t>(number)] = {child, ends[0], std::nullopt, {}, {}, false};
        return Done{};
    }

    void listen() {
        constexpr int kLookMs = 100; // for time-outs
        std::vector<pollfd> waits;
        for (const WorkerProcess& worker : workers_) waits.push_back({worker.job ? worker.socket : -1, POLLIN, 0});
        static_cast<void>(::poll(waits.data(), waits.size(), kLookMs));
        for (std::size_t i = 0; i < workers_.size(); ++i) {
            WorkerProcess& worker = workers_[i];
            if (!worker.job) continue;
            if ((waits[i].revents & (POLLIN | POLLHUP | POLLERR)) != 0) receive(worker);
            const std::chrono::duration<double> taken = Clock::now() - worker.since;
            if (worker.job && !worker.ranOut && limits_.secondsPerJob > 0 && taken.count() > limits_.secondsPerJob) {
                worker.ranOut = true;
                ::kill(worker.process, SIGKILL); // its end is handled as that of any other process
            }
        }
    }

    void receive(WorkerProcess& worker) {
        std::array<char, 65536> piece{};
        const ssize_t got = ::recv(worker.socket, piece.data(), piece.size(), MSG_DONTWAIT);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
        if (got > 0) worker.arrived.append(piece.data(), static_cast<std::size_t>(got));
        std::uint64_t size = 0;
        const bool hasSize = worker.arrived.size() >= sizeof size;
        if (hasSize) std::memcpy(&size, worker.arrived.data(), sizeof size);
        if (hasSize && size > 0 && size <= kMostAnswer && worker.arrived.size() >= sizeof size + size) {
            JobEnd end{*worker.job, worker.arrived.substr(sizeof size, size - 1), {}};
            const bool goes = worker.arrived[sizeof size + size - 1] == kGoesOn;
            worker.arrived.clear();
            worker.job.reset();
            if (!goes) static_cast<void>(reap(worker));
            jobs_.ended(end);
        } else if (got <= 0) {
            JobEnd end{*worker.job, std::nullopt, {}};
            end.death = reap(worker);
            jobs_.ended(end);
        }
    }

    // Waits until the process has ended; returns how it ended.
    std::string reap(WorkerProcess& worker) {
        ::close(worker.socket);
        int status = 0;
        while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
        }
        const bool ranOut = worker.ranOut;
        worker = {};
        if (ranOut) return "it took longer than the time limit";
        if (WIFSIGNALED(status))
            return "it ended with signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
        if (WEXITSTATUS(status) == kOutOfMemoryExit)
            return "it ran out of memory" +
                   (limits_.memoryBytes == 0 ? std::string() : ", and --memory gives it " + sizeText(limits_.memoryBytes));
        return "it ended with code " + std::to_string(WEXITSTATUS(status));
    }

    WorkerLimits limits_;
    const Jobs& jobs_;
    std::vector<WorkerProcess> workers_;
    bool finished_ = false;
    std::optional<Clock::time_point> stopped_;
};

} // namespace

Result<Done> runInProcesses(const WorkerLimits& limits, const Jobs& jobs) {
    endSecondThread();
    if (const std::size_t threads = threadsOfThisProcess(); threads > 1)
        return Error{"this process has " + std::to_string(threads) + " threads, and a copy of it could wait for one of them for ever", "",
                     "start no thread before the work is given to processes; this is a fault of the program"};
    return WorkerPool(limits, jobs).run();
}

} // namespace edgescan::batch
