// The sources of scenes, one row each.
#pragma once

#include "app/lab/families/families.h"

namespace edgescan::lab {

extern const SceneSource kRealStones, kPolar, kRescans, kSimulator, kKinect, kCorridors;

} // namespace edgescan::lab
