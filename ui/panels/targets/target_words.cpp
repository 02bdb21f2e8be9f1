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
QString noPose() { return QObject::tr("▲ no pose"); }
QString inMillimetres(double metres) { return QObject::tr("%1 mm").arg(fixed(std::ceil(1000.0 * metres - 1e-9), 0)); }

Fact placeRow(const inspect::CellTarget& target) {
    return {.key = "place",
            .name = QObject::tr("X, Y, Z"),
            .value = numbersOf(target.probe.pointM).join(", "),
            .tip = QObject::tr("Metres in the frame of the scan"),
            .unit = "m",
            .numbers = numbersOf(target.probe.pointM)};
}

Fact mineRow(const inspect::CellTarget& target) {
    return {.key = "mine",
            .name = QObject::tr("E, N, RL"),
            .value = target.probe.mineM ? numbersOf(*target.probe.mineM).join(", ") : noPose(),
            .tip = QObject::tr("Easting, Northing and RL (height) in the mine grid, in metres"),
            .unit = target.probe.mineM ? "m" : "",
            .numbers = target.probe.mineM ? numbersOf(*target.probe.mineM) : QStringList()};
}

Fact rockRow(const TargetSurroundings& around) {
    constexpr const char* kName = QT_TRANSLATE_NOOP("QObject", "Rock, visible");
    static_assert(std::string_view(kName) == inspect::kRockRow);
    const QString name = QObject::tr(kName);
    if (!around.rocksKnown) return {.key = "rock", .name = name, .value = QObject::tr("being computed …"), .known = false};
    if (around.rock == nullptr) return {"rock", name, QObject::tr("none here")};
    const rocks::Rock& rock = *around.rock;
    return {.key = "rock",
            .name = name,
            .value =
                QObject::tr("%1 × %2 ± %3 m") // without its number: this is stored, and numbers change with the rocks
                    .arg(fixed(rock.longestCaliperM, 2), fixed(rock.shortestCaliperM, 2), fixed(shownTolerance(rock.toleranceM, 2), 2)),
            .tip = QObject::tr("Length a and width b of its visible part. Hidden parts are not included.")};
}

Fact resolvesRow(const inspect::CellTarget& target) {
    if (!target.resolution) return {"resolves", QObject::tr("Resolves"), QObject::tr("not known")};
    return {.key = "resolves",
            .name = QObject::tr("Resolves"),
            .value = inMillimetres(target.resolution->smallestM()),
            .tip =
                QObject::tr(
                    "The smallest thing seen reliably here: %1 to the next beam, and a beam of %2 as an LMS511 has it in high resolution")
                    .arg(inMillimetres(target.resolution->spacingM), inMillimetres(target.resolution->beamM))};
}

Fact surfaceRow(const inspect::CellTarget& target) {
    if (!target.surface) return {"surface", QObject::tr("Surface"), QObject::tr("no plane fits")};
    return {.key = "surface",
            .name = QObject::tr("Surface"),
            .value = QObject::tr("%1° ± %2° off the beam")
                         .arg(fixed(target.surface->offBeamDeg, 0),
                              fixed(shownTolerance(inspect::kReportedSigmas * target.surface->sigmaDeg, 0), 0)),
            .tip = QObject::tr("Between its normal and the beam: 0° faces the scanner. A plane through %1 cells, relief %2")
                       .arg(target.surface->cells)
                       .arg(inMillimetres(target.surface->reliefM))};
}

Fact dipRow(const inspect::CellTarget& target) {
    Fact fact{.key = "dip",
              .name = QObject::tr("Dip / direction"),
              .value = target.surface ? noPose() : QObject::tr("no plane fits"),
              .tip = QObject::tr("Of the plane to the horizon, and clockwise from grid north the way it falls")};
    if (!target.surface || !target.dip) return fact;
    // A level surface has no dip direction: within its uncertainty it may dip in any direction.
    const bool falls = target.dip->dipDeg > inspect::kReportedSigmas * target.surface->sigmaDeg;
    fact.value = QObject::tr("%1° / %2").arg(fixed(target.dip->dipDeg, 0), falls ? fixed(target.dip->directionDeg, 0) + "°" : "–");
    return fact;
}

Fact boomRow(const inspect::BoomAtCell& boom) {
    const QString distance = QObject::tr("%1 m").arg(fixed(boom.distanceM, 2));
    return {.key = "boom",
            .name = QObject::tr("From the boom"),
            .value = boom.angleDeg ? QObject::tr("%1 · surface %2° off square").arg(distance, fixed(*boom.angleDeg, 0)) : distance,
            .tip = QObject::tr(
                "To the straight line from the boom's pivot to the head, where they were when this was measured; 0° off square: the "
                "boom points straight at the surface")};
}

