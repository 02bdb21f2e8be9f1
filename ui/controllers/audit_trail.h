// Writes the operator's actions to the audit log (docs/reference/audit.md).
#pragma once

#include "core/base/audit_log/audit_log.h"
#include "ui/engine/worker_bridge/engine.h"

#include <QObject>
#include <QStringList>

#include <deque>
#include <optional>
#include <string>
#include <utility>

class QUndoStack;

namespace edgescan::ui {

class LinkedViews;
class NoticeBar;

/// GUI thread only; lines are written on a separate thread, one after the other. The objects passed to it must outlive it.
class AuditTrail : public QObject {
    Q_OBJECT
public:
    /// `folder`: the folder of audit.jsonl; empty: no log is written.
    AuditTrail(const QString& folder, const Engine& engine, const LinkedViews& views, const QUndoStack& undo, NoticeBar& notice);
    ~AuditTrail() override;

    void note(const std::string& event, const nlohmann::ordered_json& details);
    /// Logs an export: its content, path and number of points.
    void noteExport(const std::string& content, const QString& path, std::optional<qint64> count = std::nullopt);
    void noteWarnings(const QStringList& warnings);
    /// All lines are on the disk.
    [[nodiscard]] bool written() const { return lines_.empty() && !writing_; }

private:
    using Lines = std::deque<std::pair<std::string, nlohmann::ordered_json>>;
    /// Lines that could not be written, in order, and the error.
    struct Unwritten {
        Lines lines;
        std::optional<Error> error;
    };
    [[nodiscard]] static Unwritten write(const AuditLog& log, Lines lines);
    void pump();
    void notePin();
    [[nodiscard]] nlohmann::ordered_json scanShown() const;

    std::optional<AuditLog> log_;
    const Engine& engine_;
    const LinkedViews& views_;
    NoticeBar& notice_;
    Lines lines_; // not written yet
    bool writing_ = false;
    bool failing_ = false;
    std::optional<std::size_t> pinned_;
};

} // namespace edgescan::ui
