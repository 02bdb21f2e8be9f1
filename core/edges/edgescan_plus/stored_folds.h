// Folds at every crease angle from stored numbers: a new angle measures nothing again.
#pragma once

#include "core/edges/edgescan_plus/crease.h"
#include "core/edges/edgescan_plus/roughness.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// Of the folds of a sweep, those that can be the strongest around at some crease angle, and the neighbours that can be stronger at
/// another one. All others are never edges. The ratio of two folds moves one way only with the angle, so the smallest and the largest
/// angle say which they are.
class StoredFolds {
public:
    static constexpr int kLeastDeg = 15, kMostDeg = 90; ///< the crease angles of the slider

    StoredFolds() = default;
    explicit StoredFolds(const Grid<Support>& support);

    /// Whether folds can be stored, and made at this crease angle: whole degrees, as the slider has them.
    [[nodiscard]] static bool covers(double creaseDeg, int beams);
    [[nodiscard]] std::size_t bytes() const;

    /// Writes the folds after suppression into the lines first <= line < last of `crease`, which are 0.
    void foldsAt(float creaseDeg, int first, int last, Grid<float>& crease) const;
    /// The cells that fold at this crease angle.
    [[nodiscard]] FoldingCells folding(float creaseDeg) const;

private:
    friend class FoldRecorder;
    using Cells = std::vector<std::uint16_t>; // beams of one line, ascending
    struct Line {
        Cells adding, alone; // whose fold counts at every angle: with a weaker fold of the other direction that adds, and without
        Cells open;          // that are compared at each angle ...
        Cells comparedBeams, comparedLines; // ... and what they are compared with, themselves included
        std::vector<float> parts;           // of the folds of `adding`, their weaker folds, `alone`, ...: all sizes, then `all`, ...
    };
    static void scatterFolds(const Line& at, float* strengths, int line, FoldStrengths& compared, float* crease);
    static void suppressOpen(const Cells& open, const FoldStrengths& compared, int line, std::vector<float>& work, Grid<float>& crease);

    Grid<std::uint8_t> degrees_; // the number of degrees from the least on at which a cell folds
    Grid<std::uint8_t> solid_;   // as in FoldingCells
    std::vector<Line> lines_;
};

/// Fills a StoredFolds while folds are measured. Lines come one after the other; several recorders may fill different lines.
class FoldRecorder {
public:
    /// Begins at line `from`; stores the lines first <= line < last.
    FoldRecorder(StoredFolds& stored, const Grid<Support>& support, int from, int first, int last);

    /// Takes the next line, and one more line behind the last one.
    void addLine(int line, const FoldPartLines& parts);

private:
    struct Way {
        Lines atLeast, atMost; // |S_C| at the least and at the most degrees
        void addLine(const FoldParts& parts, int beams);
    };
    void rank(int line, const FoldPartLines& parts);
    void store(int line, const FoldPartLines& parts);

    StoredFolds& stored_;
    const Grid<Support>& support_;
    int from_, first_, last_;
    Way alongBeams_, alongLines_;
    LineWindow<std::uint8_t> ranks_;
    std::vector<std::uint8_t> known_, marks_;
    std::vector<std::uint16_t> room_;
};

} // namespace edgescan::edges
