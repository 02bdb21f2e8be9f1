// Zooms by taps.
#include "ui/panels/cab/zoom_buttons.h"

#include <QHBoxLayout>
#include <QToolButton>

#include <tuple>

namespace edgescan::ui {
namespace {

constexpr int kSide = 52, kBetweenZooms = 4; // px
constexpr int kSignPx = 26;
constexpr double kZoomStep = 1.25;

} // namespace

ZoomButtons::ZoomButtons() {
    setObjectName("cab-zoom");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBetweenZooms);
    for (const auto& [name, sign, words, factor] :
         {std::tuple("cab-zoom-in", "+", tr("Zoom in"), kZoomStep), {"cab-zoom-out", "−", tr("Zoom out"), 1.0 / kZoomStep}}) {
        auto* button = new QToolButton;
        button->setObjectName(name);
        button->setText(QString::fromUtf8(sign));
        button->setAccessibleName(words);
        button->setFixedSize(kSide, kSide);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRepeat(true);
        QFont letters = button->font();
        letters.setPixelSize(kSignPx);
        letters.setBold(true);
        button->setFont(letters);
        connect(button, &QToolButton::clicked, this, [this, by = factor] { emit zoomed(by); });
        row->addWidget(button);
    }
    hide();
}

} // namespace edgescan::ui

#include "moc_zoom_buttons.cpp"
