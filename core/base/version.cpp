// The program's version.
#include "core/base/version.h"

#include "edgescan_build.h" // made by CMake: version and commit

namespace edgescan {

const char* version() { return EDGESCAN_VERSION; }

const char* commit() { return EDGESCAN_COMMIT; }

} // namespace edgescan
