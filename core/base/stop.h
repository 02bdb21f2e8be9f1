// A person's wish to end the work of one thread before it has written anything.
#pragma once

#include <atomic>

namespace edgescan {

/// Binds the thread during the lifetime of this object to a wish, which another thread may set. One per thread at a time.
class BindStop {
public:
    explicit BindStop(const std::atomic<bool>& wish);
    ~BindStop();
    BindStop(const BindStop&) = delete;
    BindStop& operator=(const BindStop&) = delete;
};

/// True if this thread is bound to a wish that was set. Files that are being written by it then do not appear (core/base/whole_file.h).
[[nodiscard]] bool isStopWished();

} // namespace edgescan
