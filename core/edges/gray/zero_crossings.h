// The second-derivative detectors of the thesis's chapter 3: edges where the Laplacian changes its sign steeply enough.
#pragma once

#include "core/base/grid.h"
#include "core/edges/settings/settings.h"

#include <cstdint>

namespace edgescan::edges {

/// Correlation with one of the Laplacian masks of text books, in integer sums; lines x beams, borders repeated. A missing cell (255;
/// `missing` may be null) in the window counts as the window's centre and is 0 itself.
[[nodiscard]] Grid<float> laplacian(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, LogMask mask);

/// Marr and Hildreth (1980): Gaussian of `sigma` cells (no rounding to levels, 4 sigma wide), then the Laplacian 0 1 0 / 1 -4 1 / 0 1 0,
/// multiplied by sigma^3 sqrt(2 pi), so that the zero crossing of a straight step of n levels has about the slope n for every sigma.
/// Missing cells have weight 0 in the Gaussian.
[[nodiscard]] Grid<float> laplacianOfGaussian(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, double sigma);

/// Slope of the sign changes to the four neighbours, 0 elsewhere: the difference across the change. It is stored at the cell closer to zero
/// (the first of two equal ones), or at a cell that is exactly zero between opposite signs. A change towards a missing cell does not count.
[[nodiscard]] Grid<float> zeroCrossingSlope(const Grid<float>& laplacian, const Grid<std::uint8_t>* missing);

/// The two detectors: slopes of the zero crossings. `levels`: gray levels, unsmoothed for Marr-Hildreth; sigma or mask of the settings.
[[nodiscard]] Grid<float> marrHildrethResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing,
                                               const Settings& settings);
[[nodiscard]] Grid<float> logResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);

} // namespace edgescan::edges
