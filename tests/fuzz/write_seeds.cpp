// Writes the seeds: edgescan_fuzz_seeds FOLDER creates FOLDER/NAME_fuzz/seed-N for every fuzzer.
#include "tests/support/seed_files.h"

int main(int count, char** words) {
    if (count != 2) return 2;
    std::size_t number = 0;
    for (const auto& seed : edgescan::test::seedsOfEveryFuzzer()) {
        const auto folder = std::filesystem::path(words[1]) / (seed.reader + "_fuzz");
        std::filesystem::create_directories(folder);
        edgescan::test::writeText(folder / ("seed-" + std::to_string(number++)), seed.bytes);
    }
    return 0;
}
