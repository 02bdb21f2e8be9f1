// The folder `shared` next to the project: scans and telegrams of others, which do not belong to it. What must hold in every clone is also
// tested with files of the project's own (tests/data).
#pragma once

#include "tests/support/folders.h"

#define EDGESCAN_NEEDS_SHARED(what)                                                                                                        \
    if (!std::filesystem::exists(edgescan::test::sharedFolder() / (what)))                                                                 \
    GTEST_SKIP() << "needs " << (what) << " in the folder \"shared\" beside the project, which is not there"
