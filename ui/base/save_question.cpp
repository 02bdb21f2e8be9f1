// Asks where to save.
#include "ui/base/save_question.h"

#include "core/files/open_save/sidecar_grid.h"
#include "ui/base/shown_text.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

#include <algorithm>

namespace edgescan::ui {
namespace {

// ".pcd" of "Point Cloud Library (*.pcd)".
QStringList extensionsOf(const QString& filter) {
    static const QRegularExpression pattern("\\*(\\.[A-Za-z0-9.-]+)");
    QStringList extensions;
    for (auto found = pattern.globalMatch(filter); found.hasNext();) extensions << found.next().captured(1);
    return extensions;
}

bool endsWithOneOf(const QString& path, const QStringList& extensions) {
    const QString name = QFileInfo(path).fileName();
    return std::any_of(extensions.begin(), extensions.end(), [&](const QString& extension) {
        return name.size() > extension.size() && name.endsWith(extension, Qt::CaseInsensitive);
    });
}

bool mayReplace(QWidget* parent, const QStringList& files) {
    QMessageBox box(QMessageBox::Warning, QObject::tr("Replace the file?"),
                    files.size() == 1 ? QObject::tr("There is a file of this name already:")
                                      : QObject::tr("There are files of these names already:"),
                    QMessageBox::Cancel, parent);
    box.setObjectName("replace-question");
    QStringList names;
    for (const QString& file : files) names << shownName(file, 200);
    box.setInformativeText(names.join('\n'));
    QPushButton* replace = box.addButton(QObject::tr("Replace"), QMessageBox::DestructiveRole);
    replace->setObjectName("replace");
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace;
}

} // namespace

QStringList withItsRecord(const QString& path) { return {path, exactText(files::sidecarPath(exactBytes(path)).string())}; }

QString withExtension(const QString& path, const QStringList& filters, const QString& chosen) {
    QStringList all;
    for (const QString& filter : filters) all << extensionsOf(filter);
    if (endsWithOneOf(path, all)) return path;
    const QStringList usual = extensionsOf(chosen.isEmpty() ? filters.value(0) : chosen);
    return path + usual.value(0);
}

QString askWhereToSave(QWidget* parent, const SaveQuestion& question) {
    QString place = question.place;
    QString chosen = question.filters.value(0);
    for (const QString& filter : question.filters) {
        if (extensionsOf(filter).contains(question.extension)) chosen = filter;
    }
    while (true) {
        // The dialog would ask about the name without its extension.
        QString path = QFileDialog::getSaveFileName(parent, question.title, place, question.filters.join(";;"), &chosen,
                                                    QFileDialog::DontConfirmOverwrite);
        if (path.isEmpty()) return {};
        place = path = withExtension(path, question.filters, chosen);
        QStringList files = question.files ? question.files(path) : QStringList{path};
        files.erase(std::remove_if(files.begin(), files.end(), [](const QString& file) { return !QFileInfo(file).isFile(); }), files.end());
        if (files.isEmpty()) return path;
        if (const QString why = question.keeps ? question.keeps(path) : QString(); !why.isEmpty()) {
            QMessageBox box(QMessageBox::Warning, question.title, shownText(why), QMessageBox::Ok, parent);
            box.setObjectName("kept-file");
            box.exec();
        } else if (mayReplace(parent, files)) {
            return path;
        }
    }
}

} // namespace edgescan::ui
