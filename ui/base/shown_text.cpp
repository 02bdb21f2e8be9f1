// Converts the core's strings to Qt's.
#include "ui/base/shown_text.h"

#include "core/base/foreign_text.h"

#include <QObject>
#include <QStringList>

#include <filesystem>

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

QString shownText(const QString& text) { return shownText(exactBytes(text)); }

QString shownName(const QString& name, int mostCharacters) {
    const QString whole = QString::fromStdString(printable(exactBytes(name)));
    if (whole.size() <= mostCharacters) return whole;
    const int head = mostCharacters * 2 / 3;
    return whole.left(head).trimmed() + QStringLiteral("…") + whole.right(mostCharacters - head - 1).trimmed();
}

QString shortLength(double metres) {
    if (metres < 0.0995) return QString::number(metres * 1000.0, 'f', 0) + " mm";
    return QString::number(metres, 'g', 3) + " m";
}

QString exactText(const std::string& text) { return QString::fromStdString(escapedBytes(text)); }

std::string exactBytes(const QString& text) { return unescapedBytes(text.toStdString()); }

bool isFile(const QString& path) {
    std::error_code none;
    return std::filesystem::is_regular_file(exactBytes(path), none);
}

QString absolutePath(const QString& path) {
    std::error_code problem;
    const auto absolute = std::filesystem::absolute(exactBytes(path), problem);
    return problem ? path : exactText(absolute.lexically_normal().string());
}

} // namespace edgescan::ui
