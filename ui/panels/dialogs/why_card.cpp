// Explains why a cell is an edge.
#include "ui/panels/dialogs/why_card.h"

#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kAround = 12, kTitleBar = 30;    // px, from the views' border
constexpr int kWidest = 420, kNarrowest = 260; // px, of the texts
constexpr int kFrame = 48;                     // px: left and right of the texts, at most
constexpr double kShare = 0.42;                // of narrow views: a cell is free at one of the sides
constexpr int kRing = 16;                      // px around a cell
constexpr int kRim = 12;                       // px
constexpr double kLargerTitle = 1.15;
constexpr int kLines = 12;             // of text, with a picture
constexpr int kFewLines = 7;           // of the answer alone
constexpr double kMargin = 0.05;       // of the depths that are shown, on each side
constexpr double kMostStretched = 5.0; // limit of the exaggeration of depth against width: a flat face looks flat

QLabel* words() {
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setMinimumWidth(kWidest);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

/// The views, without the panels next to them, on the screen.
QRect viewsOf(const QWidget& window) {
    const auto* centre = window.findChild<const QWidget*>("centre");
    const QWidget& views = centre != nullptr ? *centre : window;
    return {views.mapToGlobal(QPoint(0, 0)), views.size()};
}

} // namespace

void ProfileView::show(const edges::EdgeProfile& profile) {
    profile_ = profile;
    update();
}

void ProfileView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = themeInUse();
    painter.fillRect(rect(), theme.base);
    if (profile_.points.empty()) return;
    const edges::DepthsShown depths = edges::depthsShown(profile_);
    const double margin = kMargin * (depths.mostM - depths.leastM) + 1e-3;
    const double nearM = depths.leastM - margin, farM = depths.mostM + margin;
    const auto isShown = [&](const edges::ProfilePoint& point) { return point.awayM >= nearM && point.awayM <= farM; };
    double leftM = 0.0, rightM = 0.0; // of the shown points; the cell itself is at 0
    for (const edges::ProfilePoint& point : profile_.points) {
        if (!isShown(point)) continue;
        leftM = std::min(leftM, point.acrossM);
        rightM = std::max(rightM, point.acrossM);
    }
    const bool all = std::ranges::all_of(profile_.points, isShown);
    const double wide = std::max(1e-3, rightM - leftM), deep = farM - nearM;
    const QString way = profile_.along == edges::Along::Beams ? tr("along the line") : tr("across the lines");
    const auto metres = [](double length) { return QString::number(length, 'f', 3); };
    const auto wordsBelow = [&](double stretched) {
        const QString times = QString::number(stretched, 'f', stretched < 1.0 ? 2 : 1);
        const QString words = tr("%1: %2 m wide, %3 m deep (drawn × %4), near is below")
                                  .replace(QString("× "), QString("×\u00A0")) // no line ends between them
                                  .arg(way, metres(wide), metres(deep), times);
        return all ? words : words + tr("; ▲ ▼: points beyond it");
    };
    const QRect wrapped = fontMetrics().boundingRect(QRect(0, 0, width() - 2 * kRim, height()), Qt::TextWordWrap,
                                                     wordsBelow(0.0)); // its widest number; two lines in some languages
    const QRectF room = QRectF(rect()).adjusted(kRim, kRim, -kRim, -kRim - wrapped.height());
    const double perAcross = room.width() / wide, perAway = std::min(room.height() / deep, kMostStretched * perAcross);
    const QString below = wordsBelow(perAway / perAcross);
    // Near is at the bottom, on the side of the scanner.
    const double top = room.center().y() - perAway * deep / 2;
    const auto at = [&](double across, double away) {
        return QPointF(room.left() + (across - leftM) * perAcross, top + (farM - away) * perAway);
    };
    painter.setClipRect(room.adjusted(-kRim, -kRim, kRim, kRim));
    for (const auto& line : profile_.sides) {
        const auto isInRoom = [&](double awayM) { return awayM >= nearM && awayM <= farM; };
        if (!line || !isInRoom(line->fromAwayM) || !isInRoom(line->toAwayM)) continue; // it leads to points beyond it
        painter.setPen(QPen(theme.accent, 2.0));
        painter.drawLine(at(line->fromAcrossM, line->fromAwayM), at(line->toAcrossM, line->toAwayM));
    }
    for (const edges::ProfilePoint& point : profile_.points) {
        painter.setPen(QPen(theme.text, 1.2));
        painter.setBrush(point.side == 0 ? QBrush(theme.text) : Qt::NoBrush);
        const double radius = point.side == 0 ? 4.5 : 2.5;
        if (isShown(point)) {
            painter.drawEllipse(at(point.acrossM, point.awayM), radius, radius);
            continue;
        }
        const QPointF tip = at(std::clamp(point.acrossM, leftM, rightM), point.awayM > farM ? farM : nearM);
        const double down = point.awayM > farM ? 2.0 * radius : -2.0 * radius; // it points to where the point is
        painter.setBrush(theme.text);
        painter.drawPolygon(QPolygonF(QVector<QPointF>{tip, tip + QPointF(-radius, down), tip + QPointF(radius, down)}));
    }
    painter.setClipping(false);
    painter.setPen(theme.quietText);
    painter.drawText(QRect(kRim, height() - 2 - wrapped.height(), width() - 2 * kRim, wrapped.height()), Qt::TextWordWrap, below);
}

