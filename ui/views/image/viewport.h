// The visible part of the lines x beams image. Several image views share it, so that they always zoom and pan together.
#pragma once

#include <QHash>
#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QSizeF>
#include <QTransform>

#include <optional>

namespace edgescan::ui {

/// Cell coordinates: x = beam, y = line; cell (line, beam) covers [beam, beam+1) x [line, line+1).
/// GUI thread only.
class ViewPort : public QObject {
    Q_OBJECT
public:
    explicit ViewPort(QObject* parent = nullptr);

    [[nodiscard]] QPointF centre() const { return centre_; }
    /// Height of a cell in (device-independent) pixels, in the smallest view; in larger views cells are larger, so that all views show
    /// the same part of the image.
    [[nodiscard]] double zoom() const { return zoom_; }
    /// 1: as large as fits into the views; 4: four times as large.
    [[nodiscard]] double magnification() const { return zoom_ / fittingZoom(imageSize_); }
    /// Width of a cell divided by its height: 1 = square pixels.
    [[nodiscard]] double aspect() const { return aspect_; }
    [[nodiscard]] QSizeF cellSize() const { return {zoom_ * aspect_, zoom_}; }
    [[nodiscard]] QSizeF cellSize(QSizeF viewSize) const { return {zoomIn(viewSize) * aspect_, zoomIn(viewSize)}; }
    [[nodiscard]] QSize imageSize() const { return imageSize_; }
    /// True until the operator zooms or pans: the whole image is fitted to the size of the views.
    [[nodiscard]] bool fitted() const { return fitted_; }

    /// Beams x lines. A new number of beams fits the image again. The same size or more lines keep zoom and place (a re-tune, a live scan),
    /// unless the whole image was visible.
    void setImageSize(QSize beamsByLines);
    /// The same picture with smaller cells: the part of it that is seen stays where it is.
    void setFinerImage(QSize beamsByLines);
    void setAspect(double widthByHeight);
    /// "True angle" aspect: beam step and line step in degrees.
    void setTrueAngle(double beamStepDeg, double lineStepDeg);
    void setSquarePixels() { setAspect(1.0); }
    /// How the image is turned on the screen: first turned clockwise by a quarter, by a half, or by both, then mirrored
    /// left to right.
    struct Turn {
        bool mirrored = false, quarter = false, half = false;
        [[nodiscard]] int degrees() const { return (quarter ? 90 : 0) + (half ? 180 : 0); }
        bool operator==(const Turn&) const = default;
    };
    void setTurn(const Turn& turn);
    [[nodiscard]] const Turn& turn() const { return turn_; }
    /// From the image as it is to the image on the screen, both about their middles: of pixels and of steps.
    [[nodiscard]] const QTransform& toScreen() const { return toScreen_; }

    void fit();
    /// Fits these cells into the views, also those that are shown later, until the operator zooms or pans.
    void fitTo(const QRectF& cells);
    /// What fitTo() asked for; empty: the operator zoomed or panned since, or the whole image is fitted.
    [[nodiscard]] const std::optional<QRectF>& part() const { return part_; }
    /// Enlarges the cells by a factor; `cell` stays at the same place on the screen.
    void zoomAt(QPointF cell, double factor);
    /// Moves the picture by (device-independent) pixels of a view.
    void panPixels(QPointF pixels, QSizeF viewSize);
    void centreOn(QPointF cell);

    /// Each view reports its size, so that fit() suits the smallest view.
    void setViewSize(const QObject* view, QSize size);
    void forgetView(const QObject* view);

    [[nodiscard]] QPointF toCell(QPointF pixel, QSizeF viewSize) const;
    [[nodiscard]] QPointF toPixel(QPointF cell, QSizeF viewSize) const;

signals:
    void changed();
    void turned();

private:
    [[nodiscard]] QSize smallestView() const;
    [[nodiscard]] double fittingZoom(QSizeF cells) const;
    [[nodiscard]] double fittingZoom(QSizeF cells, QSizeF view) const;
    [[nodiscard]] double zoomIn(QSizeF viewSize) const;
    void keepInReach();
    void refit();
    [[nodiscard]] bool follows() const { return fitted_ || part_; }
    void endFit();

    QPointF centre_{0.5, 0.5};
    double zoom_ = 1.0;
    double aspect_ = 1.0;
    Turn turn_;
    QTransform toScreen_;
    bool fitted_ = true;
    std::optional<QRectF> part_; // that is fitted instead of the whole image
    QSize imageSize_;
    QHash<const QObject*, QSize> viewSizes_;
};

} // namespace edgescan::ui
