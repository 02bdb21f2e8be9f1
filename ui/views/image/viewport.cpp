// The visible part of the image.
#include "ui/views/image/viewport.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr double kMaxZoom = 64.0; // pixels per cell
constexpr double kMaxAspect = 50.0;

} // namespace

ViewPort::ViewPort(QObject* parent) : QObject(parent) {}

void ViewPort::setImageSize(QSize beamsByLines) {
    if (beamsByLines == imageSize_) return;
    const bool grows = beamsByLines.width() == imageSize_.width();
    imageSize_ = beamsByLines;
    if (fitted_ || !grows) return fit();
    keepInReach();
    emit changed();
}

void ViewPort::setFinerImage(QSize beamsByLines) {
    if (fitted_ || imageSize_.isEmpty()) {
        setImageSize(beamsByLines);
        return fit();
    }
    const double perBeam = static_cast<double>(beamsByLines.width()) / imageSize_.width();
    const double perLine = static_cast<double>(beamsByLines.height()) / imageSize_.height();
    part_.reset();
    imageSize_ = beamsByLines;
    centre_ = {centre_.x() * perBeam, centre_.y() * perLine};
    zoom_ /= perLine;
    keepInReach();
    emit changed();
}

void ViewPort::setAspect(double widthByHeight) {
    if (!(widthByHeight > 0.0)) return;
    const double aspect = std::clamp(widthByHeight, 1.0 / kMaxAspect, kMaxAspect);
    if (aspect == aspect_) return;
    aspect_ = aspect;
    if (follows()) refit();
    keepInReach();
    emit changed();
}

void ViewPort::setTrueAngle(double beamStepDeg, double lineStepDeg) { setAspect(std::abs(beamStepDeg) / std::abs(lineStepDeg)); }

void ViewPort::setTurn(const Turn& turn) {
    if (turn == turn_) return;
    turn_ = turn;
    toScreen_ = QTransform().rotate(turn.degrees()) * QTransform::fromScale(turn.mirrored ? -1.0 : 1.0, 1.0);
    if (follows()) refit();
    emit changed();
    emit turned();
}

void ViewPort::fit() {
    fitted_ = true;
    part_.reset();
    refit();
    emit changed();
}

void ViewPort::fitTo(const QRectF& cells) {
    fitted_ = false;
    part_ = cells;
    refit();
    emit changed();
}

void ViewPort::refit() {
    const QRectF cells = part_.value_or(QRectF(QPointF(), imageSize_));
    centre_ = cells.center();
    zoom_ = fittingZoom(cells.size());
    keepInReach();
}

void ViewPort::endFit() {
    fitted_ = false;
    part_.reset();
}

QSize ViewPort::smallestView() const {
    QSize smallest;
    for (const QSize size : viewSizes_) smallest = smallest.isEmpty() ? size : smallest.boundedTo(size);
    return smallest;
}

double ViewPort::fittingZoom(QSizeF cells) const { return fittingZoom(cells, smallestView()); }

double ViewPort::fittingZoom(QSizeF cells, QSizeF view) const {
    if (view.isEmpty() || cells.isEmpty()) return 1.0;
    if (turn_.quarter) view.transpose();
    return std::min({view.width() / (cells.width() * aspect_), view.height() / cells.height(), kMaxZoom});
}

double ViewPort::zoomIn(QSizeF viewSize) const {
    const QSize smallest = smallestView();
    if (smallest.isEmpty() || viewSize.isEmpty() || viewSize == QSizeF(smallest)) return zoom_;
    return std::min(zoom_ * fittingZoom(imageSize_, viewSize) / fittingZoom(imageSize_, smallest), std::max(zoom_, kMaxZoom));
}

void ViewPort::zoomAt(QPointF cell, double factor) {
    const double least = std::min(0.25 * fittingZoom(imageSize_), 1.0);
    const double zoom = std::clamp(zoom_ * factor, least, kMaxZoom);
    if (zoom == zoom_) return;
    centre_ = cell + (centre_ - cell) * (zoom_ / zoom);
    zoom_ = zoom;
    endFit();
    keepInReach();
    emit changed();
}

void ViewPort::panPixels(QPointF pixels, QSizeF viewSize) { centreOn(centre_ - (toCell(pixels, viewSize) - toCell({}, viewSize))); }

void ViewPort::centreOn(QPointF cell) {
    const QPointF before = centre_;
    centre_ = cell;
    keepInReach();
    if (centre_ == before) return;
    endFit();
    emit changed();
}

// The centre of the view stays inside the image, so that the image cannot be lost.
void ViewPort::keepInReach() {
    centre_.setX(std::clamp(centre_.x(), 0.0, static_cast<double>(std::max(0, imageSize_.width()))));
    centre_.setY(std::clamp(centre_.y(), 0.0, static_cast<double>(std::max(0, imageSize_.height()))));
}

void ViewPort::setViewSize(const QObject* view, QSize size) {
    const QSize before = smallestView();
    viewSizes_[view] = size;
    if (!follows() || smallestView() == before) return;
    refit();
    emit changed();
}

void ViewPort::forgetView(const QObject* view) {
    viewSizes_.remove(view);
    if (!follows()) return;
    refit();
    emit changed();
}

QPointF ViewPort::toCell(QPointF pixel, QSizeF viewSize) const {
    const QSizeF cell = cellSize(viewSize);
    const QPointF way = toScreen_.inverted().map(pixel - 0.5 * QPointF(viewSize.width(), viewSize.height()));
    return centre_ + QPointF(way.x() / cell.width(), way.y() / cell.height());
}

QPointF ViewPort::toPixel(QPointF cell, QSizeF viewSize) const {
    const QSizeF size = cellSize(viewSize);
    const QPointF way = cell - centre_;
    return 0.5 * QPointF(viewSize.width(), viewSize.height()) + toScreen_.map(QPointF(way.x() * size.width(), way.y() * size.height()));
}

} // namespace edgescan::ui

#include "moc_viewport.cpp"
