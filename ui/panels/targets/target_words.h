// The facts of a target, in the order of its card.
#pragma once

#include "core/inspect/measure/cell_target.h"
#include "core/inspect/measure/near_side.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/attributes.h"
#include "ui/base/fact_row.h"

#include <QString>

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
    bool rocksKnown = false;           ///< false while they are computed
    const rocks::Rock* rock = nullptr; ///< the rock at the cell; null: no rock there, or rocks are hidden or not known
    QString source;                    ///< source of the picture, with its time
    ShownConfidence confidence{};
    QString clicked{};         ///< where the click was, if it was moved
    bool placePending = false; ///< another pose is being typed: what follows from the pose is not known
};

inline constexpr const char* kConfidenceRow = QT_TRANSLATE_NOOP("QObject", "Confidence"); ///< name of that row in files

/// "8.13 m behind an edge; measured on its near side, 2 cells away". Empty if the click was not moved and no
/// other surface is in front of it. Says so if `detection` has no edge there: settings can hide one, and a slip of
/// the stepper is not an edge.
[[nodiscard]] QString clickText(const inspect::ClickedCell& click, const edges::Detection& detection);
/// "jump", "no edge"; "edge" if the method has no classes.
[[nodiscard]] QString edgeText(const inspect::CellTarget& target);
/// "4.911 m", "no return".
[[nodiscard]] QString distanceText(const inspect::CellTarget& target);
/// "± 0.009"; empty if the cell is not valid.
[[nodiscard]] QString toleranceText(const inspect::CellTarget& target);
/// "E 498765.432  N 5150123.456  RL 287.654 m", without a pose "x 1.234  y 5.678  z 9.012 m"; empty if the cell is not valid.
[[nodiscard]] QString positionText(const inspect::CellTarget& target);
/// The same for one line of the list: mine coordinates in centimetres, without their unit. The card has all digits.
[[nodiscard]] QString briefPositionText(const inspect::CellTarget& target);
/// A row of the table of all targets: number, name, distance, X Y Z, E N RL, line, beam, note; tabs between the columns. `known`: null
/// before it is computed.
[[nodiscard]] QString tableRow(const inspect::PinnedTarget& target, const inspect::CellTarget* known);
/// Its heading, with units.
[[nodiscard]] QString tableHeading();
/// The three numbers of a place, metres.
[[nodiscard]] QStringList numbersOf(const Eigen::Vector3d& placeM);
/// All facts, the distance first. Of a cell without a range few are known.
[[nodiscard]] Facts targetFacts(const inspect::CellTarget& target, const TargetSurroundings& around);

} // namespace edgescan::ui
