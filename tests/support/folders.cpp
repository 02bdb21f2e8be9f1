#include "tests/support/folders.h"

#include <cstdlib>

namespace edgescan::test {

std::string sourceFolder() { return EDGESCAN_SOURCE_DIR; }
std::string programFolder() { return EDGESCAN_BIN_DIR; }
std::string slowDiskLibrary() { return EDGESCAN_SLOW_DISK; }

std::filesystem::path sharedFolder() {
    const char* other = std::getenv("EDGESCAN_SHARED");
    return other != nullptr ? other : EDGESCAN_SHARED_DIR;
}

std::filesystem::path ownData() { return std::filesystem::path(EDGESCAN_SOURCE_DIR) / "tests/data"; }

} // namespace edgescan::test
