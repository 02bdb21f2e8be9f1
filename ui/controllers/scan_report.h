// File > Report: one HTML page, or a PDF, about the scan on the screen.
#pragma once

#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/report_form.h"

#include <QObject>
#include <QString>

namespace edgescan::ui {

class Comparing;
class Files;
class Preferences;
class NoticeBar;
class Rocks;
class Targets;

/// GUI thread only. The objects passed to it must outlive it.
class ScanReport : public QObject {
    Q_OBJECT
public:
    ScanReport(Engine& engine, const Files& files, Rocks& rocks, const Targets& targets, const Comparing& comparing, NoticeBar& notice,
               Preferences& preferences);

    /// Asks for site, author, remark, logo and format, and for the path.
    void ask();
    /// Writes the page about the scan on the screen, with the rocks that are shown, targets and measurements, and the changes since A; on a
    /// separate thread. A path that ends with .pdf becomes a PDF. `rocksStay` false: the rocks were shown only for the report.
    void writeTo(const QString& path, const ReportWords& words = {}, bool rocksStay = true);
    [[nodiscard]] bool working() const { return working_ > 0; }

signals:
    /// The operator is asked for the form: the report is of the engine's picture.
    void asked();
    /// The page is written.
    void saved(const QString& path);
    void ended();

private:
    /// The command line that makes the same page.
    [[nodiscard]] std::string commandFor(const edges::Detection& detection, const QString& path, const ReportWords& words) const;

    Engine& engine_;
    const Files& files_;
    Rocks& rocks_;
    const Targets& targets_;
    const Comparing& comparing_;
    NoticeBar& notice_;
    Preferences& preferences_;
    int working_ = 0;
    bool rocksInReport_ = false;
    QString remark_;                 // of the last report
    std::uint64_t remarkStream_ = 0; // and its scan
};

} // namespace edgescan::ui
