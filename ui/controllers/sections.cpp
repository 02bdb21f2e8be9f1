// Sections.
#include "ui/controllers/sections.h"

#include "core/files/open_save/save_scan.h"
#include "core/inspect/measure/cell_target.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/section/section_card.h"
#include "ui/panels/section/section_plot.h"
#include "ui/views/cloud/sight.h"
#include "ui/views/image/image_view.h"

#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace edgescan::ui {

namespace {

/// RL where the scan has a place in the mine, else the height above the scanner.
SectionHeights heightsOf(const Scan& scan, const inspect::SectionPlane& plane) {
    if (scan.placement) {
        const Eigen::Vector3d origin = localMinePoint(scan, scan.lines() / 2, scan.beams() / 2, plane.originM);
        return {origin.z() + scan.placement->originEnhM.z(), Sections::tr("RL [m]")};
    }
    return {(plane.originM - CartesianTables(scan).sensor()).dot(plane.up), Sections::tr("above the scanner [m]")};
}

/// Where the section meets the rock: its other cells, such as single points far in front of it, are not in the plot. Empty for rock 0.
Eigen::AlignedBox2d boxOf(const inspect::Section& section, std::uint32_t rock) {
    Eigen::AlignedBox2d box;
    if (rock == 0) return box;
    for (const inspect::SectionLine& line : section.lines) {
        for (const inspect::SectionVertex& vertex : line) {
            if (vertex.rock == rock) box.extend(vertex.atM);
        }
    }
    return box;
}

std::vector<std::vector<std::size_t>> cellsOf(const inspect::Section& section) {
    std::vector<std::vector<std::size_t>> lines;
    for (const inspect::SectionLine& line : section.lines) {
        auto& cells = lines.emplace_back();
        for (const inspect::SectionVertex& vertex : line) {
            if (cells.empty() || cells.back() != vertex.cell) cells.push_back(vertex.cell);
        }
    }
    return lines;
}

/// As large as leaves most of the window and half of the cloud in sight.
QSize usualSize(const SectionCard& card, const QWidget& window, const QSize& cloud) {
    constexpr double kPart = 0.45; // of the window
    const QSize least(560, 360),
        most(std::min(static_cast<int>(kPart * window.width()), cloud.width() / 2), static_cast<int>(kPart * window.height()));
    return card.sizeHint().boundedTo(most.expandedTo(least));
}

int areaOf(const QRect& rect) { return rect.isEmpty() ? 0 : rect.width() * rect.height(); }

/// Low in the window, or low or high in its cloud. Where it covers the least of what is cut, then of
/// panels and tables. All on the screen.
void moveAside(SectionCard& card, const QWidget& window, const QRect& cloud, const QRect& cut) {
    const QSize size = card.frameGeometry().size();
    constexpr double kWideRoom = 1.8; // of its width: there is room for what is cut, next to it
    std::vector<QRect> panels;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        if (dock->isVisible() && !dock->isFloating()) panels.emplace_back(dock->mapToGlobal(QPoint()), dock->size());
    }
    constexpr int kParts = 50; // a rim of what is cut is not worth a panel
    const auto covered = [&](const QPoint& at) {
        const QRect place(at, size);
        int ofPanels = 0;
        for (const QRect& panel : panels) ofPanels += areaOf(place.intersected(panel));
        return std::pair(kParts * areaOf(place.intersected(cut)) / std::max(1, areaOf(cut)), ofPanels);
    };
    const QRect whole(window.mapToGlobal(QPoint()), window.size());
    std::vector<QPoint> places;
    const QRect top(cloud.topLeft(), QSize(cloud.width(), std::min(cloud.height(), size.height())));
    for (const QRect& room : {whole, cloud, top}) {
        if (room.width() < size.width() || room.height() < size.height()) continue;
        const int y = room.bottom() - size.height();
        const QPoint atLeft(room.left(), y), inMiddle(room.center().x() - size.width() / 2, y), atRight(room.right() - size.width(), y);
        if (room.width() < kWideRoom * size.width())
            places.insert(places.end(), {inMiddle, atLeft, atRight});
        else
            places.insert(places.end(), {atLeft, atRight, inMiddle});
    }
    card.move(places.empty() ? whole.topLeft() : *std::ranges::min_element(places, {}, covered)); // the first of equal ones
}

} // namespace