WhyCard::WhyCard(QWidget* parent)
    : QDialog(parent), plain_(words()), cell_(words()), verdict_(words()), title_(new QLabel(tr("Numbers"))), numbers_(words()),
      below_(new QLabel), beside_(new QPushButton(tr("Why the edge %1 cells away?").arg(2))), more_(new QPushButton(tr("More"))),
      picture_(new ProfileView) {
    setObjectName("why-card");
    setWindowTitle(tr("Why"));
    auto* question = new QLabel(tr("Why is this cell an edge or not?")); // also where no desktop draws the title of a window
    question->setObjectName("why-question");
    question->setWordWrap(true);
    cell_->setObjectName("why-cell");
    verdict_->setObjectName("why-verdict");
    plain_->setObjectName("why-plain");
    numbers_->setObjectName("why-numbers");
    QFont bold = plain_->font();
    bold.setBold(true);
    for (QLabel* each : {plain_, title_}) each->setFont(bold);
    bold.setPointSizeF(kLargerTitle * bold.pointSizeF());
    question->setFont(bold);
    plain_->hide();
    picture_->setFixedHeight(130);
    below_->setText(tr("The points across the cell, and a line through the nearest of either side."));
    below_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    more_->setObjectName("why-more");
    more_->setCheckable(true);
    more_->setAutoDefault(false);
    more_->setToolTip(tr("The verdict in the method's terms, the points across the cell, and the numbers"));
    buttons->addButton(more_, QDialogButtonBox::ActionRole);
    connect(more_, &QPushButton::toggled, this, &WhyCard::showMore);
    beside_->setObjectName("why-nearest-edge");
    beside_->setAutoDefault(false);
    beside_->hide();
    connect(beside_, &QPushButton::clicked, this, &WhyCard::nearestEdgeRequested);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    for (QWidget* each : std::initializer_list<QWidget*>{plain_, cell_, verdict_, picture_, below_, title_, numbers_})
        column->addWidget(each);
    column->addStretch(1);
    content_ = scrolled(*content);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(question);
    layout->addWidget(content_, 1);
    layout->addStretch(0);
    layout->addWidget(beside_); // above Close: next to it, the card would be wider than its text
    layout->addWidget(buttons);
}

/// Before it is shown: the next texts do not change its size.
void WhyCard::fit() {
    const QRect views = parentWidget() == nullptr ? QRect() : viewsOf(*parentWidget());
    const int wide = views.isEmpty() ? kWidest : static_cast<int>(kShare * views.width()) - kFrame;
    const int clamped = std::clamp(wide, kNarrowest, kWidest);
    for (QLabel* each : {plain_, cell_, verdict_, numbers_}) each->setMinimumWidth(clamped);
    content_->widget()->ensurePolished();
    content_->setFixedWidth(clamped + content_->verticalScrollBar()->sizeHint().width());
    content_->setMaximumHeight(0);
    const int room =
        std::min(views.isEmpty() ? screen()->availableGeometry().height() : views.height(), screen()->availableGeometry().height());
    const int others = layout()->minimumSize().height() + kTitleBar + 2 * kAround;
    const int most =
        more_->isChecked() ? kLines * fontMetrics().lineSpacing() + picture_->height() : kFewLines * fontMetrics().lineSpacing();
    const int high = std::min(most, room - others);
    resize(layout()->minimumSize() + QSize(0, high));
    endWithWholeLine();
}

/// The texts have the room that the buttons leave, less what would be a part of a line.
void WhyCard::endWithWholeLine() {
    content_->setMaximumHeight(QWIDGETSIZE_MAX);
    layout()->activate();
    const QWidget& texts = *content_->widget();
    texts.layout()->activate();
    const int room = content_->viewport()->height();
    if (texts.height() <= room) return;
    int end = 0;
    for (const QWidget* each : texts.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!each->isVisibleTo(&texts)) continue;
        // A part of the drawing is better than an empty half of the card.
        const int step = qobject_cast<const QLabel*>(each) != nullptr ? each->fontMetrics().lineSpacing() : 1;
        for (int at = each->y() + step; at <= std::min(room, each->geometry().bottom() + 1); at += step) end = std::max(end, at);
    }
    if (end > 0) content_->setMaximumHeight(end + content_->height() - room);
    layout()->activate();
}

