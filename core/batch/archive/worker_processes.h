// Runs jobs in separate processes: a fault in one job ends only that job.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace edgescan::batch {

struct WorkerLimits {
    int processes = 1;
    std::uint64_t memoryBytes = 0; ///< memory that a process may use in addition to its memory at the start; 0: no limit
    double secondsPerJob = 0;      ///< time after which the job is ended; 0: no limit
};

struct JobEnd {
    std::size_t job = 0;
    std::optional<std::string> answer; ///< empty: the process ended before it sent an answer
    std::string death;                 ///< how the process ended, for a person: "it ended with signal 11 (Segmentation fault)"
};

struct Jobs {
    std::function<std::optional<std::size_t>()> next; ///< the next job; empty: no more jobs
    /// Runs in a worker, which is a copy of this process; `worker` is from 0 to processes - 1. An exception ends the worker.
    std::function<std::string(std::size_t job, int worker)> work;
    std::function<void(const JobEnd&)> ended; ///< called in this process, in the order in which jobs end
    std::function<bool()> goOn;               ///< called several times a second; false: no more jobs are started, and those in work
                                              ///< are ended, without `ended`, if they last longer than a moment
};

/// Returns when every started job has ended, or was ended. A worker does one job after the other. A new worker replaces one that died or
/// used most of its memory. Error: this process has other threads, whose locks a copy could wait for for ever; a process cannot be created;
/// jobs already started are ended and reported.
Result<Done> runInProcesses(const WorkerLimits& limits, const Jobs& jobs);

} // namespace edgescan::batch