Sections::Sections(Engine& engine, LinkedViews& views, Rocks& rocks, Targets& targets, NoticeBar& notice, Preferences& preferences)
    : engine_(engine), views_(views), rocks_(rocks), targets_(targets), notice_(notice), preferences_(preferences),
      sections_(
          Urgency::Now,
          [](const Question& question) {
              std::optional<Grid<std::uint32_t>> labels;
              if (question.rocks) labels = rocks::rockLabels(*question.rocks->segmentation, question.rocks->map);
              return inspect::sectionOf(*question.picture->detection, question.plane, labels ? &*labels : nullptr);
          },
          [this](const Question& question, const std::shared_ptr<const inspect::Section>& section) { showSection(question, section); },
          [this](const QString& what) {
              notice_.showNotice(NoticeBar::Kind::Warning, tr("The section could not be computed (%1).").arg(what));
          }) {
    connect(&views_, &LinkedViews::probed, this, [this](const std::optional<edges::Probe>& probe) {
        if (card_ != nullptr && card_->isVisible()) card_->plot().mark(probe ? std::optional(probe->pointM) : std::nullopt);
    });
    connect(&views_, &LinkedViews::cellMenuOpens, this, [this](QMenu& menu, const inspect::ClickedCell& click) {
        auto* rock = menu.findChild<QMenu*>(kRockMenu);
        if (rock == nullptr) return;
        rock->addAction(tr("Se&ction"), this, [this, click] {
            rocks_.select({rocks_.rockCellAt(click).value_or(click.clicked)});
            throughRock();
        });
    });
    connect(&rocks_, &Rocks::sectionRequested, this, &Sections::throughRock);
    connect(&rocks_, &Rocks::selectionChanged, this, [this] {
        if (rocks_.chosen()) notice_.withdraw({askRock()}); // it was done
    });
    connect(&views_, &LinkedViews::newScanShown, this, [this] {
        if (card_ == nullptr) return;
        card_->plot().show(nullptr); // a plane of another scan has no meaning
        card_->hide();
    });
}

std::shared_ptr<const rocks::Study> Sections::study() const {
    const auto& shown = rocks_.picture();
    if (!shown || rocks_.behind()) return nullptr;
    return std::shared_ptr<const rocks::Study>(shown, &shown->study);
}

void Sections::throughMeasurement() {
    const auto& measures = targets_.notebook().measures;
    if (!engine_.picture() || measures.empty()) {
        notice_.showHint(tr("Measure a distance first: a section goes through its two ends."));
        return;
    }
    const std::size_t place = targets_.chosenMeasure().value_or(measures.size() - 1);
    const auto [from, to] = inspect::linksOf(measures[place].kind).front();
    std::vector<std::uint32_t> ends{measures[place].cells[from], measures[place].cells[to]};
    std::ranges::sort(ends, {}, [&](std::uint32_t k) { return views_.placeOf(k).x(); }); // left and right as in the range image
    const auto& lines = views_.gray().marks().measures;
    ask(inspect::planeThrough(*engine_.picture()->detection->scan, ends[0], ends[1]), ends, 0,
        place < lines.size() ? lines[place].label : QString());
}

QString Sections::askRock() { return tr("Select a rock first: show the rocks and click on the face of one."); }

void Sections::throughRock() {
    const std::shared_ptr<const rocks::Study> rocks = study();
    const std::uint32_t label = rocks && rocks_.chosen() ? rocks_.picture()->labelAt(*rocks_.chosen()) : 0;
    if (label == 0) {
        notice_.showHint(askRock());
        return;
    }
    std::vector<std::uint32_t> cells;
    const auto& labels = rocks_.picture()->labels.cells;
    for (std::uint32_t k = 0; k < labels.size(); ++k) {
        if (labels[k] == label) cells.push_back(k);
    }
    ask(inspect::planeThroughRock(*rocks_.picture()->detection->scan, cells), cells, label);
}

void Sections::ask(const Result<inspect::SectionPlane>& plane, const std::vector<std::uint32_t>& cells, std::uint32_t rock,
                   const QString& length) {
    if (!plane) return notice_.showError(plane.error());
    const CartesianTables points(*engine_.picture()->detection->scan);
    Eigen::AlignedBox2d about;
    std::vector<Eigen::Vector2d> ends;
    for (const std::uint32_t k : cells) {
        const Eigen::Vector3d way = points.point(k) - plane->originM;
        if (!way.allFinite()) continue;
        const Eigen::Vector2d at(way.dot(plane->across), way.dot(plane->up));
        about.extend(at);
        if (rock == 0) ends.push_back(at);
    }
    const auto rocks = study();
    sections_.ask({engine_.picture(), *plane, rocks, about, rocks ? SectionRocks{rocks_.picture()->colours, rock} : SectionRocks{}, ends,
                   length, cells});
}

