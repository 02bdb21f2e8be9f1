// What survives a restart and a kill: one readable file. Qt writes it as soon as the event loop is reached after a change.
#pragma once

#include "core/edges/settings/presets.h"

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include <map>
#include <memory>

namespace edgescan::ui {

/// GUI thread only. With an empty path nothing is read or written (--no-settings).
class Memory {
public:
    explicit Memory(const QString& iniPath);
    /// In the user's configuration folder.
    [[nodiscard]] static QString usualPath();

    /// Its folder, where other things that survive belong; empty when nothing is remembered.
    [[nodiscard]] QString place() const;

    [[nodiscard]] QByteArray bytes(const QString& key) const;
    void keep(const QString& key, const QByteArray& value);
    [[nodiscard]] QString text(const QString& key, const QString& otherwise = {}) const;
    void keep(const QString& key, const QString& value);
    [[nodiscard]] bool flag(const QString& key, bool otherwise) const;
    void keep(const QString& key, bool value);

    /// Where it lies: what is kept beside it lies there too. Empty where nothing is remembered.
    [[nodiscard]] QString ownFolder() const;

    /// Newest first, ten at most.
    [[nodiscard]] QStringList recentFiles() const;
    void keepRecentFile(const QString& path);
    void forgetRecentFiles();
    void forgetRecentFile(const QString& path);

    /// Last folder used for a kind of file: "scans", "exports", "presets", "images"; where there is none (any more), that of the scans,
    /// else that of the person's documents. Of this run also where nothing is remembered.
    [[nodiscard]] QString folder(const QString& kind) const;
    void keepFolder(const QString& kind, const QString& path);

    [[nodiscard]] Settings settings(const Settings& otherwise) const;
    void keepSettings(const Settings& settings);

private:
    std::unique_ptr<QSettings> file_;    // null: nothing is remembered
    std::map<QString, QString> folders_; // of this run, by kind
};

} // namespace edgescan::ui
