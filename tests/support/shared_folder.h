// The folder `shared` next to the project: scans and telegrams of others, which do not belong to it. What must hold in every clone is also
// tested with files of the project's own (tests/data).
#pragma once

#include <cstdlib>
#include <filesystem>

namespace edgescan::test {

/// EDGESCAN_SHARED names another one; where that does not exist, tests run as in a clone without it.
inline std::filesystem::path sharedFolder() {
    const char* other = std::getenv("EDGESCAN_SHARED");
    return other != nullptr ? other : EDGESCAN_SHARED_DIR;
}

/// Files of the project's own.
inline std::filesystem::path ownData() { return std::filesystem::path(EDGESCAN_SOURCE_DIR) / "tests/data"; }

} // namespace edgescan::test

#define EDGESCAN_NEEDS_SHARED(what)                                                                                                        \
    if (!std::filesystem::exists(edgescan::test::sharedFolder() / (what)))                                                                 \
    GTEST_SKIP() << "needs " << (what) << " in the folder \"shared\" beside the project, which is not there"
