// The meaning of each raw 16-bit count as a table: one look-up per cell, for any number of codes.
#pragma once

#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <span>

namespace edgescan {

inline constexpr std::size_t kCounts = 65536;

/// Valid for counts in neither list. A count in both lists is NoReturn. Codes that do not fit into 16 bits are ignored.
using CountStates = std::array<CellState, kCounts>;
[[nodiscard]] inline CountStates countStates(std::span<const std::uint32_t> noReturnCodes, std::span<const std::uint32_t> statusCodes) {
    CountStates states{};
    states.fill(CellState::Valid);
    for (const std::uint32_t code : statusCodes) {
        if (code < kCounts) states[code] = CellState::DeviceStatus;
    }
    for (const std::uint32_t code : noReturnCodes) {
        if (code < kCounts) states[code] = CellState::NoReturn;
    }
    return states;
}

} // namespace edgescan
