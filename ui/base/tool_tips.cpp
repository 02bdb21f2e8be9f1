// Breaks the lines of tool tips.
#include "ui/base/tool_tips.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFontMetrics>
#include <QHelpEvent>
#include <QStringList>
#include <QTextDocument>
#include <QToolTip>
#include <QWidget>

namespace edgescan::ui {
namespace {

constexpr int kWidest = 460; // px

class ToolTipLines : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ToolTip || !watched->isWidgetType()) return false;
        auto* widget = static_cast<QWidget*>(watched);
        const QString text = widget->toolTip();
        if (text.isEmpty() || Qt::mightBeRichText(text)) return false;
        const QString broken = brokenText(text, QFontMetrics(QToolTip::font()), kWidest);
        if (broken == text) return false;
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), broken, widget, {}, widget->toolTipDuration());
        return true;
    }
};

} // namespace

QString brokenText(const QString& text, const QFontMetrics& letters, int width) {
    QStringList lines;
    for (const QString& whole : text.split('\n')) {
        QString line;
        for (const QString& word : whole.split(' ')) {
            const QString longer = line.isEmpty() ? word : line + ' ' + word;
            if (!line.isEmpty() && letters.horizontalAdvance(longer) > width) {
                lines << line;
                line = word;
            } else {
                line = longer;
            }
        }
        lines << line;
    }
    return lines.join('\n');
}

void setBrokenText(QAbstractButton& box, const QString& text, int width) {
    const QFontMetrics letters = box.fontMetrics();
    const int others = box.sizeHint().width() - letters.size(Qt::TextShowMnemonic, box.text()).width(); // its tick, its icon, gaps
    constexpr int kSlack = 3;                                                                           // px
    box.setText(brokenText(text, letters, width - others - kSlack));
}

void breakToolTips(QApplication& application) {
    static const char* const kName = "tool-tip-lines";
    if (application.findChild<QObject*>(kName, Qt::FindDirectChildrenOnly) != nullptr) return;
    auto* lines = new ToolTipLines(&application);
    lines->setObjectName(kName);
    application.installEventFilter(lines);
}

} // namespace edgescan::ui
