// The program's version.
#include "core/base/version.h"

namespace edgescan {

const char* version() { return EDGESCAN_VERSION; }

const char* commit() {
#ifdef EDGESCAN_COMMIT
    return EDGESCAN_COMMIT;
#else
    return "unknown";
#endif
}

} // namespace edgescan
