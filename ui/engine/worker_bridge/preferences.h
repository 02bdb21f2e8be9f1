// Settings that survive a restart and a kill: one readable file. Qt writes it in the next run of the event loop after a change.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/presets.h"

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>

namespace edgescan::ui {

/// GUI thread only. With an empty path no file is read or written (--no-settings).
class Preferences {
public:
    explicit Preferences(const QString& iniPath);
    /// In the user's configuration folder.
    [[nodiscard]] static QString usualPath();
    /// What is wrong with the file: it is not a regular one, so no settings are stored, or not all of it can be read, and a copy is kept.
    [[nodiscard]] std::optional<Error> refusal() const;

    [[nodiscard]] QByteArray bytes(const QString& key) const;
    void keep(const QString& key, const QByteArray& value);
    [[nodiscard]] QString text(const QString& key, const QString& otherwise = {}) const;
    void keep(const QString& key, const QString& value);
    [[nodiscard]] bool flag(const QString& key, bool otherwise) const;
    void keep(const QString& key, bool value);

    /// The folder of the settings file; related files are stored there too. Empty if settings are not stored.
    [[nodiscard]] QString dataFolder() const;

    /// Newest first, ten at most.
    [[nodiscard]] QStringList recentFiles() const;
    void keepRecentFile(const QString& path);
    void forgetRecentFiles();
    void forgetRecentFile(const QString& path);

    /// The last folder used for a kind of file: "scans", "exports" (all that is made of a scan), "presets", "sessions". If that folder is
    /// missing: that of the exports, of the scans, of new recordings, else the user's documents. During this run it works even if settings
    /// are not stored.
    [[nodiscard]] QString folder(const QString& kind) const;
    void keepFolder(const QString& kind, const QString& path);
    /// Of new recordings; it may not exist yet.
    [[nodiscard]] QString recordingFolder() const;

    [[nodiscard]] edges::Settings settings(const edges::Settings& otherwise) const;
    void keepSettings(const edges::Settings& settings);

private:
    std::unique_ptr<QSettings> file_;    // null: settings are not stored
    QString refused_;                    // the path of what is not a regular file
    QString aside_;                      // the copy of a file that cannot be read as a whole
    std::map<QString, QString> folders_; // of this run, by kind
};

} // namespace edgescan::ui
