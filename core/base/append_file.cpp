// Appends bytes; after a failed write it cuts the file back to its old length.
#include "core/base/append_file.h"

#include <cerrno>
#include <cstddef>
#include <unistd.h>

namespace edgescan {

int appendWhole(int file, const std::string& bytes) {
    const off_t before = ::lseek(file, 0, SEEK_END);
    std::size_t at = 0;
    while (at < bytes.size()) {
        const ssize_t count = ::write(file, bytes.data() + at, bytes.size() - at);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            const int code = errno;
            static_cast<void>(::ftruncate(file, before));
            return code;
        }
        at += static_cast<std::size_t>(count);
    }
    return 0;
}

} // namespace edgescan
