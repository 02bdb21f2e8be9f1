// The stages of the gray method on the rows that changed, exactly as the whole method gives them.
// All sums are whole numbers (or sixteenths) below 2^24, which floats hold exactly: rows are plain loops that compilers make wide.
#pragma once

#include "core/base/grid.h"
#include "core/live/live_hysteresis.h"
#include "core/settings/settings.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// Rows [first, gray.lines) of `smoothed` anew, which gets as many rows as `gray`. `masked`: 255 = takes no part, null = all do.
void smoothRows(Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>& gray, const Grid<std::uint8_t>* masked, const Settings& settings,
                int first);

/// Gradients of the last rows of a growing image. A value.
class GradientRows {
public:
    explicit GradientRows(int beams = 0) : beams_(beams) {}

    /// Rows [first, smoothed.lines) anew; rows before `kept` are not needed any more.
    void update(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>* masked, const Settings& settings, int first, int kept);

    /// What non-maximum suppression leaves of rows [first, end): Weak above the lower, Strong above the upper threshold.
    [[nodiscard]] Grid<EdgeClass> classes(const Settings& settings, int first) const;

private:
    struct Row {
        std::vector<std::int16_t> alongBeams, alongLines; ///< d gray / d beam, d gray / d line
        std::vector<std::int32_t> magnitude;              ///< a zero on either side of the beams

        void take(const std::vector<float>& dx, const std::vector<float>& dy, Norm norm);
    };
    [[nodiscard]] const std::vector<std::int32_t>& magnitudeOf(int row) const;

    int beams_;
    int firstRow_ = 0; ///< of rows_
    std::vector<Row> rows_;
    std::vector<std::int32_t> beyond_; ///< the magnitude of a row outside the image
};

} // namespace edgescan
