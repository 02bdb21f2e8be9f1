// Asks where to save, and asks again before a file is replaced. The question names the files that will really be written.
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace edgescan::ui {

struct SaveQuestion {
    QString title;
    QString place;       ///< the proposed path
    QStringList filters; ///< "Point Cloud Library (*.pcd)"; a name with another extension gets the extension of the chosen filter
    QString extension{}; ///< ".pcd": extension of the filter that is chosen at first
    /// All files that are written for this path; not set: the path itself.
    std::function<QStringList(const QString& path)> files{};
    /// The reason why the existing file must not be replaced; empty: it may be replaced.
    std::function<QString(const QString& path)> keeps{};
};

/// The path with its extension; empty if the operator cancelled.
[[nodiscard]] QString askWhereToSave(QWidget* parent, const SaveQuestion& question);

/// An export and its provenance record, which is replaced with it: for `files`.
[[nodiscard]] QStringList withItsRecord(const QString& path);

/// `path` with the extension of `chosen`, unless it already ends with an extension of `filters`.
[[nodiscard]] QString withExtension(const QString& path, const QStringList& filters, const QString& chosen);

} // namespace edgescan::ui
