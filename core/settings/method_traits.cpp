// What sets the methods apart.
#include "core/settings/method_traits.h"

namespace edgescan {

bool hasOneThreshold(Method method) {
    switch (method) {
    case Method::Roberts:
    case Method::Sobel:
    case Method::Prewitt:
    case Method::Kirsch:
    case Method::Robinson:
    case Method::MarrHildreth:
    case Method::Log:
        return true;
    default:
        return false;
    }
}

bool smoothsItself(Method method) { return method == Method::MarrHildreth; }

} // namespace edgescan
