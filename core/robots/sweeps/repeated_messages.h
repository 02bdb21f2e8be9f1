// Messages that a bag holds twice, as where two recorders or a relay wrote them.
#pragma once

#include "core/robots/bags/bag.h"

namespace edgescan::robots {

/// The bag with each message of lines, clouds, transforms and joints once. A warning counts the others by topic, but for transforms that
/// never change: their topic (tf_static) is sent again and again.
[[nodiscard]] RosBag onceEach(RosBag bag);

} // namespace edgescan::robots
