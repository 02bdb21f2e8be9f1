// Automatically saved sessions: one file per running viewer, and the files that a crash left.
#pragma once

#include <QLockFile>
#include <QString>
#include <QStringList>

#include <memory>

namespace edgescan::ui {

/// GUI thread only.
class Autosaves {
public:
    /// `folder`: empty = no autosaves.
    explicit Autosaves(const QString& folder);
    ~Autosaves();

    /// The path of this viewer's autosave; empty: none.
    [[nodiscard]] const QString& own() const { return own_; }
    /// Autosaves of viewers that did not end normally, the newest first.
    [[nodiscard]] QStringList afterCrash() const;
    /// Of these the newest that was not offered yet at an earlier start; empty: none. When this viewer closes, it and older ones count as
    /// offered.
    [[nodiscard]] QString toOffer();
    /// The autosave of the viewer that was closed last; empty: none.
    [[nodiscard]] QString last() const;
    /// The session at `path` was continued: from now on the own autosave contains it.
    void markContinued(const QString& path);
    /// The viewer closes: its session becomes the last one.
    void end();

private:
    [[nodiscard]] bool isRunning(const QString& path) const;

    QString folder_, own_;
    std::unique_ptr<QLockFile> lock_;
    QStringList takenUp_;
    QStringList offered_; // the newest first
};

} // namespace edgescan::ui
