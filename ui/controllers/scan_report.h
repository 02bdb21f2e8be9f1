// File > Report: one page about what is on the screen, for any browser.
#pragma once

#include "ui/engine/worker_bridge/engine.h"

#include <QObject>
#include <QString>

namespace edgescan::ui {

class Comparing;
class Files;
class Memory;
class NoticeBar;
class Rocks;
class Targets;

/// GUI thread only. What it is given must outlive it.
class ScanReport : public QObject {
    Q_OBJECT
public:
    ScanReport(Engine& engine, const Files& files, const Rocks& rocks, const Targets& targets, const Comparing& comparing,
               NoticeBar& notice, Memory& memory);

    /// Asks where to.
    void ask();
    /// The page of what is on the screen, with the rocks where they are shown, what was pinned and measured, and what
    /// changed since A; made on a thread of its own.
    void writeTo(const QString& path);
    [[nodiscard]] bool working() const { return working_ > 0; }

signals:
    /// The page is on the disk.
    void saved(const QString& path);
    void ended();

private:
    /// The command line that makes the page again.
    [[nodiscard]] std::string commandFor(const Detection& detection, const QString& path) const;

    Engine& engine_;
    const Files& files_;
    const Rocks& rocks_;
    const Targets& targets_;
    const Comparing& comparing_;
    NoticeBar& notice_;
    Memory& memory_;
    int working_ = 0;
};

} // namespace edgescan::ui
