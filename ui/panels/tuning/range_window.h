// The window of the range image: the ranges that are drawn from black to white, on a histogram of all ranges, in metres.
#pragma once

#include "core/scan/grid/scan.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

class QLabel;
class QToolButton;

namespace edgescan::ui {

/// Number of cells with a range in each of equal steps from 0 to `mostM`; 99.9 % of these cells are below `mostM`.
struct RangeHistogram {
    double mostM = 1.0;
    std::vector<std::uint32_t> counts;
};
[[nodiscard]] RangeHistogram rangeHistogram(const Scan& scan);

/// The histogram with two ends. The operator drags them, or moves them with the keys left and right: the far end, with Shift the near end.
/// GUI thread only.
class RangeHandles : public QWidget {
    Q_OBJECT
public:
    using Window = std::pair<double, double>; ///< near and far, metres

    explicit RangeHandles(QWidget* parent = nullptr);
    void showHistogram(RangeHistogram histogram);
    void setWindow(Window window);
    [[nodiscard]] Window window() const { return window_; }
    /// The position of a range, and the range at a position; pixels from the left, metres.
    [[nodiscard]] double toX(double metres) const;
    [[nodiscard]] double toMetres(double x) const;

signals:
    void dragged(double nearM, double farM);
    void automaticRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// Until the histogram is computed there is no scale for the ends.
    [[nodiscard]] bool isKnown() const { return !histogram_.counts.empty(); }
    void moveEnd(bool far, double metres);

    RangeHistogram histogram_;
    Window window_{0.0, 1.0};
    std::optional<bool> held_; // the end that is dragged: true = far, false = near
};

class RangeWindow : public QWidget {
    Q_OBJECT
public:
    explicit RangeWindow(QWidget* parent = nullptr);

    void showHistogram(const RangeHistogram& histogram);
    /// The window of the range image; `automatic`: as scaled by the method.
    void showWindow(RangeHandles::Window window, bool automatic);
    void setLocked(bool on);
    [[nodiscard]] bool locked() const;
    [[nodiscard]] RangeHandles& handles() { return *handles_; }
    [[nodiscard]] QString words() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void windowRequested(double nearM, double farM);
    void automaticRequested();
    void lockRequested(bool on);

private:
    void fit();

    QLabel* title_;
    QLabel* words_;
    QString full_, brief_; // of the two ends
    QToolButton *automatic_, *lock_;
    RangeHandles* handles_;
};

} // namespace edgescan::ui
