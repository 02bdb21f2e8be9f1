// The mouse for tools that request it: a left drag over a view as a row of cells, the wheel over any view as steps.
#pragma once

#include <QObject>
#include <QPoint>
#include <QPolygonF>

#include <optional>
#include <vector>

namespace edgescan::ui {

class LinkedViews;

/// GUI thread only. The views must outlive it. Cells: x = beam, y = line.
class CellDrag : public QObject {
    Q_OBJECT
public:
    enum class Wanted { Nothing, Drag, Wheel };

    CellDrag(LinkedViews& views, QObject* parent);
    void want(Wanted what);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The cells so far; the button is still down.
    void drawn(const std::vector<QPoint>& cells);
    void finished(const std::vector<QPoint>& cells);
    /// Positive away from the operator.
    void stepped(int by);

private:
    bool readMouse(QWidget& view, QEvent& event);
    [[nodiscard]] std::optional<QPoint> cellUnder(const QWidget& view, QPointF at) const;
    bool readWheel(QEvent& event);

    LinkedViews& views_;
    Wanted wanted_ = Wanted::Nothing;
    bool down_ = false;
    std::vector<QPoint> cells_;
    QPolygonF drawn_;     // in the cloud, its pixels
    double turned_ = 0.0; // fraction of a notch
};

} // namespace edgescan::ui
