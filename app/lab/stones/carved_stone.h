// Stones with facets, scoops and scars that no scanned stone had: a lesson needs more surfaces than there are stones.
#pragma once

#include "app/lab/stones/stones.h"

#include <cstdint>

namespace edgescan::lab {

/// The stone without what is beyond two to six random planes and hollows, and with three to ten scars. Each point moves towards the
/// middle, so the triangles stay; a tenth of the old relief stays on the new surfaces. The name stays too.
[[nodiscard]] Stone carvedStone(const Stone& stone, std::uint64_t seed);

} // namespace edgescan::lab
