// The legend over the cloud: what is drawn in which colour, how many there are; each row is the switch of what it names.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "ui/base/view_plate.h"
#include "ui/views/cloud/edge_cells.h"

#include <array>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace edgescan::ui {

/// GUI thread only. Shows what it is told and says what the operator wants.
class EdgeLegend : public ViewPlate {
    Q_OBJECT
public:
    explicit EdgeLegend(QWidget* parent = nullptr);

    void showResult(const Detection& detection);
    void showColours(const EdgeColours& colours);
    void showByClass(bool on);
    void showEdges(bool on);
    /// Rocks are drawn over the edges of the cloud: the counts are of what the images show.
    void showCovered(bool on);
    /// Only the edges and the classes that rocks are known by.
    void setBrief(bool on);
    [[nodiscard]] QCheckBox* edges() const { return edges_; }
    [[nodiscard]] QCheckBox* byClass() const { return byClass_; }
    [[nodiscard]] QLabel* filled() const { return filled_; } ///< how many cells were filled; hidden where none was asked for
    [[nodiscard]] QCheckBox* classSwitch(int n) const { return rows_[static_cast<std::size_t>(n)].box; }

signals:
    void edgesWanted(bool on);
    void byClassWanted(bool on);
    /// EdgeClassBits.
    void classesWanted(int classes);

private:
    struct Row {
        QCheckBox* box = nullptr;
        QLabel* count = nullptr;
    };
    [[nodiscard]] Row addRow(QGridLayout& grid, const QString& name, const char* objectName);
    void showRows();
    void paintSwatches();
    void tellClasses();

    QCheckBox* edges_ = nullptr;
    QLabel* total_ = nullptr;
    std::array<Row, kEdgeClasses> rows_;
    QCheckBox* byClass_ = nullptr;
    QLabel* filled_ = nullptr;
    EdgeColours colours_ = kUsualColours;
    std::array<bool, kEdgeClasses> offered_{}; // by the method
    bool known_ = false;                       // the classes
    bool brief_ = false;
    QLabel* covered_ = nullptr;
    bool showing_ = false;
};

} // namespace edgescan::ui
