// What the window shows of a picture: images, cloud, the cell under the cursor, display levels.
#include "ui/main/main_window.h"

#include "core/georef/placed_points.h"
#include "core/straighten/straighten_scan.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/cloud/cloud_view.h"
#include "ui/image/image_view.h"
#include "ui/image/viewport.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/status_line.h"
#include "ui/session/edge_counts.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr double kUsualPointSize = 2.0;
constexpr double kLargestPointSize = 5.0;

// So large that a sparse scan is a surface and not a haze.
double pointSizeFor(const CloudView& view, const CloudGeometry& cloud) {
    const double pixels =
        static_cast<double>(view.width()) * view.height() / static_cast<double>(std::max<std::size_t>(1, cloud.validCount));
    return std::clamp(std::round(std::sqrt(pixels)), kUsualPointSize, kLargestPointSize);
}

} // namespace

void MainWindow::showPicture() {
    const std::shared_ptr<const Picture> last = shown_;
    shown_ = session_.picture();
    if (shown_ != last) forgetTrail();
    const Detection& detection = *shown_->detection;
    const bool newStream = !last || last->source.stream != shown_->source.stream;
    const bool newScan = newStream || last->detection->scan != detection.scan;
    if (newStream)
        showNewScan();
    else if (newScan)
        showMoreLines(*last);
    const bool newGray = newScan || last->gray != shown_->gray;
    if (newGray) {
        const bool asIs = levels_ == DisplayLevels{};
        gray_->setImage(asIs ? shown_->gray : std::make_shared<const QImage>(grayPicture(detection, levels_, shown_->gray->height())));
    }
    gray_->setOverlay(overlay_ ? shown_->overlay : nullptr, 1.0);
    showEdgeMap();
    cloud_->setEdges(shown_->edgeCells);
    status_->showCounts(detection);
    status_->showPlace(*detection.scan);
    status_->showTime(sinceChange_.isValid() && !newScan ? static_cast<double>(sinceChange_.nsecsElapsed()) / 1e6 : detection.totalMs);
    panel_->showResult(detection);
    panel_->setBehind(session_.behind());
    if (shown_->source.growth.growing)
        panel_->forgetCounts();
    else
        counts_->want(shown_->detection);
    showHover(hovered_, nullptr);
    const bool ended = last && last->source.growth.growing && !shown_->source.growth.growing;
    if (!newStream && ended) tellSweepEnded();
    emit pictureShown();
}

void MainWindow::showEdgeMap() {
    if (!shown_) return;
    const bool coloured = cloud_->edgesByClass() && shown_->detection->classes;
    edges_->setImage(coloured ? std::make_shared<const QImage>(classPicture(*shown_, cloud_->edgeColour())) : shown_->edges,
                     Shrink::KeepBrightest);
}

void MainWindow::showNewScan() {
    const Detection& detection = *shown_->detection;
    // Cells of the old scan are none of the new one.
    hovered_.reset();
    stick(std::nullopt);
    resetDisplayLevels();
    applyAspect();
    if (viewPort_->imageSize() != shown_->gray->size()) {
        viewPort_->setImageSize(shown_->gray->size());
        viewPort_->fit();
    }
    cloud_->setCloud(detection.scan, shown_->cloud);
    cloud_->setPointSize(pointSizeFor(*cloud_, *shown_->cloud));
    fitCloud();
    for (ImageView* view : {gray_, edges_}) view->setNote(QString());
    const QString ofSeries = series_.size() > 1 ? tr(" (%1 of %2)").arg(seriesPlace_ + 1).arg(series_.size()) : QString();
    setWindowTitle(QString::fromStdString(detection.scan->name) + ofSeries + " - EdgeScan");
    QStringList warnings;
    for (const std::string& warning : detection.scan->warnings) warnings << QString::fromStdString(warning);
    for (const std::string& warning : placeWarnings(*detection.scan)) warnings << QString::fromStdString(warning);
    // Of a live scan the health strip tells.
    if (warnings.isEmpty() || shown_->source.growth.growing) return;
    notice_->showNotice(NoticeBar::Kind::Warning, warnings.join("\n"));
    const bool crooked = std::ranges::any_of(detection.scan->warnings, tellsOfDisplacement);
    if (crooked && !openedPath_.isEmpty()) notice_->offer(tr("Straighten beams"), [this] { straightenBeams(true); });
}

