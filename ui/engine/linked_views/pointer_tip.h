// The text at the pointer: what is under it.
#pragma once

#include <QObject>
#include <QString>

#include <cstddef>

namespace edgescan::ui {

class LinkedViews;

/// GUI thread only. The text disappears when the pointer leaves its view, on each click and key, and with another tool or picture.
class PointerTip : public QObject {
public:
    explicit PointerTip(LinkedViews& views);

    /// In the cloud, and in the image `from` (null: the image under the pointer).
    void show(std::size_t cell, const QString& text, const QObject* from);
    void hide();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    LinkedViews& views_;
};

} // namespace edgescan::ui
