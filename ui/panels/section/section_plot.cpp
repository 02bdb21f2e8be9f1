// Draws a section.
#include "ui/panels/section/section_plot.h"

#include "core/rocks/attributes/faces.h"
#include "ui/base/cell_marks.h"
#include "ui/base/gestures.h"
#include "ui/base/marks.h"
#include "ui/base/themes.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr double kMargin = 28.0;       // px
constexpr double kReach = 24.0;        // px: a click or the mouse means a vertex within this
constexpr double kTravel = 4.0;        // px: a press that moves farther is a drag
constexpr double kLeastBetween = 60.0; // px between lines of the grid
constexpr double kAround = 0.4;        // of what the section is about, shown on each side of it
constexpr double kLeastAroundM = 0.1;
constexpr int kNamesLeft = 76;      // px: right of the numbers of heights
constexpr double kNearPlane = 0.05; // share of the distance of two vertices and more: a point beyond is not in the section
constexpr double kOutline = 7.0;    // px: of the chosen rock
const QColor kGround(48, 48, 48), kGrid(80, 80, 80), kWords(200, 200, 200), kSurface(170, 170, 170), kEdge(0, 255, 0);

double stepM(double perM) {
    double step = 0.01;
    for (int n = 0; step * perM < kLeastBetween; ++n) step *= n % 3 == 1 ? 2.5 : 2.0;
    return step;
}

std::vector<double> stepsIn(double from, double to, double step) {
    std::vector<double> all;
    for (double at = std::ceil(from / step) * step; at < to; at += step) all.push_back(at);
    return all;
}

/// `faces`: by label, as in the images and the cloud.
QColor colourOf(std::uint32_t rock, const std::vector<std::uint8_t>& faces) {
    if (rock == 0 || rock >= faces.size()) return kSurface;
    const Rgb& colour = rocks::kRockFaceColours[faces[rock]];
    return QColor(colour.red, colour.green, colour.blue).lighter(130);
}

} // namespace

SectionPlot::SectionPlot(QWidget* parent) : QWidget(parent) {
    setObjectName("section-plot");
    setMouseTracking(true);
    setMinimumSize(240, 160);
    setFocusPolicy(Qt::ClickFocus);
}

void SectionPlot::show(std::shared_ptr<const inspect::Section> section, const Eigen::AlignedBox2d& aboutM, const SectionHeights& heights,
                       SectionRocks rocks) {
    section_ = std::move(section);
    rocks_ = std::move(rocks);
    aboutM_ = aboutM;
    heights_ = heights;
    marked_ = nullptr;
    ends_.clear();
    length_.clear();
    all_ = moved_ = false;
    fit();
    update();
    emit viewChanged(); // also without a section
}

void SectionPlot::fit() {
    if (!section_ || moved_) return;
    Eigen::AlignedBox2d box = all_ ? Eigen::AlignedBox2d() : aboutM_;
    if (!box.isEmpty()) { // a wall far behind must not shrink what the section is about
        const Eigen::Vector2d more = Eigen::Vector2d::Constant(std::max(kLeastAroundM, kAround * box.sizes().maxCoeff()));
        box = Eigen::AlignedBox2d(box.min() - more, box.max() + more);
    } else {
        for (const inspect::SectionLine& line : section_->lines) {
            for (const inspect::SectionVertex& vertex : line) box.extend(vertex.atM);
        }
    }
    if (box.isEmpty()) return;
    const Eigen::Vector2d size = box.sizes().cwiseMax(0.01);
    const double below = 2.0 * fontMetrics().height() + 14.0; // px: the numbers, and the name of the axis above them
    const double high = height() - kMargin - below;
    perM_ = std::max(1e-3, std::min((width() - 2 * kMargin) / size.x(), high / size.y()));
    const Eigen::Vector2d middle = box.center();
    origin_ = QPointF(width() / 2.0 - middle.x() * perM_, kMargin + high / 2.0 + middle.y() * perM_);
}

/// On the scale of heights.
double SectionPlot::lowestM() const { return (origin_.y() - height()) / perM_ + heights_.ofOriginM; }
double SectionPlot::highestM() const { return origin_.y() / perM_ + heights_.ofOriginM; }

QPointF SectionPlot::placeOf(const Eigen::Vector2d& atM) const { return origin_ + QPointF(atM.x() * perM_, -atM.y() * perM_); }