/// More lines of the same: everything stays where it is. A camera that nobody moved follows a cloud that has doubled.
void MainWindow::showMoreLines(const Picture& last) {
    const Scan& scan = *shown_->detection->scan;
    const auto gone = [&](const std::optional<std::size_t>& cell) {
        return cell && (*cell >= scan.cells() || scan.beams() != last.detection->scan->beams());
    };
    if (gone(hovered_)) hovered_.reset();
    if (gone(sticky_)) stick(std::nullopt);
    const bool untouched = cloud_->camera() == fittedCamera_;
    const bool doubled = scan.lines() >= 2 * fittedLines_ || scan.lines() < fittedLines_ || !shown_->source.growth.growing;
    cloud_->setCloud(shown_->detection->scan, shown_->cloud, untouched && doubled ? CloudView::Camera::Reset : CloudView::Camera::Keep);
    if (!doubled) return;
    if (cloud_->pointSize() == fittedPointSize_) cloud_->setPointSize(pointSizeFor(*cloud_, *shown_->cloud));
    if (untouched) fitCloud();
}

void MainWindow::fitCloud() {
    fittedCamera_ = cloud_->camera();
    fittedPointSize_ = cloud_->pointSize();
    fittedLines_ = shown_->detection->scan->lines();
}

std::optional<QPoint> MainWindow::asPoint(std::optional<std::size_t> cell) const {
    if (!cell || !shown_) return std::nullopt;
    const auto beams = static_cast<std::size_t>(shown_->detection->scan->beams());
    return QPoint(static_cast<int>(*cell % beams), static_cast<int>(*cell / beams));
}

void MainWindow::showHover(std::optional<std::size_t> cell, const QObject* from) {
    hovered_ = cell;
    const std::optional<std::size_t> marked = cell ? cell : sticky_;
    for (ImageView* view : {gray_, edges_}) view->setMarkedCell(view == from ? std::nullopt : asPoint(cell));
    if (marked && shown_)
        cloud_->setMarkedCell(static_cast<std::uint32_t>(*marked));
    else
        cloud_->setMarkedCell(std::nullopt);
    status_->showProbe(marked && shown_ ? std::optional<Probe>(probeCell(*shown_->detection, *marked)) : std::nullopt);
}

void MainWindow::stick(std::optional<std::size_t> cell) {
    sticky_ = cell;
    for (ImageView* view : {gray_, edges_}) view->setCrosshair(asPoint(cell));
    showHover(hovered_, nullptr);
}

void MainWindow::changeDisplayLevels(int window, int level) {
    if (!shown_) return;
    // As in medical viewers: to the right the window opens, downwards the picture gets darker.
    const int centre = (levels_.black + levels_.white) / 2 + level;
    const int half = std::clamp((levels_.white - levels_.black + window) / 2, 2, 255);
    levels_ = {centre - half, centre + half};
    gray_->setImage(std::make_shared<const QImage>(grayPicture(*shown_->detection, levels_, shown_->gray->height())));
    grayPane_->setRemark(tr("display levels %1 to %2").arg(levels_.black).arg(levels_.white));
}

void MainWindow::resetDisplayLevels() {
    levels_ = {};
    grayPane_->setRemark(QString());
    if (shown_) gray_->setImage(shown_->gray);
}

// Square pixels, or as wide and high as the angles between beams and lines are.
void MainWindow::applyAspect() {
    const auto* polar = shown_ ? std::get_if<PolarGeometry>(&shown_->detection->scan->geometry) : nullptr;
    if (!trueAngles_ || polar == nullptr || polar->beamDeg.size() < 2 || polar->lineDeg.size() < 2) {
        viewPort_->setSquarePixels();
        return;
    }
    const auto step = [](const std::vector<double>& deg) {
        return std::abs(deg.back() - deg.front()) / static_cast<double>(deg.size() - 1);
    };
    viewPort_->setTrueAngle(step(polar->beamDeg), step(polar->lineDeg));
}

} // namespace edgescan::ui
