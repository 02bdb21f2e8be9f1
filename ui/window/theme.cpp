// The style Fusion with visible borders, focus and sizes.
#include "ui/window/theme.h"

#include "ui/base/themes.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDialog>
#include <QFont>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kAroundTab = 10;  // px: three names have room in a narrow panel
constexpr double kLarger = 1.4; // factor on the desktop's font size, for gloves

void drawFrame(QPainter& painter, const QRect& place, const QPen& pen, double radius) {
    painter.save();
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.setRenderHint(QPainter::Antialiasing, radius > 0);
    const double half = pen.widthF() / 2.0;
    painter.drawRoundedRect(QRectF(place).adjusted(half, half, -half, -half), radius, radius);
    painter.restore();
}

/// Fusion draws a light shadow next to the text of disabled items: on a dark background they would look bold.
class FlatStyle : public QProxyStyle {
public:
    explicit FlatStyle(bool forGloves) : QProxyStyle(QStyleFactory::create("Fusion")), forGloves_(forGloves) {}
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const override {
        if (hint == SH_EtchDisabledText) return 0;
        if (hint == SH_UnderlineShortcut && forGloves_) return 0; // a cab has no keyboard
        if (hint == SH_Menu_Scrollable && forGloves_) return 1;   // columns would leave a low screen at its right
        // Else a menu closes the menu of its menu: a finger does not stay where it tapped, and never was over the first menu.
        if (hint == SH_Menu_SubMenuDontStartSloppyOnLeave) return 1;
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
    // Fusion's own frames are shades of the background, and invisible on some backgrounds.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget) const override {
        if (element == PE_FrameFocusRect) return drawFrame(*painter, option->rect, {option->palette.color(QPalette::Link), 2.0}, 2.0);
        if (element == PE_IndicatorHeaderArrow) return drawSortArrow(option, painter, widget);
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element == PE_Widget && forGloves_ && qobject_cast<const QDialog*>(widget) != nullptr)
            return drawFrame(*painter, widget->rect(), {option->palette.color(QPalette::Mid), 2.0}, 0.0);
        const bool box = element == PE_IndicatorCheckBox;
        const bool round = element == PE_IndicatorRadioButton;
        if (box || round || element == PE_FrameLineEdit || element == PE_PanelButtonCommand)
            drawFrame(*painter, option->rect, penFor(*option), round ? option->rect.width() / 2.0 : box ? 0.0 : 2.0);
    }
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        QStyleOptionSpinBox bare;
        option = withoutArrows(option, bare);
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        if (control == CC_SpinBox || control == CC_ComboBox) drawFrame(*painter, option->rect, penFor(*option), 2.0);
        if (control == CC_Slider)
            drawFrame(*painter, proxy()->subControlRect(CC_Slider, option, SC_SliderHandle, widget), penFor(*option), 2.0);
    }
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part, const QWidget* widget) const override {
        QStyleOptionSpinBox bare;
        return QProxyStyle::subControlRect(control, withoutArrows(option, bare), part, widget);
    }
    /// A cab may have no window manager that gives a dialog its border.
    void polish(QWidget* widget) override {
        QProxyStyle::polish(widget);
        if (forGloves_ && qobject_cast<QDialog*>(widget) != nullptr) widget->setAttribute(Qt::WA_StyledBackground);
    }
    void unpolish(QWidget* widget) override {
        QProxyStyle::unpolish(widget);
        if (forGloves_ && qobject_cast<QDialog*>(widget) != nullptr) widget->setAttribute(Qt::WA_StyledBackground, false);
    }
    using QProxyStyle::polish;
    using QProxyStyle::unpolish;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        const int usual = metric == PM_TabBarTabHSpace ? kAroundTab : QProxyStyle::pixelMetric(metric, option, widget);
        if (!forGloves_) return usual;
        switch (metric) {
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
        case PM_ExclusiveIndicatorWidth:
        case PM_ExclusiveIndicatorHeight:
            return 28; // the surrounding row is high enough for gloves
        case PM_SliderThickness:
        case PM_SliderControlThickness:
        case PM_SliderLength:
        case PM_TabBarTabVSpace:
        case PM_MenuScrollerHeight:
            return std::max(usual, kGlovePx);
        default:
            return usual;
        }
    }
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents, const QWidget* widget) const override {
        const QSize usual = QProxyStyle::sizeFromContents(type, option, contents, widget);
        if (!forGloves_) return usual;
        switch (type) {
        case CT_PushButton:
        case CT_ToolButton:
        case CT_ComboBox:
        case CT_SpinBox:
        case CT_LineEdit:
        case CT_CheckBox:
        case CT_RadioButton:
        case CT_ItemViewItem:
        case CT_TabBarTab:
            return usual.expandedTo({kGlovePx, kGlovePx});
        case CT_MenuItem: {
            const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
            const bool line = item != nullptr && item->menuItemType == QStyleOptionMenuItem::Separator;
            if (line) return usual;
            const QSize high = usual.expandedTo({kGlovePx, kGlovePx});
            // Fusion gives the check mark a column of this share of the row's height: a higher row has less room for its text.
            constexpr double kMarkShare = 0.79;
            return high + QSize(static_cast<int>(std::ceil(kMarkShare * (high.height() - usual.height()))), 0);
        }
        default:
            return usual;
        }
    }

private:
    /// The arrows of a number field are too small for gloves: the keys on the screen set the number. `bare`: holds the copy.
    const QStyleOptionComplex* withoutArrows(const QStyleOptionComplex* option, QStyleOptionSpinBox& bare) const {
        const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        if (box == nullptr || !forGloves_) return option;
        bare = *box;
        bare.buttonSymbols = QAbstractSpinBox::NoButtons;
        return &bare;
    }
    /// Up for the smallest first, down for the largest first, as in spreadsheets. Fusion draws the opposite.
    void drawSortArrow(const QStyleOption* option, QPainter* painter, const QWidget* widget) const {
        const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(option);
        if (header == nullptr) return QProxyStyle::drawPrimitive(PE_IndicatorHeaderArrow, option, painter, widget);
        QStyleOptionHeader turned = *header;
        if (header->sortIndicator == QStyleOptionHeader::SortUp) turned.sortIndicator = QStyleOptionHeader::SortDown;
        if (header->sortIndicator == QStyleOptionHeader::SortDown) turned.sortIndicator = QStyleOptionHeader::SortUp;
        QProxyStyle::drawPrimitive(PE_IndicatorHeaderArrow, &turned, painter, widget);
    }
    static QPen penFor(const QStyleOption& option) {
        if (option.state.testFlag(State_HasFocus)) return {option.palette.color(QPalette::Link), 2.0};
        const QColor border = option.palette.color(QPalette::Mid);
        return {option.state.testFlag(State_Enabled) ? border : option.palette.color(QPalette::Midlight), 1.0};
    }

    bool forGloves_;
};

} // namespace

void useTheme(QApplication& application, bool forGloves) {
    static const QFont usual = QApplication::font();
    QFont font = usual;
    if (forGloves) font.setPointSizeF(kLarger * usual.pointSizeF());
    for (QWidget* each : QApplication::allWidgets()) each->ensurePolished(); // a widget that was never shown misses the change otherwise
    application.setFont(font);
    QApplication::setStyle(new FlatStyle(forGloves)); // last: a combo box forgets its least size only then
    useColours(themeInUse());
    for (QWidget* each : QApplication::allWidgets()) each->updateGeometry(); // layouts store the sizes of before
}

} // namespace edgescan::ui
