// The program's version.
#include "core/base/version.h"

namespace edgescan {

const char* version() { return EDGESCAN_VERSION; }

} // namespace edgescan