Fact cellRow(const inspect::CellTarget& target) {
    Fact row{.key = "cell",
             .name = QObject::tr("Cell"),
             .value = QObject::tr("line %1 · beam %2").arg(target.probe.line).arg(target.probe.beam),
             .measured = false};
    if (!std::isnan(target.probe.beamDeg))
        row.tip = QObject::tr("Line angle %1°, beam angle %2°").arg(fixed(target.probe.lineDeg, 3), fixed(target.probe.beamDeg, 3));
    return row;
}

Fact edgeRow(const inspect::CellTarget& target) {
    QString value = edgeText(target);
    if (target.strength) value += QObject::tr(", strength %1").arg(shownText(edges::strengthNumber(*target.strength)));
    return {
        .key = "edge", .name = QObject::tr("Edge"), .value = value, .tip = QObject::tr("Strength 1 is at the threshold; Why says more")};
}

/// For edge cells only: the value of the confidence picture.
Fact confidenceRow(const ShownConfidence& confidence) {
    using State = ShownConfidence::State;
    Fact row{.key = "confidence",
             .name = QObject::tr(kConfidenceRow),
             .value = QStringLiteral("…"),
             .tip = QObject::tr(
                 "Share of nearby settings that find this edge too, computed after each change. It shows how much the edge depends on the "
                 "settings, not whether a rock is there.")};
    row.known = confidence.state == State::Known;
    if (row.known) row.value = QObject::tr("%1 % of %2 settings").arg(confidence.percent).arg(confidence.settings);
    if (confidence.state == State::Growing) row.value = QObject::tr("when the sweep has ended");
    if (confidence.state == State::Large) row.value = QObject::tr("large scan: show Edge Confidence");
    return row;
}

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

QStringList numbersOf(const Eigen::Vector3d& placeM) { return {fixed(placeM.x(), 3), fixed(placeM.y(), 3), fixed(placeM.z(), 3)}; }

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
    const QStringList at = numbersOf(target.probe.mineM.value_or(target.probe.pointM));
    return (target.probe.mineM ? QObject::tr("E %1  N %2\nRL %3 m") : QObject::tr("x %1  y %2  z %3 m")).arg(at[0], at[1], at[2]);
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
    row << (some ? fixed(target->distanceM, 3) : QString())
        << (some && target->toleranceM > 0.0 ? fixed(shownTolerance(target->toleranceM, 3), 3) : QString());
    for (const Fact& fact : some ? Facts{placeRow(*target), mineRow(*target)} : Facts(2, Fact{""}))
        row << (fact.numbers.isEmpty() ? QStringList{"", "", ""} : fact.numbers);
    for (const bool line : {true, false})
        row << (target == nullptr ? QString() : QString::number(line ? target->probe.line : target->probe.beam));
    row << (target == nullptr ? QString() : edgeText(*target));
    row << shownName(exactText(pinned.note), static_cast<int>(inspect::kLongestTargetNote));
    return row.join('\t');
}

Facts targetFacts(const inspect::CellTarget& target, const TargetSurroundings& around) {
    const bool valid = target.probe.state == CellState::Valid;
    Facts facts{{.key = "distance",
                 .name = QObject::tr("Distance"),
                 .value = distanceText(target),
                 .tolerance = toleranceText(target),
                 .tip = QObject::tr("Two standard deviations of the noise of this scan along the beam. Errors that the scanner makes "
                                    "everywhere are not included.")}};
    if (!around.clicked.isEmpty())
        facts.push_back({.key = "clicked",
                         .name = QObject::tr("Clicked"),
                         .value = around.clicked,
                         .tip = QObject::tr("A click near an edge means its near side; with Shift it means the very cell"),
                         .measured = false});
    if (valid) {
        facts.push_back({.key = "from", .name = QObject::tr("from"), .value = QObject::tr("scanner, line of sight"), .measured = false});
        facts.push_back(placeRow(target));
        const auto addPlaced = [&](Fact fact) {
            fact.known = !around.placePending;
            if (!fact.known) fact.value = QStringLiteral("…");
            for (QString& each : fact.numbers) each = fact.known ? each : fact.value;
            facts.push_back(std::move(fact));
        };
        addPlaced(mineRow(target));
        if (around.rocksShown) facts.push_back(rockRow(around));
        facts.push_back(resolvesRow(target));
        facts.push_back(surfaceRow(target));
        addPlaced(dipRow(target));
        if (target.boom) addPlaced(boomRow(*target.boom));
    }
    facts.push_back(cellRow(target));
    facts.push_back(edgeRow(target));
    if (target.probe.edge && around.confidence.state != ShownConfidence::State::NotAsked) facts.push_back(confidenceRow(around.confidence));
    facts.push_back({.key = "picture", .name = QObject::tr("Picture"), .value = around.source, .measured = false});
    return facts;
}

} // namespace edgescan::ui
