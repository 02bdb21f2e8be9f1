// What each raw count of 16 bits means, as a table: a look-up per cell, however many codes there are.
#pragma once

#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>
#include <span>

namespace edgescan {

inline constexpr std::size_t kCounts = 65536;

/// Valid where neither list names the count; no return wins over a status. Codes that 16 bits cannot hold mean nothing here.
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
