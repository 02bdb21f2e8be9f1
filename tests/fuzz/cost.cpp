// The cost fuzzer: thread CPU time and peak memory per byte of input, for every fuzzer of this folder. Each input is read in its own
// process, so that its peak is its own. Inputs are the kinds of tests/support/costly_files.h, seeds of a whole sweep, and damaged ones.
// edgescan_cost [KILOBYTES] [ROUNDS]; prints the worst case of each reader, and fails if one exceeds its factor.
#include "tests/support/costly_files.h"
#include "tests/support/damage.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <map>

#define EDGESCAN_FUZZER(name) extern "C" int name(const std::uint8_t* bytes, std::size_t size);
#include "fuzzers.inc"
#undef EDGESCAN_FUZZER

namespace {

using namespace edgescan;
using namespace edgescan::test;

using Fuzzer = int (*)(const std::uint8_t*, std::size_t);
const std::map<std::string, Fuzzer>& fuzzers() {
    static const std::map<std::string, Fuzzer> all{
#define EDGESCAN_FUZZER(name) {#name, name},
#include "fuzzers.inc"
#undef EDGESCAN_FUZZER
    };
    return all;
}

struct Cost {
    double nanoseconds = 0;
    double bytes = 0; ///< peak, minus the memory used before
    bool ended = false;
};

/// Above these limits a file costs more than its size justifies: ten times the worst known case, on any machine.
struct Factor {
    double nsPerByte = 0, bytesPerByte = 0;
};
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSlower = 30; // sanitizers store and check all memory accesses
#else
constexpr double kSlower = 1;
#endif
constexpr double kFixedNs = 1e9 * kSlower; // the fixed cost of any file: a few bytes may unpack to 8 MiB
constexpr double kFixedBytes = 3e8 * kSlower;

std::uint64_t peakNow() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::uint64_t residentNow() {
    const std::string statm = readText("/proc/self/statm");
    return std::stoull(statm.substr(statm.find(' ') + 1)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

double cpuNow() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

Cost costOf(Fuzzer fuzzer, const std::string& input) {
    int ends[2];
    if (::pipe(ends) != 0) return {};
    const pid_t child = ::fork();
    if (child == 0) {
        const double before = cpuNow();
        const std::uint64_t resident = residentNow();
        fuzzer(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
        const std::uint64_t peak = peakNow();
        const Cost cost{cpuNow() - before, peak > resident ? static_cast<double>(peak - resident) : 0.0, true};
        _exit(::write(ends[1], &cost, sizeof cost) == sizeof cost ? 0 : 1);
    }
    ::close(ends[1]);
    Cost cost;
    const bool told = ::read(ends[0], &cost, sizeof cost) == sizeof cost;
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    return told ? cost : Cost{};
}

struct Worst {
    double value = 0;
    std::string of;
    void take(double other, const std::string& name) {
        if (other > value) *this = {other, name};
    }
};
struct Row {
    int inputs = 0;
    Worst ns, bytes;
};

} // namespace

namespace {

/// Ratios of small inputs show the fixed cost of a file, not the cost of its bytes.
constexpr double kLeastBytes = 65536;

std::string nameOf(const SeedFile& seed, const std::string& what) { return seed.extension + (seed.extension.empty() ? "" : " ") + what; }

class Course {
public:
    void run(const std::string& reader, const std::string& name, const std::string& input) {
        const auto fuzzer = fuzzers().find(reader + "_fuzz");
        if (fuzzer == fuzzers().end()) return fail(reader + ", " + name + ": there is no such fuzzer");
        const Cost cost = costOf(fuzzer->second, input);
        Row& row = rows_[reader];
        ++row.inputs;
        if (!cost.ended) return fail(reader + ", " + name + ": ended in a crash");
        const double size = std::max(kLeastBytes, static_cast<double>(input.size()));
        row.ns.take(cost.nanoseconds / size, name);
        row.bytes.take(cost.bytes / size, name);
        const Factor& factor = factorOf(reader);
        if (cost.nanoseconds > kFixedNs + kSlower * factor.nsPerByte * size ||
            cost.bytes > kFixedBytes + kSlower * factor.bytesPerByte * size)
            fail(reader + ", " + name + ": " + std::to_string(input.size()) + " bytes took " + std::to_string(cost.nanoseconds * 1e-9) +
                 " s and " + std::to_string(static_cast<long long>(cost.bytes / 1e6)) + " MB");
    }
    void print() const {
        std::printf("%-14s %6s  %8s  %-44s %8s  %s\n", "reader", "inputs", "ns/byte", "of", "bytes/byte", "of");
        for (const auto& [reader, row] : rows_)
            std::printf("%-14s %6d  %8.0f  %-44s %8.0f  %s\n", reader.c_str(), row.inputs, row.ns.value, row.ns.of.c_str(), row.bytes.value,
                        row.bytes.of.c_str());
    }
    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] bool covers(const std::string& fuzzer) const { return rows_.contains(fuzzer.substr(0, fuzzer.rfind("_fuzz"))); }
    void fail(const std::string& what) {
        std::fprintf(stderr, "TOO DEAR: %s\n", what.c_str());
        failed_ = true;
    }

private:
    static const Factor& factorOf(const std::string& reader) {
        // A telegram of a recording or a capture, or a line of a bag, may announce up to 2,000 lost lines before it; each becomes a line of
        // the sweep. A packed byte may become 64 bytes of text.
        static const std::map<std::string, Factor> some{
            {"mcap", {50'000, 5'000}}, {"capture", {50'000, 5'000}}, {"ros_bag", {50'000, 5'000}}, {"packed", {100'000, 10'000}}};
        static const Factor other{20'000, 2'000};
        const auto found = some.find(reader);
        return found == some.end() ? other : found->second;
    }
    std::map<std::string, Row> rows_;
    bool failed_ = false;
};

} // namespace

int main(int count, char** words) {
    const std::size_t bytes = 1024 * (count > 1 ? std::stoul(words[1]) : 128);
    const int rounds = count > 2 ? std::stoi(words[2]) : 4;
    Course course;
    for (const CostlyKind& kind : costlyKinds())
        course.run(kind.reader, kind.extension + (kind.extension.empty() ? "" : " ") + kind.name, kind.make(bytes));
    std::mt19937 random(2026);
    const int beams = 181;
    const int lines = std::max(8, static_cast<int>(bytes / 30) / beams);
    for (const SeedFile& seed : seedsOfEveryFuzzer(lines, beams)) {
        course.run(seed.reader, nameOf(seed, "a sweep"), seed.bytes);
        for (int round = 0; round < rounds; ++round)
            course.run(seed.reader, nameOf(seed, "a damaged sweep"), damaged(seed.bytes, random, round));
        course.run(seed.reader, nameOf(seed, "a sweep cut off"), seed.bytes.substr(0, random() % (seed.bytes.size() + 1)));
    }
    for (const auto& [name, fuzzer] : fuzzers()) {
        if (!course.covers(name)) course.fail(name + " was not run");
    }
    course.print();
    return course.failed() ? 1 : 0;
}
