// What leaves the program: exports of scan and edges, pictures of the window, the command that computes the same edges.
#pragma once

#include "ui/engine/worker_bridge/engine.h"

#include <QImage>
#include <QObject>

#include <functional>
#include <utility>

namespace edgescan::ui {

class Files;
class Preferences;
class NoticeBar;

/// As a PNG, whole or not at all.
Result<Done> savePng(const QImage& image, const QString& path);

/// GUI thread only. What it is given must outlive it.
class Exports : public QObject {
    Q_OBJECT
public:
    Exports(Engine& engine, const Files& files, NoticeBar& notice, Preferences& preferences);

    /// Asks what, in which coordinates and where to. `extension`: the format chosen at first, ".dxf"; empty: that of the last export.
    void ask(exports::ExportContent wanted, const QString& extension = {});
    /// The same for what is selected alone.
    void askSelected();
    /// Cells, ascending, that an export may be cut down to; none: nothing is selected.
    void setSelection(const std::vector<std::uint32_t>& cells);
    /// The targets of the picture, for when they are exported.
    using TargetList = std::vector<inspect::PinnedTarget>;
    void setTargets(std::function<TargetList()> targets) { targets_ = std::move(targets); }
    /// Asks where to.
    void askScreenshot(const QImage& image);
    /// What a picture of the window carries when it is saved at `path`.
    using Carry = std::function<QImage(const QImage& image, const QString& path)>;
    void setCarried(Carry carry) { carry_ = std::move(carry); }
    Result<Done> saveScreenshot(const QImage& image, const QString& path);
    /// To the clipboard.
    void copyCommand();

signals:
    /// The operator is asked what to write: it is of the engine's picture.
    void asked();

private:
    void askOf(exports::ExportContent wanted, bool selectedOnly, const QString& extension = {});
    void reportSaved(exports::ExportContent what, const QString& path, qint64 count, const QString& coordinates);

    Engine& engine_;
    const Files& files_;
    NoticeBar& notice_;
    Preferences& preferences_;
    std::shared_ptr<const std::vector<std::uint32_t>> selection_; // null: none
    std::function<TargetList()> targets_;
    Carry carry_;
};

} // namespace edgescan::ui
