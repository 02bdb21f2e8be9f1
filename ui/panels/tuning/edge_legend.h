// The legend of edges: the colour and count of each class. Each row is a switch of its class.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "ui/views/cloud/edge_cells.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class EdgeLegend : public QWidget {
    Q_OBJECT
public:
    explicit EdgeLegend(QWidget* parent = nullptr);

    void showResult(const edges::Detection& detection);
    void showColours(const EdgeColours& colours);
    void showByClass(bool on);
    /// The number of cells of each strength, while the views draw edges by strength. `leastPercent`: less likely ones are left out.
    void showStrengths(const std::optional<std::array<std::size_t, kEdgeStrengths>>& cells, int leastPercent = 0);
    void showEdges(bool on);
    /// On: rocks are drawn over the edges of the cloud; the counts then refer to the images, and the switch draws the edges over the rocks.
    void showCovered(bool on);
    /// In a cab: one row, the switch of edges. Its button opens the classes of rocks, the rims of open voids and other classes that have
    /// edges.
    void setBrief(bool on);
    [[nodiscard]] QCheckBox* edges() const { return edges_; }
    [[nodiscard]] QToolButton* unfold() const { return unfold_; }
    [[nodiscard]] QCheckBox* byClass() const { return byClass_; }
    [[nodiscard]] QLabel* filled() const { return filled_; } ///< number of filled cells; hidden if filling is off
    [[nodiscard]] QCheckBox* classSwitch(int n) const { return rows_[static_cast<std::size_t>(n)].box; }

signals:
    void edgesRequested(bool on);
    /// The switch was pressed while rocks covered the edges.
    void overRocksRequested(bool on);
    void byClassRequested(bool on);
    /// Bits of EdgeClassBits.
    void classesRequested(int classes);
    /// Its button was pressed, not in a cab.
    void unfolded(bool open);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Row {
        QCheckBox* box = nullptr;
        QLabel* count = nullptr;
    };
    [[nodiscard]] Row addRow(QGridLayout& grid, const QString& name, const char* objectName);
    void showRows();
    void fold();
    void breakNames();
    void showTick();
    void placeHead();
    void paintSwatches();
    [[nodiscard]] QLabel* addSign(QGridLayout& grid, const char* name);
    void addOthers(QGridLayout& grid);
    void showMissing(const Scan& scan);
    void emitClasses();

    QHBoxLayout* foot_ = nullptr; // the lowest row, used in a cab
    QCheckBox* edges_ = nullptr;
    QLabel* total_ = nullptr;
    std::array<Row, kEdgeClasses> rows_;
    int leastPercent_ = 0;
    std::array<QLabel*, kEdgeStrengths> strengths_{}; // with their signs before them
    QCheckBox* byClass_ = nullptr;
    QLabel* filled_ = nullptr;
    QLabel *missing_ = nullptr, *status_ = nullptr; // hatched cells, each with its sign before it; empty: the scan has none
    QLabel* ray_ = nullptr;
    EdgeColours colours_ = kUsualColours;
    std::array<bool, kEdgeClasses> offered_{}; // the classes of the method
    bool known_ = false;                       // the counts of the classes are known
    bool brief_ = false;
    bool openAtDesk_ = true; // what the operator left
    bool areOn_ = true, isCovered_ = false, isFilled_ = false, byStrength_ = false;
    QLabel* covered_ = nullptr;
    QToolButton* unfold_ = nullptr; // on: the rows are shown
    QLabel* taken_ = nullptr;       // where the cells of a class that is off went; empty: nowhere
    bool showing_ = false;
};

} // namespace edgescan::ui
