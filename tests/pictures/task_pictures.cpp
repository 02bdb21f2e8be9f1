// The pictures of the pages that show an operator's tasks, from the real window driven by real events: edgescan_task_pictures FOLDER
// [TASK]. docs/pictures/make-pictures runs it, on a screen of 1280 x 800.
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/open_scan.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/dialogs/opening_card.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/tuning/count_curve.h"
#include "ui/window/theme.h"

#include <QPainter>
#include <QScreen>
#include <QStatusBar>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

namespace edgescan::ui {
namespace {

struct Bell {
    std::string before, after;
    mutable std::unique_ptr<scanner::EmulatedScanner> scanner{}; // sends until the picture is made
};

struct Done {
    bool well = false;
    QImage picture;
};

void click(ImageView& view, int line, int beam) {
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier,
                      view.viewPort()->toPixel(QPointF(beam + 0.5, line + 0.5), view.size()).toPoint());
}

bool rocksShown(WindowFixture& on) {
    QTest::keyClick(&on.window, Qt::Key_K);
    return eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); });
}

// The largest rock about the middle of the picture: the one that an operator asks about.
const rocks::Rock& rockInTheMiddle(WindowFixture& on) {
    const RockPicture& shown = *on.viewer.rocks.picture();
    const auto away = [&](const rocks::Rock& rock) {
        const QPoint at = on.viewer.views.placeOf(rock.cell);
        return std::hypot(at.y() - shown.labels.lines * 0.5, at.x() - shown.labels.beams * 0.5);
    };
    const auto middle = 0.15 * shown.labels.beams;
    const rocks::Rock* best = nullptr;
    for (const rocks::Rock& rock : shown.study.rocks) {
        if (away(rock) < middle && (best == nullptr || rock.longestCaliperM > best->longestCaliperM)) best = &rock;
    }
    if (best == nullptr) best = &shown.study.rocks.front();
    return *best;
}

bool opened(WindowFixture& on, const Bell& bell) {
    if (!on.open(bell.before) || !on.activate()) return false;
    QTest::mouseMove(&on.viewer.views.gray(), QPoint(on.viewer.views.gray().width() / 2, on.viewer.views.gray().height() / 2));
    return true;
}

bool countedEdges(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell)) return false;
    auto* curve = on.window.findChild<CountCurve*>("curve-sensitivity");
    return eventually([&] { return curve->curve() && !curve->curve()->edges.empty(); });
}

bool checked(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell)) return false;
    on.viewer.opening.show();
    return eventually([&] { return on.viewer.opening.card() && on.viewer.opening.card()->isVisible(); }) && on.settled();
}

bool tuned(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell)) return false;
    on.slider("sensitivity")->setFocus();
    for (int n = 0; n < 12; ++n) QTest::keyClick(on.slider("sensitivity"), Qt::Key_Right);
    QTest::keyClick(&on.window, Qt::Key_C);
    auto* curve = on.window.findChild<CountCurve*>("curve-sensitivity");
    return on.settled() && eventually([&] { return curve->curve() && !curve->curve()->edges.empty(); });
}

bool picked(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell) || !rocksShown(on)) return false;
    const QPoint at = on.viewer.views.placeOf(rockInTheMiddle(on).cell);
    QTest::keyClick(&on.window, Qt::Key_P);
    click(on.viewer.views.gray(), at.y(), at.x());
    return eventually([&] { return on.viewer.targets.settled(); });
}

// The first and the last beam of a rock in the line of one of its cells, less the cells at its border.
std::pair<int, int> acrossRock(WindowFixture& on, std::uint32_t label, QPoint at) {
    const Grid<std::uint32_t>& labels = on.viewer.rocks.picture()->labels;
    int from = at.x(), to = at.x();
    while (from > 0 && labels.at(at.y(), from - 1) == label) --from;
    while (to + 1 < labels.beams && labels.at(at.y(), to + 1) == label) ++to;
    return {from + 2, to - 2};
}

bool measured(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell) || !rocksShown(on)) return false;
    const rocks::Rock& rock = rockInTheMiddle(on);
    const QPoint at = on.viewer.views.placeOf(rock.cell);
    const auto [from, to] = acrossRock(on, rock.label, at);
    QTest::keyClick(&on.window, Qt::Key_U);
    click(on.viewer.views.gray(), at.y(), from);
    click(on.viewer.views.gray(), at.y(), to);
    QTest::keyClick(&on.window, Qt::Key_P);
    click(on.viewer.views.gray(), at.y(), at.x());
    return eventually([&] { return on.viewer.targets.settled(); });
}

bool handedOver(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell) || !rocksShown(on)) return false;
    const QPoint at = on.viewer.views.placeOf(rockInTheMiddle(on).cell);
    QTest::keyClick(&on.window, Qt::Key_L);
    click(on.viewer.views.gray(), at.y(), at.x());
    QTest::keyClick(&on.window, Qt::Key_I);
    return on.settled();
}

bool compared(WindowFixture& on, const Bell& bell) {
    if (!opened(on, bell)) return false;
    QTest::keyClick(&on.window, Qt::Key_A, Qt::ShiftModifier);
    return on.open(bell.after) && eventually([&] { return on.viewer.comparing.settled() && on.viewer.comparing.comparison(); });
}

