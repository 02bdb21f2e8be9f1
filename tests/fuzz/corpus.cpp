// Runs the seeds, the inputs found so far (tests/fuzz/found/NAME_fuzz/*) and damaged seeds through every fuzzer. It does not need
// libFuzzer, so it works with every compiler's sanitizers, with the same inputs each time.
#include "tests/support/damage.h"
#include "tests/support/folders.h"
#include "tests/support/seed_files.h"

#include <cstdint>
#include <cstdio>
#include <map>
#include <random>

#define EDGESCAN_FUZZER(name) extern "C" int name(const std::uint8_t* bytes, std::size_t size);
#include "fuzzers.inc"
#undef EDGESCAN_FUZZER

namespace {

using Fuzzer = int (*)(const std::uint8_t*, std::size_t);

const std::map<std::string, Fuzzer>& fuzzers() {
    static const std::map<std::string, Fuzzer> all{
#define EDGESCAN_FUZZER(name) {#name, name},
#include "fuzzers.inc"
#undef EDGESCAN_FUZZER
    };
    return all;
}

void feed(Fuzzer fuzzer, const std::string& bytes) {
    // A copy of exactly this size: sanitizers detect a read behind its end.
    const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
    fuzzer(exact.data(), exact.size());
}

} // namespace

int main(int count, char** words) {
    using namespace edgescan::test;
    const int rounds = count > 1 ? std::stoi(words[1]) : 60;
    std::map<std::string, int> runs;
    std::mt19937 random(2026);
    for (const SeedFile& seed : seedsOfEveryFuzzer()) {
        const std::string name = seed.reader + "_fuzz";
        const auto fuzzer = fuzzers().find(name);
        if (fuzzer == fuzzers().end()) {
            std::fprintf(stderr, "there is a seed for %s and no such fuzzer\n", name.c_str());
            return 1;
        }
        feed(fuzzer->second, seed.bytes);
        for (int round = 0; round < rounds; ++round) feed(fuzzer->second, damaged(seed.bytes, random, round));
        for (int cut = 0; cut < rounds; ++cut) feed(fuzzer->second, seed.bytes.substr(0, random() % (seed.bytes.size() + 1)));
        runs[name] += 1 + 2 * rounds;
    }
    for (const auto& [name, fuzzer] : fuzzers()) {
        feed(fuzzer, "");
        ++runs[name];
        const std::filesystem::path found = std::filesystem::path(sourceFolder()) / "tests/fuzz/found" / name;
        if (!std::filesystem::exists(found)) continue;
        for (const auto& file : std::filesystem::directory_iterator(found)) {
            feed(fuzzer, readText(file.path()));
            ++runs[name];
        }
    }
    for (const auto& [name, number] : runs) std::printf("%-20s %d inputs\n", name.c_str(), number);
    for (const auto& [name, number] : runs) {
        if (number > 1) continue;
        std::fprintf(stderr, "%s has no seed\n", name.c_str());
        return 1;
    }
    return 0;
}