const inspect::SectionVertex* SectionPlot::nearest(QPointF place) const {
    const inspect::SectionVertex* best = nullptr;
    double least = kReach * kReach;
    if (!section_) return best;
    for (const inspect::SectionLine& line : section_->lines) {
        for (const inspect::SectionVertex& vertex : line) {
            const QPointF way = placeOf(vertex.atM) - place;
            const double square = QPointF::dotProduct(way, way);
            if (square < least) {
                least = square;
                best = &vertex;
            }
        }
    }
    return best;
}

void SectionPlot::mark(const std::optional<Eigen::Vector3d>& pointM) {
    const inspect::SectionVertex* best = nullptr;
    if (section_ && pointM && pointM->allFinite()) {
        const inspect::SectionPlane& plane = section_->plane;
        const double off = std::abs((*pointM - plane.originM).dot(plane.across.cross(plane.up)));
        double least = std::max(0.2, kNearPlane * (*pointM - plane.originM).norm());
        if (off < least) {
            for (const inspect::SectionLine& line : section_->lines) {
                for (const inspect::SectionVertex& vertex : line) {
                    const double away = (vertex.pointM - *pointM).norm();
                    if (away >= least) continue;
                    least = away;
                    best = &vertex;
                }
            }
        }
    }
    if (best == marked_) return;
    marked_ = best;
    update();
}

void SectionPlot::setEnds(const Eigen::Vector2d& fromM, const Eigen::Vector2d& toM) {
    ends_.clear();
    for (const Eigen::Vector2d& end : {fromM, toM}) {
        const inspect::SectionVertex* best = nullptr;
        for (const inspect::SectionLine& line : section_->lines) {
            for (const inspect::SectionVertex& vertex : line) {
                if (best == nullptr || (vertex.atM - end).norm() < (best->atM - end).norm()) best = &vertex;
            }
        }
        if (best != nullptr) ends_.push_back(best);
    }
    update();
}

void SectionPlot::setLength(const QString& words) {
    length_ = words;
    update();
}

void SectionPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), kGround); // views stay dark in all themes
    if (!section_) return;
    painter.setRenderHint(QPainter::Antialiasing);
    drawGrid(painter);
    drawChosen(painter);
    drawLines(painter);
    std::vector<QRectF> texts = drawScales(painter);
    texts.push_back(numberPlace_ = drawNumber(painter, texts));
    drawMarks(painter, texts);
}

void SectionPlot::drawGrid(QPainter& painter) const {
    const double step = stepM(perM_);
    painter.setPen(kGrid);
    for (const double x : stepsIn(-origin_.x() / perM_, (width() - origin_.x()) / perM_, step)) {
        const double at = placeOf({x, 0.0}).x();
        painter.drawLine(QPointF(at, 0), QPointF(at, height()));
    }
    for (const double y : stepsIn(lowestM(), highestM(), step)) {
        const double at = placeOf({0.0, y - heights_.ofOriginM}).y();
        painter.drawLine(QPointF(0, at), QPointF(width(), at));
    }
}

/// Over the lines, on a plate: a surface runs through them. Returns the boxes that they cover.
std::vector<QRectF> SectionPlot::drawScales(QPainter& painter) const {
    const double step = stepM(perM_);
    const QFontMetrics letters = painter.fontMetrics();
    const int decimals = step < 0.1 ? 2 : step < 1 ? 1 : 0;
    std::vector<QRectF> taken;
    const auto drawStep = [&](const QPointF& at, double value) {
        const QString words = QString::number(value + 0.0, 'f', decimals) + " m";
        const QRectF plate(at.x() - 2, at.y() - letters.ascent(), letters.horizontalAdvance(words) + 4, letters.height());
        if (plate.right() > width()) return;
        taken.push_back(plate);
        painter.fillRect(plate, kGround);
        painter.setPen(kWords);
        painter.drawText(at, words);
    };
    for (const double x : stepsIn(-origin_.x() / perM_, (width() - origin_.x()) / perM_, step))
        drawStep({placeOf({x, 0.0}).x() + 3, height() - 4.0}, x);
    for (const double y : stepsIn(lowestM(), highestM(), step)) {
        const double at = placeOf({0.0, y - heights_.ofOriginM}).y();
        const double above = at - 3 - letters.ascent() >= 0 ? at - 3 : at + letters.ascent() + 1; // the topmost has its words below
        if (above < height() - letters.height()) drawStep({4.0, above}, y);
    }
    const QString along = tr("along the section [m]");
    const int right = width() - letters.horizontalAdvance(along) - 4;
    taken.emplace_back(drawLabel(painter, QRect(right - 8, height() - 2 * letters.height() - 10, width() - right, letters.height() + 6),
                                 Qt::AlignRight | Qt::AlignBottom, along));
    taken.emplace_back(drawLabel(painter, rect().adjusted(kNamesLeft, 10, -8, 0), Qt::AlignLeft | Qt::AlignTop, heights_.name));
    return taken;
}

