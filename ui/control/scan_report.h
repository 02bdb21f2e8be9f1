// File > Report: one page about what is on the screen, for any browser.
#pragma once

#include "ui/session/session.h"

#include <QObject>
#include <QString>

namespace edgescan::ui {

class Files;
class Memory;
class NoticeBar;
class Rocks;

/// GUI thread only. What it is given must outlive it.
class ScanReport : public QObject {
    Q_OBJECT
public:
    ScanReport(Session& session, const Files& files, const Rocks& rocks, NoticeBar& notice, Memory& memory);

    /// Asks where to.
    void ask();
    /// The page of what is on the screen, with the rocks where they are shown; made on a thread of its own.
    void writeTo(const QString& path);
    [[nodiscard]] bool working() const { return working_ > 0; }

signals:
    /// The page is on the disk.
    void saved(const QString& path);
    void ended();

private:
    /// The command line that makes the page again.
    [[nodiscard]] std::string commandFor(const Detection& detection, const QString& path) const;

    Session& session_;
    const Files& files_;
    const Rocks& rocks_;
    NoticeBar& notice_;
    Memory& memory_;
    int working_ = 0;
};

} // namespace edgescan::ui
