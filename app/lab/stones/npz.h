// Arrays of numbers in NPZ files: a ZIP archive of NPY files (numpy.lib.format).
#pragma once

#include "core/base/grid.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace edgescan::lab {

/// Floating-point numbers in 3 columns, as points. Error: no such array, damaged, another type, a number that is not finite.
Result<std::vector<Eigen::Vector3f>> npzPoints(std::span<const std::byte> file, const std::string& array, const std::string& where);

/// Whole numbers in 3 columns, each from 0 to below `end`. Error: as npzPoints(), or another number.
Result<std::vector<std::array<std::int32_t, 3>>> npzTriples(std::span<const std::byte> file, const std::string& array, std::size_t end,
                                                            const std::string& where);

/// Whole numbers from 0 to 65535, lines x beams. Error: as npzPoints(), or another number.
Result<Grid<std::uint16_t>> npzGrid(std::span<const std::byte> file, const std::string& array, const std::string& where);

} // namespace edgescan::lab
