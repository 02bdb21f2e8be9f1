// Checks points at steps down the vertical.
#include "core/rocks/attributes/free_below.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan::rocks {
namespace {

constexpr double kStepM = 0.05;
constexpr double kMarginM = 0.05; // the measured range must be this much longer than the distance to the step
constexpr double kMostM = 30.0;
constexpr double kOffCells = 1.0; // largest distance, in cells, between the step and the nearest beam

// Finds the cell whose beam points best in a direction by moving from cell to cell. The angle to the direction decreases on the way, as it
// does on every grid of beams.
class BeamFinder {
public:
    BeamFinder(const Inputs& inputs, const CartesianTables& tables, std::size_t k)
        : inputs_(inputs), tables_(tables), line_(static_cast<int>(k / beams())), beam_(static_cast<int>(k % beams())) {}

    /// Returns false if no beam passes close enough.
    bool find(const Eigen::Vector3d& way) {
        double off = offOf(line_, beam_, way);
        for (bool moved = true; moved;) {
            moved = false;
            for (const auto& [i, j] :
                 {std::pair(line_ - 1, beam_), std::pair(line_ + 1, beam_), std::pair(line_, beam_ - 1), std::pair(line_, beam_ + 1)}) {
                if (!inputs_.scan->rangeMm.contains(i, j)) continue;
                const double there = offOf(i, j, way);
                if (!(there < off)) continue;
                off = there;
                line_ = i;
                beam_ = j;
                moved = true;
                break;
            }
        }
        const AngularSteps& steps = inputs_.surface->steps;
        const auto cell = static_cast<double>(std::max(steps.beam[static_cast<std::size_t>(beam_)], steps.lineAt(line_, beam_)));
        return off < kOffCells * cell;
    }
    [[nodiscard]] std::size_t cell() const { return inputs_.scan->rangeMm.index(line_, beam_); }

private:
    [[nodiscard]] std::size_t beams() const { return static_cast<std::size_t>(inputs_.scan->beams()); }
    [[nodiscard]] double offOf(int line, int beam, const Eigen::Vector3d& way) const {
        return (tables_.direction(line, beam) - way).norm();
    }

    const Inputs& inputs_;
    const CartesianTables& tables_;
    int line_, beam_;
};

} // namespace

double freeHeightM(const Inputs& inputs, const CartesianTables& tables, const Eigen::Vector3d& pointM, std::size_t k,
                   const Eigen::Vector3d& up) {
    BeamFinder finder(inputs, tables, k);
    double freeM = 0.0;
    while (freeM < kMostM) {
        const Eigen::Vector3d step = pointM - tables.sensor() - (freeM + kStepM) * up;
        const double awayM = step.norm();
        if (!(awayM > kMarginM) || !finder.find(step / awayM)) break;
        const std::size_t cell = finder.cell();
        if (inputs.surface->inverse.support[cell] != Support::Measured) break;
        if (0.001 * static_cast<double>(inputs.scan->rangeMm[cell]) <= awayM + kMarginM) break;
        freeM += kStepM;
    }
    return freeM;
}

} // namespace edgescan::rocks
