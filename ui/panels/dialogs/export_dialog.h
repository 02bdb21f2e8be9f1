// Asks what of a scan to export and in which coordinates, with the count before anything is saved.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/exports/provenance/provenance.h"

#include <QDialog>

#include <memory>
#include <optional>
#include <vector>

class QButtonGroup;
class QCheckBox;
class QDialogButtonBox;
class QGroupBox;
class QLabel;

namespace edgescan::ui {

/// Cells, ascending, that an export may be cut down to; null: there is no selection.
struct ExportSelection {
    std::shared_ptr<const std::vector<std::uint32_t>> cells{};
    bool only = false; ///< chosen at first
};

class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// `wanted` is chosen at first. Mine coordinates can only be chosen when the scan has a place; the reason stands beside them.
    ExportDialog(std::shared_ptr<const Detection> detection, ExportContent wanted, ExportSelection selected = {},
                 QWidget* parent = nullptr);

    [[nodiscard]] ExportContent content() const;
    [[nodiscard]] ExportOptions options() const;
    /// Points, or cells of a picture, that would be saved.
    [[nodiscard]] std::size_t count() const;

private:
    [[nodiscard]] QGroupBox* contentBox();
    [[nodiscard]] QGroupBox* coordinatesBox();
    [[nodiscard]] QGroupBox* writingBox();
    [[nodiscard]] bool fillsToo() const;
    [[nodiscard]] std::size_t filledToo(bool edges, bool onlySelected) const;
    [[nodiscard]] std::size_t countOf(ExportContent content, bool withAttached, bool onlySelected) const;
    void follow();

    std::shared_ptr<const Detection> detection_;
    QButtonGroup* contents_;
    QButtonGroup* coordinates_;
    QGroupBox* coordinatesGroup_ = nullptr;
    QGroupBox* writingGroup_ = nullptr;
    mutable std::optional<std::vector<std::uint32_t>> filledCells_; // once they are asked for
    std::vector<QCheckBox*> choices_;                               // by kWritingChoices
    ExportSelection selected_;
    QCheckBox* onlySelected_;
    QCheckBox* attached_;
    QLabel* count_;
    QDialogButtonBox* buttons_;
};

} // namespace edgescan::ui
