// Settings that survive a restart and a kill.
#include "ui/engine/worker_bridge/preferences.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/edges/settings/parameters.h"
#include "ui/base/shown_text.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <nlohmann/json.hpp>

namespace edgescan::ui {
namespace {

constexpr int kRecentFiles = 10;
constexpr int kVersion = 1; // of the file; a file of another version is ignored

} // namespace

Preferences::Preferences(const QString& iniPath) {
    if (iniPath.isEmpty()) return;
    file_ = std::make_unique<QSettings>(iniPath, QSettings::IniFormat);
    if (file_->value("version", kVersion).toInt() != kVersion) file_->clear();
    file_->setValue("version", kVersion);
}

QString Preferences::usualPath() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + "/edgescan/viewer.ini";
}

QByteArray Preferences::bytes(const QString& key) const { return file_ ? file_->value(key).toByteArray() : QByteArray(); }
void Preferences::keep(const QString& key, const QByteArray& value) {
    if (file_) file_->setValue(key, value);
}

QString Preferences::text(const QString& key, const QString& otherwise) const {
    return file_ ? file_->value(key, otherwise).toString() : otherwise;
}
void Preferences::keep(const QString& key, const QString& value) {
    if (file_) file_->setValue(key, value);
}

bool Preferences::flag(const QString& key, bool otherwise) const { return file_ ? file_->value(key, otherwise).toBool() : otherwise; }
void Preferences::keep(const QString& key, bool value) {
    if (file_) file_->setValue(key, value);
}

QString Preferences::dataFolder() const { return file_ ? QFileInfo(file_->fileName()).absolutePath() : QString(); }

QStringList Preferences::recentFiles() const { return file_ ? file_->value("recent/files").toStringList() : QStringList(); }

void Preferences::keepRecentFile(const QString& path) {
    if (!file_) return;
    QStringList files = recentFiles();
    const QString absolute = absolutePath(path);
    files.removeAll(absolute);
    files.prepend(absolute);
    file_->setValue("recent/files", QStringList(files.mid(0, kRecentFiles)));
}

void Preferences::forgetRecentFiles() {
    if (file_) file_->remove("recent/files");
}

void Preferences::forgetRecentFile(const QString& path) {
    if (!file_) return;
    QStringList files = recentFiles();
    files.removeAll(path);
    file_->setValue("recent/files", files);
}

QString Preferences::folder(const QString& kind) const {
    for (const QString& each : {kind, QString("scans")}) {
        const auto now = folders_.find(each);
        const QString place = now != folders_.end() ? now->second : text("folder/" + each);
        if (!place.isEmpty() && QFileInfo(place).isDir()) return place;
    }
    // A dialog takes a folder that does not exist as the name of a file.
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

void Preferences::keepFolder(const QString& kind, const QString& path) {
    folders_[kind] = QFileInfo(path).absolutePath();
    keep("folder/" + kind, folders_[kind]);
}

edges::Settings Preferences::settings(const edges::Settings& otherwise) const {
    const auto json = parseJson(text("edges/settings").toStdString(), "viewer.ini", kSettingsJson);
    if (!json || !json->is_object()) return otherwise;
    const Result<edges::Settings> read = edges::settingsFromJson(*json, otherwise, "viewer.ini");
    return read && edges::checkSettings(*read) ? *read : otherwise;
}

void Preferences::keepSettings(const edges::Settings& settings) {
    keep("edges/settings", exactText(jsonText(edges::settingsToJson(settings))));
}

} // namespace edgescan::ui