/// The outline of the chosen rock, below its line.
void SectionPlot::drawChosen(QPainter& painter) const {
    painter.setPen(QPen(Qt::white, kOutline, Qt::SolidLine, Qt::RoundCap));
    for (const inspect::SectionLine& line : section_->lines) {
        for (std::size_t n = 1; n < line.size(); ++n) {
            if (rocks_.chosen == 0 || line[n].rock != rocks_.chosen || line[n - 1].rock != rocks_.chosen) continue;
            painter.drawLine(placeOf(line[n - 1].atM), placeOf(line[n].atM));
        }
    }
}

/// The highest point of the chosen rock that is in sight.
std::optional<QPointF> SectionPlot::topOfChosen() const {
    std::optional<QPointF> top;
    for (const inspect::SectionLine& line : section_->lines) {
        for (const inspect::SectionVertex& vertex : line) {
            const QPointF here = placeOf(vertex.atM);
            const bool isIts = rocks_.chosen != 0 && vertex.rock == rocks_.chosen && isInside(vertex);
            if (isIts && (!top || here.y() < top->y())) top = here;
        }
    }
    return top;
}

bool SectionPlot::coversLine(const QRectF& box) const {
    return std::ranges::any_of(section_->lines, [&](const inspect::SectionLine& line) {
        for (std::size_t n = 1; n < line.size(); ++n) {
            const QRectF way = QRectF(placeOf(line[n - 1].atM), placeOf(line[n].atM)).normalized();
            if (box.intersects(way.adjusted(-kOutline / 2, -kOutline / 2, kOutline / 2, kOutline / 2))) return true;
        }
        return false;
    });
}

/// The number of the chosen rock: above, below or at the side of its highest point, as near as it covers neither a line nor the texts.
/// Returns its box.
QRectF SectionPlot::drawNumber(QPainter& painter, const std::vector<QRectF>& texts) const {
    const auto top = topOfChosen();
    if (!top) return {};
    const QString words = tr("rock %1").arg(rocks_.chosen);
    const QFontMetrics letters = painter.fontMetrics();
    QRectF box(0, 0, letters.horizontalAdvance(words) + 16, letters.height() + 6);
    const double left = std::clamp(top->x() - box.width() / 2, 2.0, std::max(2.0, width() - box.width() - 2));
    const auto isFree = [&](double x, double y) {
        box.moveTopLeft({x, y});
        return QRectF(rect()).contains(box) && std::ranges::none_of(texts, [&](const QRectF& each) { return each.intersects(box); }) &&
               !coversLine(box);
    };
    const double above = top->y() - box.height() - kOutline, below = top->y() + kOutline;
    bool found = false;
    for (double away = 0.0; !found && away < height() + width(); away += box.height() / 2) {
        for (const double aside : {0.0, -away, away})
            found = found || isFree(left + aside, above - away) || isFree(left + aside, below + away) || isFree(left + aside, above);
    }
    if (!found) box.moveTopLeft({left, std::max(0.0, above)});
    drawLabel(painter, box.toRect().adjusted(6, 3, -6, -3), Qt::AlignCenter, words);
    return box;
}

