// Times in the units of edgescan-bench.
#include "tests/bench/goals.h"

#include <cstring>

namespace edgescan::bench {
namespace {

// Bytes that one thread copies per millisecond: bytes read plus bytes written.
double bytesPerMs() {
    std::vector<char> from(std::size_t{128} << 20U, 1), to(from.size());
    std::vector<Candidate> copy{{"copy", [&] { std::memcpy(to.data(), from.data(), from.size()); }}};
    measureInTurn(copy, 5);
    return 2.0 * static_cast<double>(from.size()) / medianOf(copy[0].cpuMs);
}

} // namespace

void printCandidates(const std::vector<Candidate>& runs, const Scan& scan) {
    const double least = 7.0 * static_cast<double>(scan.cells()) / bytesPerMs(); // range and state read, mask and class written
    std::printf("\n| candidate | thread CPU, ms | wall, ms | x memory's limit | ns per cell |\n|---|---|---|---|---|\n");
    for (const Candidate& run : runs)
        std::printf("| %s | %.2f | %.2f | %.1f | %.1f |\n", run.name.c_str(), medianOf(run.cpuMs), medianOf(run.wallMs),
                    medianOf(run.cpuMs) / least, 1e6 * medianOf(run.cpuMs) / static_cast<double>(scan.cells()));
}

} // namespace edgescan::bench
