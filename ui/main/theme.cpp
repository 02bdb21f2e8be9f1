// The window's colours.
#include "ui/main/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

namespace edgescan::ui {
namespace {

const QColor kBorder(133, 139, 146); // 3 : 1 and more to every ground

/// Fusion draws a light shadow beside the words of what cannot be used: on a dark ground they would look bold.
class FlatStyle : public QProxyStyle {
public:
    FlatStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const override {
        return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
    }
    // Fusion's own frame of an empty box is darker than the ground and cannot be seen on it.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton) return;
        painter->save();
        painter->setPen(QPen(option->state.testFlag(State_Enabled) ? kBorder : kBorder.darker(140), 1.0));
        painter->setBrush(Qt::NoBrush);
        const QRectF frame = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        painter->setRenderHint(QPainter::Antialiasing, element == PE_IndicatorRadioButton);
        element == PE_IndicatorCheckBox ? painter->drawRect(frame) : painter->drawEllipse(frame);
        painter->restore();
    }
};

} // namespace

void useTheme(QApplication& application) {
    QApplication::setStyle(new FlatStyle);
    // Contrast of text to its ground is at least 7 : 1, of greyed text at least 3 : 1.
    const QColor window(54, 54, 54);
    const QColor base(38, 38, 38);
    const QColor text(232, 232, 232);
    const QColor grey(148, 148, 148);
    QPalette palette;
    palette.setColor(QPalette::Light, window); // of the shadow that styles draw beside greyed words
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
