// The wish that a thread is bound to.
#include "core/base/stop.h"

namespace edgescan {
namespace {

thread_local const std::atomic<bool>* wished = nullptr;

} // namespace

BindStop::BindStop(const std::atomic<bool>& wish) { wished = &wish; }
BindStop::~BindStop() { wished = nullptr; }

bool isStopWished() { return wished != nullptr && *wished; }

} // namespace edgescan
