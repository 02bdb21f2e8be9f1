// Writes signals of the window as lines of the log.
#include "ui/controllers/audit_trail.h"

#include "core/base/version.h"
#include "core/edges/explain/cell_values.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/in_background.h"

#include <QUndoStack>

namespace edgescan::ui {

using Json = nlohmann::ordered_json;

AuditTrail::AuditTrail(const QString& folder, const Engine& engine, const LinkedViews& views, const QUndoStack& undo, NoticeBar& notice)
    : engine_(engine), views_(views), notice_(notice) {
    if (folder.isEmpty()) return;
    log_.emplace(std::filesystem::path(exactBytes(folder)) / "audit.jsonl");
    connect(&engine, &Engine::streamChanged, this, [this] {
        pinned_.reset();
        note("opened", scanShown());
    });
    connect(&engine, &Engine::saved, this, [this](exports::ExportContent what, const QString& path, qint64 count) {
        noteExport(exports::exportKind(what).record, path, count);
    });
    connect(&views, &LinkedViews::probed, this, [this] { notePin(); });
    connect(&undo, &QUndoStack::indexChanged, this, [this, &undo, last = 0](int index) mutable {
        const bool isUndone = index < last;
        const QString step = undo.text(isUndone ? index : index - 1);
        last = index;
        if (step.isEmpty() || undo.property(kDrops).toBool()) return; // the undo stack was cleared
        Json details = scanShown();
        details["step"] = step.toStdString();
        details["undone"] = isUndone;
        note("changed", details);
    });
    note("started", {{"version", version()}, {"commit", commit()}});
}

AuditTrail::~AuditTrail() {
    if (!log_) return;
    note("ended", Json::object());
    const QObjectList jobs = children(); // running jobs write their lines first, in order
    qDeleteAll(jobs);
    static_cast<void>(write(*log_, std::move(lines_)));
}

void AuditTrail::note(const std::string& event, const Json& details) {
    if (!log_) return;
    lines_.emplace_back(event, details);
    pump();
}

void AuditTrail::noteExport(const std::string& content, const QString& path, std::optional<qint64> count) {
    Json details = scanShown();
    details["content"] = content;
    details["file"] = exactBytes(path);
    if (count) details["count"] = *count;
    note("exported", details);
}

void AuditTrail::noteWarnings(const QStringList& warnings) {
    if (warnings.isEmpty()) return;
    Json details = scanShown();
    details["warnings"] = Json::array();
    for (const QString& warning : warnings) details["warnings"].push_back(warning.toStdString());
    note("warnings", details);
}

void AuditTrail::notePin() {
    const std::optional<std::size_t> pinned = views_.pinned();
    if (std::exchange(pinned_, pinned) == pinned || !pinned || !engine_.picture()) return;
    const edges::Detection& detection = *engine_.picture()->detection;
    if (*pinned >= detection.scan->cells()) return;
    const edges::Probe probe = edges::probeCell(detection, *pinned);
    Json details = scanShown();
    details["line"] = probe.line;
    details["beam"] = probe.beam;
    details["range_mm"] = probe.state == CellState::Valid ? Json(probe.rangeMm) : Json();
    details["edge"] = probe.edge;
    note("pinned", details);
}

// The scan, and the settings with which its edges were found.
Json AuditTrail::scanShown() const {
    if (!engine_.picture()) return Json::object();
    const edges::Detection& detection = *engine_.picture()->detection;
    const Json all = edges::settingsToJson(detection.settings);
    Json settings{{"method", all["method"]}};
    for (const std::string& key : edges::changedFromDefault(detection.settings)) settings[key] = all[key];
    return {{"scan", detection.scan->path},
            {"scan_sha256", detection.scan->sha256},
            {"lines", detection.scan->lines()},
            {"beams", detection.scan->beams()},
            {"settings", settings}};
}

AuditTrail::Unwritten AuditTrail::write(const AuditLog& log, Lines lines) {
    while (!lines.empty()) {
        if (const auto done = log.append(lines.front().first, lines.front().second); !done) return {std::move(lines), done.error()};
        lines.pop_front();
    }
    return {};
}

void AuditTrail::pump() {
    if (writing_ || lines_.empty()) return;
    writing_ = true;
    inBackground(
        this,
        [this, log = *log_, lines = std::exchange(lines_, {})]() -> std::function<void()> {
            Unwritten left = write(log, lines);
            return [this, left = std::move(left)] {
                lines_.insert(lines_.begin(), left.lines.begin(), left.lines.end()); // tried again with the next lines
                const bool fails = left.error.has_value();
                if (fails) // each time: opening a scan removes the notice
                    notice_.showNotice(NoticeBar::Kind::Warning, tr("▲ AUDIT LOG: %1").arg(exactText(left.error->sentence())));
                if (!fails && failing_)
                    notice_.showNotice(NoticeBar::Kind::Done, tr("The audit log is written again; no line is missing."));
                failing_ = fails;
                writing_ = false;
                if (!fails) pump();
            };
        },
        [this](const QString& what) {
            writing_ = false;
            notice_.showNotice(NoticeBar::Kind::Warning, tr("▲ AUDIT LOG: what is done is not noted (%1)").arg(what));
        });
}

} // namespace edgescan::ui

#include "moc_audit_trail.cpp"