void WhyCard::endWithWholeLineSoon() { QMetaObject::invokeMethod(this, &WhyCard::endWithWholeLine, Qt::QueuedConnection); }

void WhyCard::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    endWithWholeLineSoon();
}

void WhyCard::showPlain(const QString& sentence) {
    plain_->setText(sentence);
    plain_->setHidden(sentence.isEmpty());
}

void WhyCard::showCell(const QString& words, const QVector<QPoint>& places, const QVector<QPoint>& others) {
    cell_->setText(words);
    places_ = places;
    others_ = others;
}

/// In the corner of the views, or next to the cell in an image, where it covers the cell in the fewest of them, above all not in the cloud;
/// where each place covers it there, over the panels. Of equal places the one that covers fewer targets. A card that is open moves only if
/// it covers the cell and can do better.
void WhyCard::placeNextToCell() {
    constexpr int kInCloud = 10000, kPanels = 3000, kInImage = 1000, kOnLabel = 500, kLabelWide = 210, kLabelHigh = 28;
    const QRect views = viewsOf(*parentWidget()), window = parentWidget()->frameGeometry();
    const auto covered = [&](const QPoint& at) {
        const QRect card = QRect(at, size()).adjusted(-kRing, -kRing - kTitleBar, kRing, kRing);
        int count = at.x() + width() > views.right() ? kPanels : 0;
        for (int n = 0; n < places_.size(); ++n) {
            const QRect label(places_[n] - QPoint(0, kLabelHigh), QSize(kLabelWide, kLabelHigh));
            count += card.contains(places_[n]) ? (n == 0 ? kInCloud : kInImage) : n == 0 && card.intersects(label) ? kOnLabel : 0;
        }
        return count + static_cast<int>(std::ranges::count_if(others_, [&](const QPoint& other) { return card.contains(other); }));
    };
    const int right = views.right() - width() - kAround, left = views.left() + kAround, beyond = window.right() - width() - kAround;
    const int top = views.top() + kAround + kTitleBar, bottom = std::max(top, views.bottom() - height() - kAround);
    std::vector<QPoint> tried{{right, top}, {left, top}, {right, bottom}, {left, bottom}, {beyond, top}, {beyond, bottom}};
    for (int n = 1; n < places_.size(); ++n) {
        const int next = std::min(places_[n].x() + kRing + 1, right);
        tried.insert(tried.end(), {{next, top}, {next, bottom}});
    }
    const QPoint best = *std::ranges::min_element(tried, {}, covered); // the first of equal ones
    if (!isVisible() || (covered(pos()) >= kInImage && covered(best) < covered(pos()))) move(best);
}

void WhyCard::showExplanation(const QString& verdict, const edges::EdgeProfile& profile, const QString& numbers) {
    verdict_->setText(verdict);
    picture_->show(profile);
    numbers_->setText(numbers);
    showParts();
    if (!isVisible()) fit();
    if (parentWidget() != nullptr) placeNextToCell();
    show();
    raise();
    endWithWholeLineSoon();
}

void WhyCard::showParts() {
    const bool all = more_->isChecked();
    verdict_->setVisible(all || plain_->isHidden());
    for (QWidget* each : std::initializer_list<QWidget*>{picture_, below_}) each->setVisible(all && picture_->profile().points.size() > 2);
    for (QLabel* each : {title_, numbers_}) each->setVisible(all && !numbers_->text().isEmpty());
}

void WhyCard::showMore() {
    more_->setText(more_->isChecked() ? tr("Less") : tr("More"));
    showParts();
    fit();
    if (parentWidget() == nullptr) return;
    const int beyond = frameGeometry().bottom() - viewsOf(*parentWidget()).bottom() + kAround;
    if (beyond > 0) move(x(), y() - beyond);
    placeNextToCell();
}

void WhyCard::offerNearestEdge(int cells) {
    if (cells > 0) beside_->setText(cells == 1 ? tr("Why the edge next to it?") : tr("Why the edge %1 cells away?").arg(cells));
    beside_->setVisible(cells > 0);
    endWithWholeLineSoon();
}

QString WhyCard::text() const { return numbers_->text().isEmpty() ? verdict_->text() : numbers_->text() + "\n" + verdict_->text(); }

QString WhyCard::verdict() const { return verdict_->text(); }
QString WhyCard::cell() const { return cell_->text(); }

} // namespace edgescan::ui

#include "moc_why_card.cpp"
