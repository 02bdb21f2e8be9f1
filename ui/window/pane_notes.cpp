// Notes of the panes.
#include "ui/window/pane_notes.h"

#include "ui/base/count_text.h"
#include "ui/base/pane.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/main_window.h"

#include <QStringList>

#include <cmath>

namespace edgescan::ui {
namespace {

/// "turned 90°, mirrored": of the images; empty as they are.
QString turnNote(const ViewPort& images) {
    const ViewPort::Turn& turn = images.turn();
    QStringList words;
    if (turn.degrees() > 0) words << Pane::tr("turned by %1°").arg(turn.degrees());
    if (turn.mirrored) words << Pane::tr("mirrored");
    return words.join(", ");
}

QString rangeNote(MainWindow& window) {
    const RangeSpan ranges = window.viewer().views.rangesShown();
    const int decimals = ranges.farM - ranges.nearM < 1.0 ? 2 : 1;
    QString note = Pane::tr("gray %1 to %2 m").arg(ranges.nearM, 0, 'f', decimals).arg(ranges.farM, 0, 'f', decimals);
    if (window.viewer().engine.picture()->source.growth.growing)
        note = Pane::tr("up to line %1").arg(window.viewer().engine.picture()->detection->scan->lines()) + " · " + note;
    return note;
}

QString edgeNote(MainWindow& window) {
    const LinkedViews& views = window.viewer().views;
    const OverlayEdges* instead = views.scene().insteadNow();
    const edges::Detection& detection = *views.shown()->detection;
    const std::size_t all = detection.edges->size();
    // In a comparison the shown edges come from two scans.
    const std::size_t shown = instead != nullptr && instead->overImageAsAsked && instead->cells.all ? instead->cells.all->size() : all;
    const QString edges = shown == all ? Pane::tr("%1 edge cells").arg(countText(all))
                                       : Pane::tr("%1 of %2 edge cells").arg(countText(shown), countText(all));
    if (instead != nullptr) return edges + " · " + instead->words;
    return views.edgesByClass() && detection.classes ? edges + " · " + Pane::tr("by class") : edges;
}

QString cloudNote(MainWindow& window) {
    const CloudView& cloud = window.viewer().views.cloud();
    if (!cloud.geometryOfCloud()) return {};
    const std::size_t all = window.viewer().views.shown()->cloud->validCount, shown = cloud.geometryOfCloud()->validCount;
    QString note =
        shown == all ? Pane::tr("%1 points").arg(countText(all)) : Pane::tr("%1 of %2 points").arg(countText(shown), countText(all));
    if (window.viewer().live.grows()) note += ", " + Pane::tr("growing");
    return note;
}

QString cloudRemark(const CloudView& cloud) {
    if (cloud.drawnFraction() < 1.0) return Pane::tr("%1 % of the points drawn").arg(std::lround(cloud.drawnFraction() * 100));
    return (cloud.isTurntable() ? Pane::tr("turntable") : Pane::tr("free rotation")) + " · " +
           (cloud.isParallel() ? Pane::tr("orthographic") : Pane::tr("perspective"));
}

/// Numbers and edges come with the picture of the whole.
void showCoarse(MainWindow& window, Pane& range, Pane& edges, Pane& cloud) {
    const bool coarse = window.viewer().engine.coarse() != nullptr;
    for (Pane* pane : {&range, &cloud}) pane->setNote(coarse ? Pane::tr("coarse picture") : QString());
    edges.setNote(coarse ? Pane::tr("edges pending") : QString());
    cloud.setRemark(coarse ? cloudRemark(window.viewer().views.cloud()) : QString());
}

} // namespace

void keepPaneNotes(MainWindow& window, Pane& range, Pane& edges, Pane& cloud) {
    const auto update = [&] {
        if (!window.viewer().engine.picture()) return showCoarse(window, range, edges, cloud);
        if (!window.viewer().views.shown()) return;
        range.setNote(rangeNote(window));
        edges.setNote(edgeNote(window));
        for (Pane* pane : {&range, &edges}) pane->setRemark(turnNote(*window.viewer().gray.viewPort()));
        cloud.setNote(cloudNote(window));
        cloud.setRemark(cloudRemark(window.viewer().views.cloud()));
    };
    QObject::connect(&window.viewer().views, &LinkedViews::picturesChanged, &window, update);
    QObject::connect(&window, &MainWindow::pictureShown, &window, update);
    QObject::connect(&window.viewer().engine, &Engine::coarseChanged, &window, update);
    QObject::connect(&window.viewer().live, &Live::growthChanged, &window, update);
    QObject::connect(window.viewer().gray.viewPort().get(), &ViewPort::turned, &window, update);
    CloudView& view = window.viewer().views.cloud();
    for (const auto changed : {&CloudView::parallelChanged, &CloudView::turntableChanged})
        QObject::connect(&view, changed, &window, update);
    QObject::connect(&view, &CloudView::pointsChanged, &window, update);
    QObject::connect(&view, &CloudView::drawnFractionChanged, &window, update);
}

} // namespace edgescan::ui
