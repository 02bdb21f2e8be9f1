// Every refusal names the file and the remedy: seeds of every reader, damaged and truncated, and the deliberately broken files of
// ../shared.
#include "core/files/open_save/open_scan.h"
#include "tests/support/damage.h"
#include "tests/support/seed_files.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// Refusals by their text without numbers: a sample of each is printed if one is wrong.
void expectWhole(const Error& error, const std::filesystem::path& file) {
    SCOPED_TRACE(error.sentence());
    EXPECT_FALSE(error.what.empty());
    EXPECT_NE(error.where.find(file.stem().string()), std::string::npos) << "the file is not named"; // or the file next to it
    EXPECT_FALSE(error.hint.empty()) << "no way out";
    EXPECT_EQ(error.sentence().find('\n'), std::string::npos);
}

bool isOpened(const SeedFile& seed) { return seed.reader != "session" && seed.reader != "place" && seed.reader != "scan_telegram"; }

} // namespace

TEST(Refusals, NameTheFileAndTheWayOut) {
    const Folder folder;
    std::mt19937 random(17);
    std::map<std::string, int> refused;
    for (const SeedFile& seed : seedsOfEveryFuzzer()) {
        if (!isOpened(seed)) continue;
        const std::filesystem::path file = folder / ("broken" + seed.extension);
        for (int round = 0; round < 60; ++round) {
            const std::string bytes =
                round % 3 == 0 ? seed.bytes.substr(0, random() % (seed.bytes.size() + 1)) : damaged(seed.bytes, random, round);
            writeText(file, bytes);
            const auto scan = openScan(file, seedOptions());
            if (scan) continue;
            ++refused[seed.reader];
            expectWhole(scan.error(), file);
            if (HasFailure()) return; // the first one is enough
        }
    }
    EXPECT_GE(refused.size(), 12U);
}

TEST(Refusals, OfFilesBrokenOnPurposeLikewise) {
    EDGESCAN_NEEDS_SHARED("data/hostile");
    std::size_t refused = 0;
    for (const char* folder : {"data/hostile", "data/e57", "data/traps"}) {
        const std::filesystem::path files = edgescan::test::sharedFolder() / folder;
        if (!std::filesystem::exists(files)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(files)) {
            if (!entry.is_regular_file()) continue;
            const auto scan = openScan(entry.path());
            if (scan) continue;
            ++refused;
            expectWhole(scan.error(), entry.path());
        }
    }
    EXPECT_GT(refused, 10U);
}