void Sections::showSection(const Question& question, const std::shared_ptr<const inspect::Section>& section) {
    if (!engine_.picture() || question.picture->source.stream != engine_.picture()->source.stream) return;
    if (section->lines.empty()) {
        notice_.showHint(tr("The plane of the section meets no surface: choose two other cells."));
        return;
    }
    if (card_ == nullptr) {
        card_ = new SectionCard(notice_.window());
        card_->resize(usualSize(*card_, *notice_.window(), views_.cloud().size()));
        connect(card_, &SectionCard::closed, this, [this] { views_.setCut({}); });
        connect(card_->exportButton(), &QPushButton::clicked, this, &Sections::askExport);
        connect(&card_->plot(), &SectionPlot::measured, this, &Sections::showLength);
        connect(&card_->plot(), &SectionPlot::hovered, this, [this](std::size_t cell) { views_.pointAt(cell); });
    }
    picture_ = question.picture;
    const Eigen::AlignedBox2d ofRock = boxOf(*section, question.drawn.chosen);
    card_->plot().show(section, ofRock.isEmpty() ? question.aboutM : ofRock, heightsOf(*question.picture->detection->scan, section->plane),
                       question.drawn);
    if (question.endsM.size() == 2) {
        card_->plot().setEnds(question.endsM[0], question.endsM[1]);
        card_->plot().setLength(question.length);
    }
    QStringList words{tr("Vertical plane, true scale; dash-dotted in the views.")};
    if (question.rocks) words << tr("Rocks have their colours.");
    if (section->plane.upAssumed) words << tr("▲ no pose: up is the scanner's z");
    card_->setWords(words.join(' '));
    const bool opens = !card_->isVisible();
    if (opens) emit opening();
    card_->show();
    views_.setCut(cellsOf(*section));
    if (opens) placeCard(question.cells);
    card_->raise();
}

void Sections::placeCard(const std::vector<std::uint32_t>& cut) {
    const CloudView& cloud = views_.cloud();
    if (!cloud.isVisible()) return moveAside(*card_, *notice_.window(), {}, {});
    const QPoint corner = cloud.mapToGlobal(QPoint());
    moveAside(*card_, *notice_.window(), QRect(corner, cloud.size()), placeIn(cloud, cut).intersected(cloud.rect()).translated(corner));
}

bool Sections::close() {
    if (card_ == nullptr || !card_->isVisible()) return false;
    card_->hide();
    return true;
}

void Sections::showLength(const inspect::SectionVertex& from, const inspect::SectionVertex& to) {
    const edges::Detection& detection = *picture_->detection;
    const RangeNoise noise = detection.surface ? inspect::noiseOf(detection) : RangeNoise{};
    const inspect::MeasuredLength length = inspect::sectionLength(*detection.scan, noise, from, to);
    card_->plot().setLength(shownText(inspect::lengthText(length)));
    targets_.keepMeasure({inspect::MeasureKind::Section, {from.cell, from.other, to.cell, to.other}, {}, {from.share, to.share}});
}

void Sections::askExport() {
    if (rocks_.shown() && !study()) {
        notice_.showHint(tr("The rocks are still being computed: export the section again in a moment."));
        return;
    }
    const Scan& scan = *picture_->detection->scan;
    SaveQuestion question;
    question.title = tr("Export Section");
    question.filters = QStringList{tr("Drawing (*.dxf)"), tr("Table (*.csv)"), tr("Picture (*.png)")};
    question.extension = ".dxf";
    const QString name = shownName(exactText(scan.name), 80).replace(' ', '-').replace('/', '-') + "_section.dxf";
    question.place = QDir(preferences_.folder("exports")).filePath(name);
    question.files = withItsRecord;
    const QString path = askWhereToSave(notice_.window(), question);
    if (!path.isEmpty()) exportTo(path);
}

void Sections::exportTo(const QString& path) {
    const auto section = card_ != nullptr ? card_->plot().section() : nullptr;
    if (!section) return;
    exports::ExportOptions options;
    options.frame = files::usualFrame(*picture_->detection->scan);
    options.rocks = study(); // null: without rocks, as they are not shown
    options.section = std::make_shared<const inspect::SectionPlane>(section->plane);
    engine_.save(exports::ExportContent::Section, path, options);
}

} // namespace edgescan::ui

#include "moc_sections.cpp"
