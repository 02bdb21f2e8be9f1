// Draws the warnings of the scan below a picture of the window.
#include "ui/window/warned_picture.h"

#include "ui/base/shown_text.h"

#include <QFontMetrics>
#include <QObject>
#include <QPainter>

namespace edgescan::ui {

QImage withWarnings(const QImage& window, const QStringList& warnings, const QFont& font) {
    if (warnings.isEmpty()) return window;
    constexpr int kMargin = 8;
    const qreal scale = window.devicePixelRatio();
    const int width = static_cast<int>(window.width() / scale);
    const QString text = shownText(QObject::tr("Warnings of this scan:\n") + warnings.join('\n'));
    const QRect room(kMargin, kMargin, width - 2 * kMargin, 100000);
    const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWrapAnywhere;
    const QRect needed = QFontMetrics(font).boundingRect(room, flags, text);
    const int height = static_cast<int>(window.height() / scale);
    QImage image(static_cast<int>(width * scale), static_cast<int>((height + needed.height() + 2 * kMargin) * scale), window.format());
    image.setDevicePixelRatio(scale);
    image.fill(QColor(107, 78, 0));
    QPainter painter(&image);
    painter.drawImage(0, 0, window);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(QRect(kMargin, height + kMargin, width - 2 * kMargin, needed.height()), flags, text);
    return image;
}

} // namespace edgescan::ui
