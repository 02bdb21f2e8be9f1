// The rows of a target's card, in order.
#pragma once

#include "core/inspect/measure/cell_target.h"
#include "core/inspect/measure/near_side.h"
#include "core/rocks/attributes/attributes.h"

#include <QString>

#include <vector>

namespace edgescan::ui {

/// The confidence of an edge, if it is known.
struct ShownConfidence {
    enum class State { NotAsked, Coming, Growing, Large, Known };
    State state = State::NotAsked;
    int percent = 0;  ///< share of the tried settings that find this edge too
    int settings = 0; ///< number of tried settings
};

/// Data of a card that was not measured at the cell itself.
struct TargetSurroundings {
    bool rocksShown = false;
    const rocks::Rock* rock = nullptr; ///< the rock at the cell; null: no rock there, or rocks are hidden
    QString source;                    ///< source of the picture, with its time
    ShownConfidence confidence{};
    QString clicked{}; ///< where the click was, if it was moved
};

inline constexpr const char* kConfidenceRow = QT_TRANSLATE_NOOP("QObject", "Confidence"); ///< name of that row in files

struct TargetRow {
    QString name, value;
    QString tip{};
    bool measured = true; ///< a slider can change it: then the card also shows the earlier value
    bool known = true;    ///< false: not computed yet, not to be stored
};

/// "8.13 m behind an edge; measured on its near side, 2 cells away". Empty if the click was not moved and no
/// other surface is in front of it.
[[nodiscard]] QString clickText(const inspect::MeantCell& click);
/// "4.911 m", "no return".
[[nodiscard]] QString distanceText(const inspect::CellTarget& target);
/// "± 0.009"; empty if the cell is not valid.
[[nodiscard]] QString toleranceText(const inspect::CellTarget& target);
/// All rows except the distance.
[[nodiscard]] std::vector<TargetRow> targetRows(const inspect::CellTarget& target, const TargetSurroundings& around);

} // namespace edgescan::ui
