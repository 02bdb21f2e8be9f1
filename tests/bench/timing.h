// Runs candidates alternately, so that disturbances by the machine affect all of them in the same way.
#pragma once

#include "core/edges/pipeline/pipeline.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace edgescan::bench {

[[nodiscard]] inline double medianOf(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Candidate {
    std::string name;
    std::function<void()> run;
    std::vector<double> cpuMs{};  ///< of this thread
    std::vector<double> wallMs{}; ///< including threads that it waits for
};

inline void runOnce(Candidate& candidate) {
    const auto start = std::chrono::steady_clock::now();
    const double cpuStart = edges::threadCpuMilliseconds();
    candidate.run();
    candidate.cpuMs.push_back(edges::threadCpuMilliseconds() - cpuStart);
    candidate.wallMs.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
}

inline void measureInTurn(std::vector<Candidate>& candidates, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        for (Candidate& candidate : candidates) runOnce(candidate);
    }
}

} // namespace edgescan::bench
