// Reads a stream whose length is unknown.
#include "core/base/pipe.h"

#include "core/base/memory.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace edgescan {
namespace {

namespace fs = std::filesystem;

constexpr auto kLongestWithoutWriter = std::chrono::seconds(10);

/// An open descriptor, closed at the end unless it is standard input.
struct Opened {
    int number = -1;
    explicit Opened(const fs::path& path)
        : number(path == kStandardInput ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    ~Opened() {
        if (number > STDIN_FILENO) ::close(number);
    }
};

Error pipeError(const fs::path& path, int code) {
    return {std::string("this pipe cannot be read: ") + std::strerror(code), path.string(), "save what it gives to a file and open that"};
}

} // namespace

bool isPipe(const fs::path& path) {
    if (path == kStandardInput) return true;
    std::error_code problem;
    return fs::is_fifo(path, problem);
}

Result<std::vector<std::byte>> readPipe(const fs::path& path, const std::function<bool()>& goOn) {
    const Opened pipe(path);
    if (pipe.number < 0) return pipeError(path, errno);
    if (::isatty(pipe.number) == 1) return Error{"this is a keyboard, not a scan", path.string(), "give a file, or pipe one in"};
    struct stat status {};
    const bool device = ::fstat(pipe.number, &status) == 0 && S_ISCHR(status.st_mode); // a device may have no end
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::byte> bytes;
    std::array<std::byte, 65536> part;
    bool written = path == kStandardInput; // the program's parent has opened it
    while (true) {
        constexpr int kAskedAfterMs = 100;
        pollfd wait{pipe.number, POLLIN, 0};
        const int ready = ::poll(&wait, 1, written ? kAskedAfterMs : kAskedAfterMs / 5);
        if (!goOn()) return Error{"cancelled", path.string(), ""};
        if (ready < 0 && errno != EINTR) return pipeError(path, errno);
        if (ready <= 0 && written) continue;
        if (ready <= 0 && std::chrono::steady_clock::now() - start > kLongestWithoutWriter)
            return Error{"no program writes into this pipe", path.string(), "start the program that fills it, then open it again"};
        if (ready <= 0) continue;
        const ssize_t count = ::read(pipe.number, part.data(), part.size());
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) return pipeError(path, errno);
        if (count == 0) return bytes;
        if (device) return Error{"this is a device, not a scan", path.string(), "choose a file"};
        written = true;
        if (bytes.size() + static_cast<std::size_t>(count) > bytes.capacity()) {
            constexpr std::uint64_t kWhileItGrows = 6; // the old and the new buffer at the same time, and the scan made from them
            if (auto enough = checkMemory(kWhileItGrows * (bytes.size() + part.size()), path.string()); !enough)
                return Error{enough.error().what, path.string(), "save what it gives to a file and open that"};
        }
        bytes.insert(bytes.end(), part.begin(), part.begin() + count);
    }
}

} // namespace edgescan
