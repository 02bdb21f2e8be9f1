// A section in true scale: one metre is as long across as upwards.
#pragma once

#include "core/inspect/section/section.h"
#include "ui/base/cell_marks.h"

#include <Eigen/Geometry>

#include <QString>
#include <QWidget>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

/// What the heights of a section count from.
struct SectionHeights {
    double ofOriginM = 0.0; ///< of (0, 0) of the section
    QString name{};         ///< of the axis, with its unit
};

/// How rocks are drawn.
struct SectionRocks {
    std::vector<std::uint8_t> faces{}; ///< colours, as in RockPicture::colours
    std::uint32_t chosen = 0; ///< label of the rock that the section was asked for, marked by a white outline and its number; 0: none
};

/// Wheel: zoom; drag: move; click: the ends of a length. GUI thread only. Displays the values it is given and signals the operator's
/// choices.
class SectionPlot : public QWidget {
    Q_OBJECT
public:
    enum class Part { About, All }; ///< what the section is about, or all its points

    explicit SectionPlot(QWidget* parent = nullptr);

    /// Null: no section. Shows `aboutM`, across and up, with a margin; all of it if that box is empty. Wheel and zoomTo() show the rest.
    void show(std::shared_ptr<const inspect::Section> section, const Eigen::AlignedBox2d& aboutM = {}, const SectionHeights& heights = {},
              SectionRocks rocks = {});
    [[nodiscard]] const SectionHeights& heights() const { return heights_; }
    /// Vertices that the plot is too narrow to show at this zoom.
    [[nodiscard]] std::size_t outside() const;
    /// Vertices that are edges and in the plot at this zoom.
    [[nodiscard]] std::size_t edgesShown() const;
    [[nodiscard]] const std::shared_ptr<const inspect::Section>& section() const { return section_; }
    /// A ring at the vertex nearest to this point, if it is near the plane; empty: none.
    void mark(const std::optional<Eigen::Vector3d>& pointM);
    [[nodiscard]] const inspect::SectionVertex* marked() const { return marked_; }
    /// The vertices nearest to two points are the ends of the length, as if they had been clicked.
    void setEnds(const Eigen::Vector2d& fromM, const Eigen::Vector2d& toM);
    [[nodiscard]] const std::vector<const inspect::SectionVertex*>& ends() const { return ends_; }
    /// Of the length between the two ends.
    void setLength(const QString& words);
    /// About this place, pixels.
    void zoom(double factor, QPointF about);
    void zoomTo(Part part);
    [[nodiscard]] const QString& lengthShown() const { return length_; }
    /// The label of the length, where it was drawn last.
    [[nodiscard]] const std::vector<MarkTag>& tags() const { return tags_; }
    /// The number of the chosen rock, where it was drawn last; null: none.
    [[nodiscard]] const QRectF& numberPlace() const { return numberPlace_; }
    [[nodiscard]] QPointF placeOf(const Eigen::Vector2d& atM) const;
    [[nodiscard]] QSize sizeHint() const override { return {640, 420}; }

signals:
    /// Other vertices are in the plot, perhaps.
    void viewChanged();
    /// A click; true if a vertex is near enough to it to be an end of the length.
    void clicked(bool found);
    /// The vertex under the mouse.
    void hovered(std::size_t cell);
    /// Two vertices were clicked.
    void measured(const edgescan::inspect::SectionVertex& from, const edgescan::inspect::SectionVertex& to);

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    [[nodiscard]] bool isInside(const inspect::SectionVertex& vertex) const;
    [[nodiscard]] double lowestM() const;
    [[nodiscard]] double highestM() const;
    [[nodiscard]] const inspect::SectionVertex* nearest(QPointF place) const;
    void drawGrid(QPainter& painter) const;
    std::vector<QRectF> drawScales(QPainter& painter) const;
    void drawLines(QPainter& painter) const;
    void drawChosen(QPainter& painter) const;
    [[nodiscard]] std::optional<QPointF> topOfChosen() const;
    [[nodiscard]] bool coversLine(const QRectF& box) const;
    [[nodiscard]] QRectF drawNumber(QPainter& painter, const std::vector<QRectF>& texts) const;
    void drawMarks(QPainter& painter, const std::vector<QRectF>& texts);

    std::shared_ptr<const inspect::Section> section_;
    Eigen::AlignedBox2d aboutM_;
    SectionHeights heights_;
    SectionRocks rocks_;
    double perM_ = 50.0; // pixels
    QPointF origin_;     // of (0, 0), pixels
    bool all_ = false;   // is shown, not only aboutM_
    bool moved_ = false; // by the operator: a new size does not fit it again
    std::optional<QPointF> press_;
    bool travelled_ = false;
    const inspect::SectionVertex* marked_ = nullptr; // of section_
    std::vector<const inspect::SectionVertex*> ends_;
    QString length_;
    std::vector<MarkTag> tags_;
    QRectF numberPlace_;
};

} // namespace edgescan::ui
