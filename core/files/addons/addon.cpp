// The one add-on of a build.
#include "core/files/addons/addon.h"

namespace edgescan::files {
namespace {

Addon& registered() {
    static Addon one;
    return one;
}

} // namespace

const Addon& addon() { return registered(); }

RegisteredAddon::RegisteredAddon(const Addon& added) { registered() = added; }

} // namespace edgescan::files
