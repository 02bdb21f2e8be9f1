// What is said of a target, row by row, in the order of its card.
#pragma once

#include "core/inspect/measure/cell_target.h"
#include "core/rocks/attributes/attributes.h"

#include <QString>

#include <vector>

namespace edgescan::ui {

/// How sure an edge is, as far as that is known.
struct ToldConfidence {
    enum class State { NotAsked, Coming, Growing, Large, Known };
    State state = State::NotAsked;
    int percent = 0;  ///< of the settings, those that find this edge too
    int settings = 0; ///< how many were tried
};

/// What a card says besides what was measured at the cell.
struct TargetSurroundings {
    bool rocksShown = false;
    const Rock* rock = nullptr; ///< that the cell lies on; null: none, or rocks are not shown
    QString source;             ///< of the picture, with its time
    ToldConfidence confidence{};
};

inline constexpr const char* kConfidenceRow = QT_TRANSLATE_NOOP("QObject", "Confidence"); ///< name of that row, where it is kept

struct TargetRow {
    QString name, value;
    QString tip{};
    bool measured = true; ///< it can be otherwise after a slider moved: then the card says what it was
    bool known = true;    ///< false: it is still to come, and nothing to keep
};

/// "4.911 m", "no return".
[[nodiscard]] QString distanceText(const CellTarget& target);
/// "± 0.009"; empty where the cell is not valid.
[[nodiscard]] QString toleranceText(const CellTarget& target);
/// All but the distance.
[[nodiscard]] std::vector<TargetRow> targetRows(const CellTarget& target, const TargetSurroundings& around);

} // namespace edgescan::ui