void SectionPlot::drawLines(QPainter& painter) const {
    for (const inspect::SectionLine& line : section_->lines) {
        for (std::size_t n = 1; n < line.size(); ++n) {
            const std::uint32_t rock = line[n].rock == line[n - 1].rock ? line[n].rock : 0;
            painter.setPen(QPen(colourOf(rock, rocks_.faces), rock != 0 ? 3.0 : 1.5));
            painter.drawLine(placeOf(line[n - 1].atM), placeOf(line[n].atM));
        }
    }
    painter.setPen(QPen(Qt::black, 1.0));
    painter.setBrush(kEdge);
    for (const inspect::SectionLine& line : section_->lines) {
        for (const inspect::SectionVertex& vertex : line) {
            if (vertex.edge) painter.drawEllipse(placeOf(vertex.atM), 3.0, 3.0);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

std::size_t SectionPlot::outside() const {
    std::size_t count = 0;
    if (!section_) return count;
    for (const inspect::SectionLine& line : section_->lines) {
        for (const inspect::SectionVertex& vertex : line) count += isInside(vertex) ? 0 : 1;
    }
    return count;
}

bool SectionPlot::isInside(const inspect::SectionVertex& vertex) const { return QRectF(rect()).contains(placeOf(vertex.atM)); }

std::size_t SectionPlot::edgesShown() const {
    std::size_t count = 0;
    if (!section_) return count;
    for (const inspect::SectionLine& line : section_->lines)
        count += static_cast<std::size_t>(
            std::ranges::count_if(line, [this](const inspect::SectionVertex& each) { return each.edge && isInside(each); }));
    return count;
}

/// As in the views: the label of the length covers neither its line nor the texts.
void SectionPlot::drawMarks(QPainter& painter, const std::vector<QRectF>& texts) {
    ScreenMarks::Measure length;
    for (const inspect::SectionVertex* end : ends_) length.ends.push_back(placeOf(end->atM));
    if (ends_.size() == 2) {
        length.lines.emplace_back(length.ends[0], length.ends[1]);
        length.label = length_;
        length.labelAt = length.lines.front().center();
    }
    ScreenMarks marks;
    marks.measures.push_back(length);
    tags_ = drawScreenMarks(painter, rect(), marks, {}, texts);
    painter.setBrush(Qt::NoBrush);
    if (marked_ != nullptr)
        strokeTwice(painter, QPen(QColor(0, 0, 0, 220), 4.0), QPen(Qt::white, 2.0),
                    [&] { painter.drawEllipse(placeOf(marked_->atM), 8.0, 8.0); });
}

void SectionPlot::wheelEvent(QWheelEvent* event) {
    const double steps = notches(*event);
    event->accept();
    if (steps == 0.0) return;
    zoom(std::pow(1.2, steps), event->position());
}

void SectionPlot::zoom(double factor, QPointF about) {
    if (!section_) return;
    const double by = std::clamp(perM_ * factor, 1.0, 1e5) / perM_;
    origin_ = about + by * (origin_ - about);
    perM_ *= by;
    moved_ = true;
    update();
    emit viewChanged();
}

void SectionPlot::zoomTo(Part part) {
    all_ = part == Part::All;
    moved_ = false;
    fit();
    update();
    emit viewChanged();
}

void SectionPlot::mousePressEvent(QMouseEvent* event) {
    press_ = place(*event);
    travelled_ = false;
}

void SectionPlot::mouseMoveEvent(QMouseEvent* event) {
    if (press_ && (travelled_ || QLineF(*press_, place(*event)).length() > kTravel)) {
        origin_ += place(*event) - *press_;
        press_ = place(*event);
        travelled_ = moved_ = true;
        update();
        return emit viewChanged();
    }
    if (const inspect::SectionVertex* vertex = nearest(place(*event))) emit hovered(vertex->cell);
}

void SectionPlot::mouseReleaseEvent(QMouseEvent* event) {
    const bool click = press_ && !travelled_ && event->button() == Qt::LeftButton;
    press_.reset();
    const inspect::SectionVertex* vertex = click ? nearest(place(*event)) : nullptr;
    if (click && section_ && vertex == nullptr) emit clicked(false);
    if (vertex == nullptr) return;
    if (ends_.size() == 2) ends_.clear();
    length_.clear();
    ends_.push_back(vertex);
    update();
    emit clicked(true);
    if (ends_.size() == 2) emit measured(*ends_[0], *ends_[1]);
}

void SectionPlot::resizeEvent(QResizeEvent*) {
    fit();
    emit viewChanged(); // also of a plot that does not fit again
}

} // namespace edgescan::ui

#include "moc_section_plot.cpp"
