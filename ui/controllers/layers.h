// Layers: other scans of the same place in the cloud, each at the place that poses, surfaces or targets give it.
#pragma once

#include "core/base/inputs.h"
#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/works.h"
#include "ui/panels/layers/layer_loading.h"

#include <QObject>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>
#include <vector>

class QUndoStack;

namespace edgescan::ui {

class Engine;
class Files;
class LayersPanel;
class LinkedViews;
class NoticeBar;
class Preferences;
class Targets;

/// GUI thread only. The objects passed to it must outlive it.
class Layers : public QObject {
    Q_OBJECT
public:
    Layers(Engine& engine, LinkedViews& views, Files& files, Targets& targets, LayersPanel& panel, NoticeBar& notice,
           Preferences& preferences, QUndoStack& undo);

    /// A new picture is on the screen: of a layer, which is then the active one, or of another scan, which ends the layers.
    void followPicture();
    void ask();
    /// Each change of the list is one undo step. A path that is in the list already adds the next scan of that file.
    void add(const QStringList& paths);
    void remove(int layer);
    void setVisible(int layer, bool on);
    /// Opens the layer's scan; the scan on the screen becomes a layer.
    void activate(int layer);
    /// Places it by the targets that have the same numbers in both scans.
    void placeByTargets(int layer);
    /// The layer's file is at another place.
    void locate(int layer, const QString& path);

    /// With the scan on the screen; empty: there are no layers.
    [[nodiscard]] std::vector<inspect::Layer> part() const;
    void setPart(const std::vector<inspect::Layer>& part);
    /// True if no layer is being read.
    [[nodiscard]] bool settled() const { return !loader_.behind(); }

signals:
    void changed();
    void shownChanged(bool some);

private:
    struct Held {
        inspect::Layer layer;
        std::shared_ptr<const CloudGeometry> cloud{}; ///< null: not read yet
        std::shared_ptr<const InputClaims> inputs{};
        QString trouble{}; ///< why it is not drawn
    };
    using Loaded = Result<LoadedLayer>;
    void change(const QString& what, std::vector<inspect::Layer> after);
    bool use(const std::vector<inspect::Layer>& layers);
    void loadNext(const std::vector<inspect::PointPair>& pairs = {});
    void load(std::size_t layer, const std::vector<inspect::PointPair>& pairs);
    void finishLoading(const LayerAsked& asked, const Loaded& loaded);
    void placeAgain();
    void show();
    [[nodiscard]] Held* of(const inspect::SessionScan& scan);
    [[nodiscard]] Held* other(int layer);
    [[nodiscard]] bool isActive(const Held& held) const;
    [[nodiscard]] const Scan* shownScan() const;
    [[nodiscard]] std::map<int, inspect::PointPair> targetsInBoth(const Held& held) const; // by number

    Engine& engine_;
    LinkedViews& views_;
    Files& files_;
    Targets& targets_;
    LayersPanel& panel_;
    NoticeBar& notice_;
    Preferences& preferences_;
    QUndoStack& undo_;
    std::vector<Held> layers_;
    std::optional<inspect::NotebookScan> active_; ///< the layer on the screen
    std::weak_ptr<const Scan> activeScan_;        ///< as it was read
    std::vector<int> drawn_;                      ///< by index of the cloud's layers: place in the list
    std::unique_ptr<Works::Running> work_;
    Derived<LayerAsked, Loaded> loader_; // last
};

} // namespace edgescan::ui
