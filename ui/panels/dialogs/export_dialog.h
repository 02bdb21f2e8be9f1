// Asks for the content of an export, its format and its coordinates. Shows the number of points before saving.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/exports/provenance.h"

#include <QDialog>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QGroupBox;
class QLabel;
class QScrollArea;
class QToolButton;

namespace edgescan::ui {

/// Cells, ascending, for an export of the selection only; null: no selection.
struct ExportSelection {
    std::shared_ptr<const std::vector<std::uint32_t>> cells{};
    bool only = false; ///< selected at first
};

class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// `wanted` is selected at first. Mine coordinates are available only if the scan has a pose; otherwise the dialog gives the reason.
    ExportDialog(std::shared_ptr<const edges::Detection> detection, exports::ExportContent wanted, ExportSelection selected = {},
                 QWidget* parent = nullptr);

    /// The formats of clouds, as filters of files: "Point Cloud Library (*.pcd)". Each has the extension that its files get.
    struct Format {
        QString filter, extension;
        bool drawsEdges = false; ///< not for all points
    };
    void offerFormats(const std::vector<Format>& formats, const QString& wanted);
    /// The number of targets that can be exported; at first there are none.
    void offerTargets(std::size_t count);
    /// Those of the formats that the chosen content can have.
    [[nodiscard]] QStringList filters() const;
    /// ".pcd"; of a picture ".png".
    [[nodiscard]] QString extension() const;

    [[nodiscard]] exports::ExportContent content() const;
    [[nodiscard]] exports::ExportOptions options() const;
    /// Number of points, of targets, or of cells of a picture, that would be saved.
    [[nodiscard]] std::size_t count() const;
    /// What the coordinates in the file count from, as a sentence; empty for a picture.
    [[nodiscard]] QString numbersText() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QGroupBox* contentBox();
    [[nodiscard]] QGroupBox* coordinatesBox();
    [[nodiscard]] QString frameHint(CoordinateFrame frame) const;
    [[nodiscard]] QGroupBox* writingBox();
    [[nodiscard]] QLayout* formatRow();
    [[nodiscard]] bool fillsToo() const;
    [[nodiscard]] std::size_t filledToo(bool edges, bool onlySelected) const;
    [[nodiscard]] std::size_t countOf(exports::ExportContent content, bool withAttached, bool onlySelected) const;
    void fit();
    void follow();
    void showCounts();
    void followFormat();
    [[nodiscard]] bool isPicture() const;
    [[nodiscard]] bool canHold(const Format& format) const;
    [[nodiscard]] bool isWanted(std::size_t choice) const;

    std::shared_ptr<const edges::Detection> detection_;
    QButtonGroup* contents_;
    QButtonGroup* coordinates_;
    QScrollArea* area_ = nullptr; // of the questions
    QGroupBox* coordinatesGroup_ = nullptr;
    QToolButton* more_ = nullptr; // shows the questions for the reading program
    QGroupBox* writingGroup_ = nullptr;
    mutable std::optional<std::vector<std::uint32_t>> filledCells_; // computed at first use
    std::vector<QCheckBox*> choices_;                               // in the order of kWritingChoices
    ExportSelection selected_;
    std::size_t targets_ = 0;
    std::vector<Format> formats_; // in the order of the list
    QString wantedFormat_;        // extension of the format that was chosen last
    QComboBox* format_;
    QLabel* picture_; // the only format of pictures
    QCheckBox* onlySelected_;
    QCheckBox* attached_;
    QLabel *count_, *numbers_, *frameHint_;
    QDialogButtonBox* buttons_;
};

} // namespace edgescan::ui
