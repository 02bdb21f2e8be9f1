// What a new sweep and a new connection leave behind.
#include "ui/window/scanner_changes.h"

#include "ui/base/core_words.h"
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/panels/live/live_panel.h"
#include "ui/window/viewer.h"

#include <set>

namespace edgescan::ui {
namespace {

struct LeftSweep {
    std::shared_ptr<const Scan> scan;
    PictureSource source;
};

/// Undo holds the sweep again, and its targets are with it.
void offerBack(Viewer& v, const Picture& left) {
    using Step = UndoStep<std::optional<LeftSweep>>;
    const auto show = [&v, stream = left.source.stream, pushed = false](const std::optional<LeftSweep>& sweep) mutable {
        if (!std::exchange(pushed, true)) return true; // the next sweep is on the screen already
        if (v.engine.picture()->source.stream != stream) return false;
        ScannerLink& scanner = v.live.scanner();
        scanner.follow(!sweep);
        if (!sweep) return true;
        PictureSource source = sweep->source;
        source.growth.growing = source.growth.growing && scanner.connected();
        v.engine.follow(sweep->scan, source);
        return true;
    };
    v.undo.push(new Step(stepName("Next Sweep"), LeftSweep{left.detection->scan, left.source}, std::nullopt, show));
    v.notice.showNotice(NoticeBar::Kind::Warning,
                        QObject::tr("Undo brings %1 back with its targets and measurements: the next sweep replaced it.")
                            .arg(scanName(left.detection->scan->name)));
    v.notice.offerUndo(v.undo);
}

void followSweeps(Viewer& v) {
    QObject::connect(&v.engine, &Engine::pictureReady, &v.live, [&v, last = std::shared_ptr<const Picture>()]() mutable {
        const auto left = std::exchange(last, v.engine.picture());
        if (!left || left->source.stream != last->source.stream) return;
        const int before = left->source.growth.sweep, now = last->source.growth.sweep;
        if (before < 0 || now < 0 || before == now) return;
        if (last->source.stream == v.live.scanner().stream() && !v.targets.notebook().empty()) offerBack(v, *left);
        v.views.pin(std::nullopt);
        v.rocks.select({});
    });
}

void followConnections(Viewer& v) {
    struct Scanner {
        QString address;
        std::set<std::uint64_t> streams;          // of its connections
        std::shared_ptr<const Picture> forgotten; // for Undo, which could not read a sweep again
    };
    QObject::connect(&v.live.scanner(), &ScannerLink::connectedChanged, &v.comparing, [&v, scanner = Scanner()](bool connected) mutable {
        if (!connected) return;
        const QString address = QString("%1:%2").arg(v.livePanel.host()).arg(v.livePanel.port());
        if (std::exchange(scanner.address, address) != address) scanner.streams.clear();
        scanner.streams.insert(v.live.scanner().stream());
        const auto a = v.comparing.pictureA();
        if (!a || scanner.streams.contains(a->source.stream)) return;
        scanner.forgotten = a;
        v.comparing.forget();
        v.notice.showNotice(NoticeBar::Kind::Warning,
                            QObject::tr("%1 is no longer compared as A, because it may be of another place. Undo (Ctrl+Z) brings it back.")
                                .arg(scanName(a->detection->scan->name)));
    });
}

} // namespace

void followScanner(Viewer& viewer) {
    followSweeps(viewer);
    followConnections(viewer);
}

} // namespace edgescan::ui
