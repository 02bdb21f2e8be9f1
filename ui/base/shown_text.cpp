// Converts the core's strings to Qt's.
#include "ui/base/shown_text.h"

#include "core/base/foreign_text.h"

#include <QObject>
#include <QStringList>

namespace edgescan::ui {

QString shownText(const std::string& text) {
    constexpr int kMostLines = 20;
    QStringList lines = QString::fromStdString(printableLines(text)).split('\n');
    if (lines.size() > kMostLines) {
        const auto more = lines.size() - kMostLines;
        lines = lines.mid(0, kMostLines);
        lines << QObject::tr("... and %1 lines more").arg(more);
    }
    return lines.join('\n');
}

QString shownText(const QString& text) { return shownText(text.toStdString()); }

QString shownName(const QString& name, int mostCharacters) {
    const QString whole = QString::fromStdString(printable(name.toStdString()));
    if (whole.size() <= mostCharacters) return whole;
    const int head = mostCharacters * 2 / 3;
    return whole.left(head).trimmed() + QStringLiteral("…") + whole.right(mostCharacters - head - 1).trimmed();
}

QString shortLength(double metres) {
    if (metres < 0.0995) return QString::number(metres * 1000.0, 'f', 0) + " mm";
    return QString::number(metres, 'g', 3) + " m";
}

QString exactText(const std::string& text) { return QString::fromStdString(text); }

} // namespace edgescan::ui
