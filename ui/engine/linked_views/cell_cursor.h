// A cell cursor in the images, moved by the arrow keys: it offers everything that the mouse does with a cell.
#pragma once

#include <QObject>
#include <QPoint>

#include <optional>

namespace edgescan::ui {

class ImageView;
class LinkedViews;

/// Arrows move it by one cell, with Shift or Ctrl by ten; Return clicks this very cell. While the timeline shows a recording, the arrows
/// step through its lines instead. GUI thread only; `views` must outlive it.
class CellCursor : public QObject {
    Q_OBJECT
public:
    CellCursor(LinkedViews& views, QObject* parent);

    /// x = beam, y = line; empty before the first arrow key.
    [[nodiscard]] std::optional<QPoint> at() const { return at_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void moveBy(ImageView& view, QPoint step);

    LinkedViews& views_;
    std::optional<QPoint> at_;
};

} // namespace edgescan::ui
