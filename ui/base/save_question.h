// Asks where to save, and before a file is replaced: about the very files that will be written, whatever was typed.
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace edgescan::ui {

struct SaveQuestion {
    QString title;
    QString place;       ///< the path proposed
    QStringList filters; ///< "Point Cloud Library (*.pcd)"; a name that ends with none of these gets the extension of the one chosen
    QString extension{}; ///< ".pcd": of the filter that is chosen at first
    /// All that is written for this path; none given: the path itself.
    std::function<QStringList(const QString& path)> files{};
    /// Why the file that is there may not be replaced at all; empty: it may.
    std::function<QString(const QString& path)> keeps{};
};

/// The path, with its extension; empty when the question was dismissed.
[[nodiscard]] QString askWhereToSave(QWidget* parent, const SaveQuestion& question);

/// `path` with the extension of `chosen`, unless it ends with one of those in `filters` already.
[[nodiscard]] QString withExtension(const QString& path, const QStringList& filters, const QString& chosen);

} // namespace edgescan::ui