bool live(WindowFixture& on, const Bell& bell) {
    const auto scan = files::openScan(bell.before);
    auto telegrams = scan ? scanner::telegramsOf(*scan) : Result<std::vector<scanner::ScanTelegram>>(scan.error());
    if (!telegrams) return false;
    scanner::EmulatedScannerSettings fast;
    fast.linesPerSecond = 100;
    fast.faults.loseEvery = 83;
    auto made = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), fast);
    if (!made) return false;
    bell.scanner = std::move(*made);
    scanner::SweepSettings sweep;
    sweep.expectedLines = scan->lines();
    sweep.degPerLine = 180.0 / scan->lines();
    sweep.firstLineDeg = -90;
    sweep.axis = Axis::Sweep;
    on.viewer.live.connectTo("127.0.0.1", bell.scanner->port(), sweep);
    return eventually(
        [&] { return on.viewer.engine.picture() && on.viewer.engine.picture()->detection->scan->lines() > scan->lines() / 2; });
}

// With the dialogs above the window.
QImage pictureOf(MainWindow& window) {
    QImage picture = window.screenshot().convertToFormat(QImage::Format_RGB32);
    QPainter painter(&picture);
    for (auto* dialog : window.findChildren<QDialog*>()) {
        if (dialog->isVisible()) painter.drawPixmap(dialog->mapToGlobal(QPoint()) - window.mapToGlobal(QPoint()), dialog->grab());
    }
    return picture;
}

struct Task {
    const char* name;
    bool (*act)(WindowFixture&, const Bell&);
    std::vector<const char*> numbered = {}; ///< widgets that the page explains by number, from 1
};
const std::vector<Task> kTasks{
    {"window",
     countedEdges,
     {"gray", "edges", "cloud", "edge-legend", "scale-plate", "origin", "slider-sensitivity", "range-handles", "counts"}},
    {"open", checked},
    {"tune", tuned, {"slider-sensitivity", "curve-sensitivity", "slider-jump", "slider-crease", "slider-min-length", "edge-legend"}},
    {"pick", picked},
    {"measure", measured},
    {"compare", compared},
    {"live", live},
    {"hand-over", handedOver}};

// A numbered disc at the left end of each widget.
bool number(MainWindow& window, const std::vector<const char*>& widgets, QImage& picture) {
    constexpr int kRadius = 12;
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(15);
    painter.setFont(font);
    for (std::size_t n = 0; n < widgets.size(); ++n) {
        const auto* widget = window.findChild<QWidget*>(widgets[n]);
        if (widget == nullptr || !widget->isVisible()) {
            std::cout << "no widget to number: " << widgets[n] << std::endl;
            return false;
        }
        const QPoint corner = widget->mapTo(&window, QPoint());
        const bool isView = widget->height() > 240, inStatusBar = window.statusBar()->isAncestorOf(widget);
        QPoint at = corner + QPoint(-kRadius - 4, std::min(widget->height() / 2, kRadius));
        if (isView) at = corner + QPoint(2 * kRadius, 2 * kRadius);
        if (inStatusBar) at = corner + QPoint(widget->width() / 2, -kRadius);
        at.setX(std::max(at.x(), kRadius + 2));
        painter.setPen(QPen(Qt::white, 2));
        painter.setBrush(QColor(11, 98, 176));
        painter.drawEllipse(at, kRadius, kRadius);
        painter.drawText(QRect(at - QPoint(kRadius, kRadius), QSize(2 * kRadius, 2 * kRadius)), Qt::AlignCenter, QString::number(n + 1));
    }
    return true;
}

int makePictures(const QString& folder, const QString& wanted) {
    const test::TemporaryFolder made;
    sim::SimulationSettings settings;
    settings.seed = 101;
    settings.lines = 600;
    settings.beams = 685;
    const Bell bell{(made / "bell.json").string(), (made / "bell after the blast.json").string()};
    bool well = bool(files::saveScan(sim::simulate(settings)->scan, bell.before));
    settings.afterBlast = true;
    well = well && bool(files::saveScan(sim::simulate(settings)->scan, bell.after));
    const QSize size = QGuiApplication::primaryScreen()->size();
    for (const Task& task : kTasks) {
        if (!well) break;
        if (!wanted.isEmpty() && wanted != task.name) continue;
        WindowFixture on;
        on.window.resize(size);
        const QString path = QString("%1/task-%2-%3.png").arg(folder, task.name).arg(size.width());
        well = on.show() && task.act(on, bell);
        for (int n = 0; n < 5; ++n) QApplication::processEvents(); // layouts that still wait
        QImage picture = pictureOf(on.window);
        well = well && number(on.window, task.numbered, picture) && picture.save(path);
        std::cout << (well ? "made " : "NOT MADE: ") << path.toStdString() << std::endl;
    }
    return well ? 0 : 1;
}

} // namespace
} // namespace edgescan::ui

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(edgescan::ui::CloudView::surfaceFormat());
    QApplication application(argc, argv);
    edgescan::ui::useTheme(application);
    return edgescan::ui::makePictures(argc > 1 ? argv[1] : ".", argc > 2 ? argv[2] : "");
}
