// Describes a target in words.
#include "ui/panels/targets/target_words.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/detection.h"
#include "ui/base/core_words.h"
#include "ui/base/shown_text.h"

#include <QObject>
#include <QStringList>

#include <cmath>

namespace edgescan::ui {
namespace {

QString fixed(double value, int decimals) { return exactText(fixedText(value, decimals)); }
QString triple(const Eigen::Vector3d& v) { return QStringLiteral("%1, %2, %3").arg(fixed(v.x(), 3), fixed(v.y(), 3), fixed(v.z(), 3)); }
QString noPose() { return QObject::tr("▲ no pose"); }
QString inMillimetres(double metres) { return QObject::tr("%1 mm").arg(fixed(std::ceil(1000.0 * metres - 1e-9), 0)); }

TargetRow placeRow(const inspect::CellTarget& target) {
    return {.name = QObject::tr("X, Y, Z"),
            .value = triple(target.probe.pointM),
            .tip = QObject::tr("Metres in the frame of the scan"),
            .unit = "m"};
}

TargetRow mineRow(const inspect::CellTarget& target) {
    return {.name = QObject::tr("E, N, RL"),
            .value = target.probe.mineM ? triple(*target.probe.mineM) : noPose(),
            .tip = QObject::tr("Easting, Northing and RL (height) in the mine grid, in metres"),
            .unit = target.probe.mineM ? "m" : ""};
}

TargetRow rockRow(const TargetSurroundings& around) {
    constexpr const char* kName = QT_TRANSLATE_NOOP("QObject", "Rock, visible");
    static_assert(std::string_view(kName) == inspect::kRockRow);
    const QString name = QObject::tr(kName);
    if (!around.rocksKnown) return {name, QObject::tr("being computed …"), {}, true, false};
    if (around.rock == nullptr) return {name, QObject::tr("none here"), QString()};
    const rocks::Rock& rock = *around.rock;
    return {name,
            QObject::tr("%1 × %2 ± %3 m") // without its number: this is stored, and numbers change with the rocks
                .arg(fixed(rock.longestCaliperM, 2), fixed(rock.shortestCaliperM, 2), fixed(shownTolerance(rock.toleranceM, 2), 2)),
            QObject::tr("Length a and width b of its visible part. Hidden parts are not included.")};
}

TargetRow resolvesRow(const inspect::CellTarget& target) {
    if (!target.resolution) return {QObject::tr("Resolves"), QObject::tr("not known"), QString()};
    return {
        QObject::tr("Resolves"), inMillimetres(target.resolution->smallestM()),
        QObject::tr("The smallest thing seen reliably here: %1 to the next beam, and a beam of %2 as an LMS511 has it in high resolution")
            .arg(inMillimetres(target.resolution->spacingM), inMillimetres(target.resolution->beamM))};
}

TargetRow surfaceRow(const inspect::CellTarget& target) {
    if (!target.surface) return {QObject::tr("Surface"), QObject::tr("no plane fits"), QString()};
    return {
        QObject::tr("Surface"),
        QObject::tr("%1° ± %2° off the beam")
            .arg(fixed(target.surface->offBeamDeg, 0), fixed(shownTolerance(inspect::kReportedSigmas * target.surface->sigmaDeg, 0), 0)),
        QObject::tr("Between its normal and the beam: 0° faces the scanner. A plane through %1 cells, relief %2")
            .arg(target.surface->cells)
            .arg(inMillimetres(target.surface->reliefM))};
}

TargetRow dipRow(const inspect::CellTarget& target) {
    const QString name = QObject::tr("Dip / direction");
    const QString tip = QObject::tr("Of the plane to the horizon, and clockwise from grid north the way it falls");
    if (!target.surface) return {name, QObject::tr("no plane fits"), tip};
    if (!target.dip) return {name, noPose(), tip};
    // A level surface has no dip direction: within its uncertainty it may dip in any direction.
    const bool falls = target.dip->dipDeg > inspect::kReportedSigmas * target.surface->sigmaDeg;
    return {name, QObject::tr("%1° / %2").arg(fixed(target.dip->dipDeg, 0), falls ? fixed(target.dip->directionDeg, 0) + "°" : "–"), tip};
}

TargetRow boomRow(const inspect::BoomAtCell& boom) {
    const QString distance = QObject::tr("%1 m").arg(fixed(boom.distanceM, 2));
    return {
        QObject::tr("From the boom"),
        boom.angleDeg ? QObject::tr("%1 · surface %2° off square").arg(distance, fixed(*boom.angleDeg, 0)) : distance,
        QObject::tr("To the straight line from the boom's pivot to the head, where they were when this was measured; 0° off square: the "
                    "boom points straight at the surface")};
}

TargetRow cellRow(const inspect::CellTarget& target) {
    TargetRow row{QObject::tr("Cell"), QObject::tr("line %1 · beam %2").arg(target.probe.line).arg(target.probe.beam), QString(), false};
    if (!std::isnan(target.probe.beamDeg))
        row.tip = QObject::tr("Line angle %1°, beam angle %2°").arg(fixed(target.probe.lineDeg, 3), fixed(target.probe.beamDeg, 3));
    return row;
}

TargetRow edgeRow(const inspect::CellTarget& target) {
    QString value = edgeText(target);
    if (target.strength) value += QObject::tr(", strength %1").arg(shownText(edges::strengthNumber(*target.strength)));
    return {QObject::tr("Edge"), value, QObject::tr("Strength 1 is at the threshold; Why says more")};
}

/// For edge cells only: the value of the confidence picture.
TargetRow confidenceRow(const ShownConfidence& confidence) {
    using State = ShownConfidence::State;
    TargetRow row{
        QObject::tr(kConfidenceRow), QStringLiteral("…"),
        QObject::tr(
            "Share of nearby settings that find this edge too, computed after each change. It shows how much the edge depends on the "
            "settings, not whether a rock is there.")};
    row.known = confidence.state == State::Known;
    if (row.known) row.value = QObject::tr("%1 % of %2 settings").arg(confidence.percent).arg(confidence.settings);
    if (confidence.state == State::Growing) row.value = QObject::tr("when the sweep has ended");
    if (confidence.state == State::Large) row.value = QObject::tr("large scan: show Edge Confidence");
    return row;
}

} // namespace

namespace {

QString moveText(const inspect::ClickedCell& click, const edges::Detection& detection) {
    switch (click.reason) {
    case inspect::SnapReason::AsClicked:
        return {};
    case inspect::SnapReason::BehindAnEdge:
        if (!edges::nearestEdge(*detection.mask, click.cell, inspect::kSnapReach + 1))
            return QObject::tr(
                       "%1 m behind a jump where no edge is drawn (a slip of the stepper looks the same); measured on its near side")
                .arg(fixed(click.nearerM, 2));
        return QObject::tr("%1 m behind an edge; measured on its near side").arg(fixed(click.nearerM, 2));
    case inspect::SnapReason::MixedPixel:
        return QObject::tr("a beam between two surfaces; measured on the nearer one");
    case inspect::SnapReason::Dust:
        return QObject::tr("one echo in front of all around it, as from dust; measured at the nearest cell behind it");
    case inspect::SnapReason::NoRange:
        break;
    }
    return click.moved() ? QObject::tr("nothing was measured there; measured at the nearest cell")
                         : QObject::tr("nothing was measured within %1 cells").arg(inspect::kSnapReach);
}

} // namespace

QString clickText(const inspect::ClickedCell& click, const edges::Detection& detection) {
    QString text = moveText(click, detection);
    if (!click.alsoNear) return text;
    if (!text.isEmpty()) text += "; ";
    return text + QObject::tr("▲ a nearer surface is also within %1 cells: zoom in if that was meant").arg(inspect::kSnapReach);
}

QString edgeText(const inspect::CellTarget& target) {
    if (!target.probe.edge) return QObject::tr("no edge");
    return target.probe.kind == edges::DepthEdge::None ? QObject::tr("edge") : QObject::tr(edges::edgeClassLabel(target.probe.kind));
}

QString distanceText(const inspect::CellTarget& target) {
    if (target.probe.state == CellState::Valid) return QObject::tr("%1 m").arg(fixed(target.distanceM, 3));
    return cellStateText(target.probe.state);
}

QString toleranceText(const inspect::CellTarget& target) {
    if (target.probe.state != CellState::Valid) return {};
    return target.toleranceM > 0.0 ? QStringLiteral("± %1 m").arg(fixed(shownTolerance(target.toleranceM, 3), 3))
                                   : QObject::tr("± not known");
}

QString positionText(const inspect::CellTarget& target) {
    if (target.probe.state != CellState::Valid) return {};
    const Eigen::Vector3d& at = target.probe.mineM ? *target.probe.mineM : target.probe.pointM;
    return (target.probe.mineM ? QObject::tr("E %1  N %2\nRL %3 m") : QObject::tr("x %1  y %2  z %3 m"))
        .arg(fixed(at.x(), 3), fixed(at.y(), 3), fixed(at.z(), 3));
}

QString briefPositionText(const inspect::CellTarget& target) {
    if (target.probe.state != CellState::Valid || !target.probe.mineM) return positionText(target);
    const Eigen::Vector3d& at = *target.probe.mineM;
    return QObject::tr("E %1 N %2 RL %3").arg(fixed(at.x(), 2), fixed(at.y(), 2), fixed(at.z(), 2));
}

QString tableHeading() {
    return QStringList{QObject::tr("Target"),
                       QObject::tr("Name"),
                       QObject::tr("Distance [m]"),
                       "± [m]",
                       "X [m]",
                       "Y [m]",
                       "Z [m]",
                       "E [m]",
                       "N [m]",
                       "RL [m]",
                       QObject::tr("Line"),
                       QObject::tr("Beam"),
                       QObject::tr("Edge"),
                       QObject::tr("Note")}
        .join('\t');
}

QString tableRow(const inspect::PinnedTarget& pinned, const inspect::CellTarget* target) {
    QStringList row{QString::number(pinned.number), shownName(exactText(pinned.name))};
    const bool some = target != nullptr && target->probe.state == CellState::Valid;
    const auto add = [&](bool known, double metres) { row << (known ? fixed(metres, 3) : QString()); };
    add(some, some ? target->distanceM : 0.0);
    add(some && target->toleranceM > 0.0, some ? shownTolerance(target->toleranceM, 3) : 0.0);
    for (int axis = 0; axis < 3; ++axis) add(some, some ? target->probe.pointM[axis] : 0.0);
    const bool placed = some && target->probe.mineM;
    for (int axis = 0; axis < 3; ++axis) add(placed, placed ? (*target->probe.mineM)[axis] : 0.0);
    for (const bool line : {true, false})
        row << (target == nullptr ? QString() : QString::number(line ? target->probe.line : target->probe.beam));
    row << (target == nullptr ? QString() : edgeText(*target));
    row << shownName(exactText(pinned.note), static_cast<int>(inspect::kLongestTargetNote));
    return row.join('\t');
}

std::vector<TargetRow> targetRows(const inspect::CellTarget& target, const TargetSurroundings& around) {
    std::vector<TargetRow> rows;
    if (!around.clicked.isEmpty())
        rows.push_back({QObject::tr("Clicked"), around.clicked,
                        QObject::tr("A click near an edge means its near side; with Shift it means the very cell"), false});
    if (target.probe.state == CellState::Valid) {
        rows.push_back({QObject::tr("from"), QObject::tr("scanner, line of sight"), QString(), false});
        rows.push_back(placeRow(target));
        const auto addPlaced = [&](TargetRow row) {
            row.known = !around.placePending;
            if (!row.known) row.value = QStringLiteral("…");
            rows.push_back(std::move(row));
        };
        addPlaced(mineRow(target));
        if (around.rocksShown) rows.push_back(rockRow(around));
        rows.push_back(resolvesRow(target));
        rows.push_back(surfaceRow(target));
        addPlaced(dipRow(target));
        if (target.boom) addPlaced(boomRow(*target.boom));
    }
    rows.push_back(cellRow(target));
    rows.push_back(edgeRow(target));
    if (target.probe.edge && around.confidence.state != ShownConfidence::State::NotAsked) rows.push_back(confidenceRow(around.confidence));
    rows.push_back({QObject::tr("Picture"), around.source, QString(), false});
    return rows;
}

} // namespace edgescan::ui
