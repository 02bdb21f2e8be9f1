// The panel "Layers": the scans of one place that are drawn in one cloud.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include <vector>

class QListWidget;
class QPushButton;

namespace edgescan::ui {

struct LayerLine {
    QString name, words, tip; ///< `words`: how it was placed, or why it is not drawn
    QColor colour;
    bool visible = true;
    bool active = false;  ///< its image and edges are on the screen
    bool missing = false; ///< its file could not be read
    bool operator==(const LayerLine&) const = default;
};

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class LayersPanel : public QWidget {
    Q_OBJECT
public:
    explicit LayersPanel(QWidget* parent = nullptr);

    void showLayers(const std::vector<LayerLine>& lines);
    [[nodiscard]] QListWidget* list() const { return list_; }

signals:
    void addRequested();
    /// Indices into the list.
    void visibleRequested(int layer, bool on);
    void activeRequested(int layer);
    void removeRequested(int layer);
    void locateRequested(int layer);
    void targetsRequested(int layer);

private:
    void showButtons();

    QListWidget* list_;
    QPushButton *add_, *activate_, *remove_, *locate_, *targets_;
    std::vector<LayerLine> shown_;
};

} // namespace edgescan::ui
