// The sessions that are saved by themselves: one file per running viewer, and which of them a crash left behind.
#pragma once

#include <QLockFile>
#include <QString>
#include <QStringList>

#include <memory>

namespace edgescan::ui {

/// GUI thread only.
class Autosaves {
public:
    /// `folder`: empty = nothing is kept.
    explicit Autosaves(const QString& folder);
    ~Autosaves();

    /// Where this viewer saves; empty: nowhere.
    [[nodiscard]] const QString& own() const { return own_; }
    /// Of viewers that ended without saying so, the newest first.
    [[nodiscard]] QStringList leftBehind() const;
    /// Of the viewer that was closed last; empty: there is none.
    [[nodiscard]] QString last() const;
    /// It was taken up again: what it holds is held by the own one from now on.
    void takenUp(const QString& path);
    /// The viewer is being closed: its session is the last one from now on.
    void end();

private:
    [[nodiscard]] bool isRunning(const QString& path) const;

    QString folder_, own_;
    std::unique_ptr<QLockFile> lock_;
    QStringList takenUp_;
};

} // namespace edgescan::ui
