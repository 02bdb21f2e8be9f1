// The window's colours.
#include "ui/main/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace edgescan::ui {

void useTheme(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    // Contrast of text to its ground is at least 7 : 1, of greyed text at least 3 : 1.
    const QColor window(54, 54, 54);
    const QColor base(38, 38, 38);
    const QColor text(232, 232, 232);
    const QColor grey(148, 148, 148);
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, window);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::Button, QColor(66, 66, 66));
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::ToolTipBase, base);
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::PlaceholderText, grey);
    palette.setColor(QPalette::Highlight, QColor(38, 92, 150));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(120, 180, 240));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, grey);
    }
    application.setPalette(palette);
}

} // namespace edgescan::ui
