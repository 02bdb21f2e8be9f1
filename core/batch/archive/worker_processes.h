// Jobs done in processes of their own: what one does to its memory or its process ends that job and no other.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace edgescan {

struct WorkerLimits {
    int processes = 1;
    std::uint64_t memoryBytes = 0; ///< what a process may take beyond what it begins with; 0: no limit
    double secondsPerJob = 0;      ///< then it is ended; 0: no limit
};

struct JobEnd {
    std::size_t job = 0;
    std::optional<std::string> answer; ///< empty: the process ended before it had one
    std::string death;                 ///< and how, for a person: "it ended with signal 11 (Segmentation fault)"
};

struct Jobs {
    std::function<std::optional<std::size_t>()> next; ///< the next job to give out; empty: there is none
    /// Done in a worker, a copy of this process; `worker` is from 0 to processes - 1. Whatever it throws ends the worker.
    std::function<std::string(std::size_t job, int worker)> work;
    std::function<void(const JobEnd&)> ended; ///< in this process, in the order in which jobs end
    std::function<bool()> goOn;               ///< asked several times a second; false: no more jobs are given out
};

/// Returns when every job that was given out has ended. A worker does one job after the other; a new one takes the place of one that died
/// or took most of its memory. Error: this process has other threads, whose locks a copy could
/// wait for for ever; no process can be made; jobs given out are ended and told.
Result<Done> runInProcesses(const WorkerLimits& limits, const Jobs& jobs);

} // namespace edgescan
