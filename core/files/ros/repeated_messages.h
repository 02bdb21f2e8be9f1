// Messages that a bag holds twice, as where two recorders or a relay wrote them.
#pragma once

#include "core/containers/ros/bag.h"

namespace edgescan::files {

/// The bag with each message of lines, clouds, transforms and joints once. A warning counts the others by topic, but for transforms that
/// never change: their topic (tf_static) is sent again and again.
[[nodiscard]] containers::RosBag onceEach(containers::RosBag bag);

} // namespace edgescan::files
