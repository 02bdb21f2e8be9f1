// Finds steps at the ends of a sweep at which the stepper still went the other way (docs/method/edges.md, "Interlaced beams and slips").
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// `lines` values, 1 at the steps from a line to the next one at which the stepper turned: from the end of the sweep up to the last step
/// before it went at its speed. A motor that is started before the recording, or stopped after it, swings back: every slanted surface of
/// these lines then has a fold, which is none. It is proved by steps of -0.5 and less, on which most of the slanted cells agree. Empty if
/// the stepper did not turn.
[[nodiscard]] std::vector<std::uint8_t> turnedSteps(const InverseRange& inverse);

} // namespace edgescan
