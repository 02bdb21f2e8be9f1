// Settings that survive a restart and a kill.
#include "ui/engine/worker_bridge/preferences.h"

#include "core/base/bounded_json.h"
#include "core/base/descriptor.h"
#include "core/base/file_lock.h"
#include "core/base/json_text.h"
#include "core/edges/settings/parameters.h"
#include "ui/base/shown_text.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <nlohmann/json.hpp>

#include <fcntl.h>

#include <chrono>

namespace edgescan::ui {
namespace {

constexpr int kRecentFiles = 10;
constexpr int kVersion = 1; // of the file; the settings of another version are not used

/// The lock of the folder of a settings file, until the result is destroyed. On a file system without locks, and where another program
/// holds the lock all the time, the file is used nevertheless.
Descriptor lockedFolderOf(const QString& file) {
    const QString path = QFileInfo(file).absolutePath();
    QDir().mkpath(path);
    Descriptor folder(::open(QFile::encodeName(path).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.isOpen()) static_cast<void>(lockFile(folder.number(), std::chrono::seconds(2)));
    return folder;
}

/// Reads and writes while this program has locked the folder. QSettings alone reads without a lock, and may remember the size and the time
/// of a file that another program wrote after that: then it does not read that file again before it writes, and the other's settings are
/// lost.
class SettingsFile : public QSettings {
public:
    [[nodiscard]] static std::unique_ptr<QSettings> opened(const QString& path) {
        const Descriptor folder = lockedFolderOf(path);
        return std::unique_ptr<QSettings>(new SettingsFile(path));
    }
    ~SettingsFile() override {
        const Descriptor folder = lockedFolderOf(fileName());
        sync();
    }
    SettingsFile(const SettingsFile&) = delete;
    SettingsFile& operator=(const SettingsFile&) = delete;

protected:
    bool event(QEvent* event) override {
        if (event->type() != QEvent::UpdateRequest) return QSettings::event(event);
        const Descriptor folder = lockedFolderOf(fileName());
        return QSettings::event(event);
    }

private:
    explicit SettingsFile(const QString& path) : QSettings(path, QSettings::IniFormat) {}
};

} // namespace

Preferences::Preferences(const QString& iniPath) {
    if (iniPath.isEmpty()) return;
    if (const QFileInfo file(iniPath); file.exists() && !file.isFile()) { // a pipe would be waited for
        refused_ = iniPath;
        return;
    }
    file_ = SettingsFile::opened(iniPath);
    if (file_->value("version", kVersion).toInt() != kVersion || file_->status() == QSettings::FormatError) {
        aside_ = iniPath + ".damaged";
        QFile::remove(aside_);
        if (!QFile::copy(iniPath, aside_)) {
            refused_ = iniPath;
            file_.reset();
            return;
        }
        file_->clear();
    }
    file_->setValue("version", kVersion);
}

std::optional<Error> Preferences::refusal() const {
    if (!aside_.isEmpty() && !refused_.isEmpty())
        return Error{"not all settings in this file can be read", exactBytes(refused_), "remove it and start again"};
    if (!aside_.isEmpty())
        return Error{"not all settings in this file can be read", exactBytes(file_->fileName()),
                     "what it held is in " + exactBytes(aside_)};
    if (refused_.isEmpty()) return std::nullopt;
    return Error{"it is not a regular file, so settings are not read and nothing of this window is stored", exactBytes(refused_),
                 "remove it and start again"};
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
    for (const QString& each : {kind, QString("exports"), QString("scans")}) {
        const auto now = folders_.find(each);
        const QString place = now != folders_.end() ? now->second : text("folder/" + each);
        if (!place.isEmpty() && QFileInfo(place).isDir()) return place;
    }
    // A dialog takes a folder that does not exist as the name of a file.
    for (const QString& place : {recordingFolder(), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}) {
        if (QFileInfo(place).isDir()) return place;
    }
    return QDir::homePath();
}

QString Preferences::recordingFolder() const {
    return text("folder/recordings", QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/EdgeScan");
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
