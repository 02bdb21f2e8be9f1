// Converts the core's strings to Qt's.
#include "ui/base/shown_text.h"

#include "core/base/foreign_text.h"

#include <QObject>
#include <QStringList>

#include <algorithm>
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

QString shownApart(const QString& name, const QString& other, int mostCharacters) {
    QString shown = name;
    if (shown.size() <= mostCharacters || other.isEmpty()) return shownName(shown, mostCharacters);
    const auto [mine, theirs] = std::ranges::mismatch(name, other);
    auto same = static_cast<int>(mine - name.begin());
    const auto splits = [](const QString& text, int at) { // a word
        return at > 0 && at < text.size() && text[at - 1].isLetterOrNumber() && text[at].isLetterOrNumber();
    };
    while (splits(name, same)) --same;
    if (same > 1 && same < name.size()) shown = QStringLiteral("…") + name.mid(same);
    if (shown.size() <= mostCharacters) return shown;
    int end = 0;
    while (end < std::min(name.size(), other.size()) - same && name[name.size() - 1 - end] == other[other.size() - 1 - end]) ++end;
    while (splits(name, name.size() - end)) --end;
    if (end > 1) shown = shown.chopped(end) + QStringLiteral("…");
    return shownName(shown, mostCharacters);
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
