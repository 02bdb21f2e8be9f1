// Several pins in the real window: their positions together, their tags next to the plates over the cloud, and the cab's side while no
// target is chosen.
#include "core/scan/georef/placed_points.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/window/cab_mode.h"

#include <QClipboard>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QWindow>

#include <algorithm>
#include <array>

using namespace edgescan;
using namespace edgescan::ui;

class PinsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bare_, placed_;

    static bool pin(WindowFixture& on, const std::vector<std::size_t>& cells) {
        for (const std::size_t cell : cells) on.viewer.views.pin(cell);
        return on.settled() && eventually([&] { return on.viewer.targets.settled(); }) &&
               on.viewer.targets.notebook().targets.size() == cells.size();
    }
    /// Cells with a range, apart from each other.
    static std::vector<std::size_t> someCells(const Scan& scan, std::size_t count) {
        std::vector<std::size_t> cells;
        for (std::size_t k = 3 * static_cast<std::size_t>(scan.beams()) + 17; k < scan.cells() && cells.size() < count; k += 1711) {
            if (scan.state[k] == CellState::Valid) cells.push_back(k);
        }
        return cells;
    }

private slots:
    // The label of an older measurement next to it does not cover the chosen one.
    void noLabelCoversTheChosenMeasurement() {
        QImage picture(420, 380, QImage::Format_RGB32);
        picture.fill(Qt::black);
        QPainter painter(&picture);
        for (const double across : {-40.0, 0.0, 60.0}) {
            ScreenMarks marks;
            const QLineF older(180, 160, 220, 200), chosen(150 + across, 190, 290 + across, 150);
            marks.measures.push_back({{older}, {older.p1(), older.p2()}, "M1 Throat 2.34 m ± 0.05", older.center(), false, 0});
            marks.measures.push_back({{chosen}, {chosen.p1(), chosen.p2()}, "M2 Throat 3.45 m ± 0.05", chosen.center(), true, 1});
            const auto tags = drawScreenMarks(painter, picture.rect(), marks);
            QCOMPARE(tags.size(), std::size_t(2));
            for (const MarkTag& tag : tags) {
                for (double along = 0.0; along <= 1.0; along += 0.02) QVERIFY(!tag.contains(chosen.pointAt(along)));
            }
        }
    }

    // Of two lines each label is next to its own, and covers neither.
    void aLabelIsNextToItsOwnLine() {
        QImage picture(420, 300, QImage::Format_RGB32);
        QPainter painter(&picture);
        for (const double apart : {-24.0, 14.0, 20.0, 26.0, 40.0}) {
            ScreenMarks marks;
            const QLineF first(60, 150, 360, 150), second(60, 150 - apart, 360, 150 - apart);
            marks.measures.push_back({{first}, {first.p1(), first.p2()}, "M1 2.34 m ± 0.05", first.center(), false, 0});
            marks.measures.push_back({{second}, {second.p1(), second.p2()}, "M2 3.45 m ± 0.05", second.center(), false, 1});
            const auto tags = drawScreenMarks(painter, picture.rect(), marks);
            QCOMPARE(tags.size(), std::size_t(2));
            for (const MarkTag& tag : tags) {
                const auto awayFrom = [&tag](const QLineF& line) {
                    return line.y1() < tag.top() ? tag.top() - line.y1() : line.y1() > tag.bottom() ? line.y1() - tag.bottom() : 0.0;
                };
                const bool isFirst = tag.of.which == 0;
                const double own = awayFrom(isFirst ? first : second), other = awayFrom(isFirst ? second : first);
                QVERIFY2(own > 0.0 && other > own, qPrintable(QString("%1 px apart: %2 and %3").arg(apart).arg(own).arg(other)));
            }
        }
    }

    // A label without room in a small picture is its number, or left out: no part of it is shown.
    void noLabelIsCut() {
        QImage picture(100, 80, QImage::Format_RGB32);
        QPainter painter(&picture);
        for (const char* brief : {"M1", ""}) {
            CellMarks of;
            of.measures.push_back({.cells = {0, 1}, .links = {{0, 1}}, .label = "M1 Throat 2.34 m ± 0.05", .active = true, .brief = brief});
            of.targets.push_back({2, "1 keystone · 19.11 m · rock 3", brief, true});
            const auto placeOf = [](std::size_t cell) { return std::optional(QPointF(20.0 + 30.0 * static_cast<double>(cell), 40)); };
            const auto tags = drawScreenMarks(painter, picture.rect(), screenMarks(of, placeOf, true));
            QCOMPARE(tags.size(), std::size_t(*brief == 0 ? 0 : 2));
            for (const MarkTag& tag : tags) QVERIFY(QRectF(picture.rect()).contains(tag) && tag.width() < 50.0);
        }
    }

    // The length of a measured line is read next to the line, and the whole line is visible.
    void theTagOfAMeasurementDoesNotCoverItsLine() {
        QImage picture(800, 600, QImage::Format_RGB32);
        QPainter painter(&picture);
        for (const double length : {12.0, 40.0, 90.0, 300.0}) {
            for (int degrees = 0; degrees < 180; degrees += 15) {
                QLineF line(QPointF(400, 300), QPointF(400 + length, 300));
                line.setAngle(degrees);
                ScreenMarks marks;
                marks.measures = {{{line}, {line.p1(), line.p2()}, "1.402 m ± 0.039 m", line.center()}};
                const auto tags = drawScreenMarks(painter, picture.rect(), marks);
                QCOMPARE(static_cast<int>(tags.size()), 1);
                for (double along = 0.0; along <= 1.0; along += 0.01)
                    QVERIFY2(!tags.front().contains(line.pointAt(along)), qPrintable(QString("%1 px, %2°").arg(length).arg(degrees)));
                QVERIFY(QLineF(tags.front().center(), line.center()).length() < 200.0);
            }
        }
    }

    // A tag covers neither the ring of another target nor a text of the view, and a target under a plate has none: it would name what is
    // next to the plate.
    void tagsAreNearTheirMarksAndCoverNoOther() {
        QImage picture(400, 300, QImage::Format_RGB32);
        QPainter painter(&picture);
        const QRectF plate(0, 150, 140, 150), text(100, 0, 200, 30);
        ScreenMarks marks;
        const std::vector<QPointF> places{{200, 100}, {225, 90}, {240, 105}, {60, 200}, {160, 35}};
        for (const QPointF& at : places) marks.targets.push_back({at, false, "4 · 19.11 m", false});
        const auto tags = drawScreenMarks(painter, picture.rect(), marks, {plate}, {text});
        QCOMPARE(tags.size(), places.size() - 1);
        for (const QRectF& tag : tags) {
            QVERIFY(!tag.intersects(plate) && !tag.intersects(text));
            for (const QPointF& at : places) QVERIFY2(!tag.contains(at), qPrintable(QString("%1 %2").arg(at.x()).arg(at.y())));
        }
    }

    // Four targets within 60 px in a small image, also at its border: a tag covers no ring, and one that is nearer to the ring of another
    // target has a line from its own.
    void closeTargetsHaveTagsThatNameThem() {
        int led = 0, whole = 0;
        for (const QPointF corner :
             {QPointF(130, 90), QPointF(4, 4), QPointF(266, 4), QPointF(4, 146), QPointF(266, 146), QPointF(266, 70)}) {
            for (const bool stacked : {false, true}) {
                QImage picture(330, 210, QImage::Format_RGB32);
                picture.fill(QColor(60, 60, 60));
                QPainter painter(&picture);
                const std::vector<QPointF> places = stacked ? std::vector<QPointF>{corner + QPointF(10, 6), corner + QPointF(12, 22),
                                                                                   corner + QPointF(9, 40), corner + QPointF(11, 56)}
                                                            : std::vector<QPointF>{corner + QPointF(6, 30), corner + QPointF(24, 36),
                                                                                   corner + QPointF(42, 28), corner + QPointF(58, 34)};
                CellMarks of;
                for (std::size_t n = 0; n < places.size(); ++n)
                    of.targets.push_back({n, QString("%1 keystone · 4.91 m · rock 3").arg(n + 1), QString::number(n + 1), n == 3});
                const ScreenMarks marks = screenMarks(of, [&](std::size_t cell) { return std::optional(places[cell]); });
                const auto tags = drawScreenMarks(painter, picture.rect(), marks);
                if (qEnvironmentVariableIsSet("EDGESCAN_LOOK"))
                    picture.save(QString("%1/tags-%2-%3-%4.png")
                                     .arg(qEnvironmentVariable("EDGESCAN_LOOK"))
                                     .arg(corner.x())
                                     .arg(corner.y())
                                     .arg(stacked));
                QCOMPARE(tags.size(), places.size());
                for (const MarkTag& tag : tags) {
                    const QPointF own = places[tag.of.which];
                    const auto endAt = [&](const QPointF& at) {
                        return QPointF(std::clamp(at.x(), tag.left(), tag.right()), std::clamp(at.y(), tag.top(), tag.bottom()));
                    };
                    const QString where = QString("%1 at %2, %3").arg(tag.of.which).arg(corner.x()).arg(corner.y());
                    bool otherIsNearer = false;
                    const QLineF way(own, endAt(own));
                    for (const QPointF& at : places) {
                        QVERIFY2(QLineF(at, endAt(at)).length() >= 9.0, qPrintable(where));
                        otherIsNearer = otherIsNearer || (at != own && QLineF(at, endAt(at)).length() <= way.length());
                    }
                    whole += tag.width() > 40.0 ? 1 : 0;
                    if (!otherIsNearer && way.length() < 20.0) continue;
                    ++led;
                    if (way.length() < 14.0) continue; // the ring is all but at the tag
                    int lightest = 0;                  // between ring and tag, of a line at any angle
                    for (double px = 11.0; px < way.length() - 1.0; px += 0.5) {
                        const QPoint at = way.pointAt(px / way.length()).toPoint();
                        for (const QPoint by : {QPoint(0, 0), QPoint(-1, 0), QPoint(0, -1)})
                            lightest = std::max(lightest, qGray(picture.pixel(at + by)));
                    }
                    QVERIFY2(lightest > 90, qPrintable(where + QString(" %1 px %2").arg(way.length()).arg(lightest)));
                }
            }
        }
        QVERIFY2(led > 0, "the test can fail: not all have room next to their rings");
        QVERIFY2(whole > 12, "there is room for the whole text of more than the chosen one");
    }

    // Where the text has no free place near its ring, the number has one.
    void aTagWithoutRoomIsItsNumber() {
        QImage picture(150, 60, QImage::Format_RGB32);
        QPainter painter(&picture);
        CellMarks of;
        for (std::size_t n = 0; n < 3; ++n) of.targets.push_back({n, "keystone · 19.11 m", QString::number(n + 1), n == 2});
        const auto placeOf = [](std::size_t cell) { return std::optional(QPointF(30.0 + 30.0 * static_cast<double>(cell), 30)); };
        const auto tags = drawScreenMarks(painter, picture.rect(), screenMarks(of, placeOf));
        QCOMPARE(tags.size(), std::size_t(3));
        for (const MarkTag& tag : tags) {
            for (std::size_t n = 0; n < 3; ++n) QVERIFY(!QRectF(*placeOf(n) - QPointF(9, 9), QSizeF(18, 18)).intersects(tag));
        }
        QVERIFY2(std::ranges::any_of(tags, [](const MarkTag& tag) { return tag.width() < 40.0; }), "the test can fail");
    }

    // In a crowd each tag is next to its own mark, or a line leads to it.
    void aTagThatIsAwayFromItsMarkHasALineToIt() {
        QImage picture(284, 200, QImage::Format_RGB32);
        picture.fill(QColor(60, 60, 60));
        QPainter painter(&picture);
        ScreenMarks marks;
        std::vector<QPointF> places;
        for (int n = 0; n < 16; ++n) places.emplace_back(112 + 14 * (n % 4), 72 + 14 * (n / 4));
        for (const QPointF& at : places) marks.targets.push_back({at, false, "12 · 4.91 m", false});
        auto tags = drawScreenMarks(painter, picture.rect(), marks);
        std::ranges::reverse(tags);
        QCOMPARE(tags.size(), places.size());
        int lines = 0;
        for (std::size_t n = 0; n < tags.size(); ++n) {
            const QPointF end(std::clamp(places[n].x(), tags[n].left(), tags[n].right()),
                              std::clamp(places[n].y(), tags[n].top(), tags[n].bottom()));
            if (QLineF(places[n], end).length() <= 24.0) continue;
            ++lines;
            int lightest = 0; // just before the tag, where rings of others end
            for (double along = 0.5; along < 1.0; along += 0.01)
                lightest = std::max(lightest, qGray(picture.pixel(QLineF(places[n], end).pointAt(along).toPoint())));
            QVERIFY2(lightest > 100, qPrintable(QString("%1: %2").arg(n).arg(lightest)));
        }
        QVERIFY2(lines > 0, "the test can fail: not all have room next to their marks");
    }

    // Labels of lengths that are close to each other do not cover each other, and each one that is moved away has a line.
    void labelsOfLengthsAreSideBySide() {
        QImage picture(330, 220, QImage::Format_RGB32);
        picture.fill(QColor(60, 60, 60));
        QPainter painter(&picture);
        ScreenMarks marks;
        for (int n = 0; n < 6; ++n) {
            const QLineF line(20, 90 + 6 * n, 310, 110 + 6 * n);
            marks.measures.push_back({{line}, {line.p1(), line.p2()}, QString::fromUtf8("▲ 1.387 m ± 0.391 m"), line.center()});
        }
        const auto tags = drawScreenMarks(painter, picture.rect(), marks);
        QCOMPARE(tags.size(), marks.measures.size());
        int lines = 0;
        for (std::size_t n = 0; n < tags.size(); ++n) {
            for (std::size_t other = 0; other < n; ++other) QVERIFY(!tags[n].intersects(tags[other]));
            const QPointF at = marks.measures[n].labelAt;
            const QPointF end(std::clamp(at.x(), tags[n].left(), tags[n].right()), std::clamp(at.y(), tags[n].top(), tags[n].bottom()));
            if (QLineF(at, end).length() <= 16.0) continue;
            ++lines;
            int lightest = 0;
            for (double along = 0.6; along < 1.0; along += 0.01)
                lightest = std::max(lightest, qGray(picture.pixel(QLineF(at, end).pointAt(along).toPoint())));
            QVERIFY2(lightest > 150, qPrintable(QString("%1: %2").arg(n).arg(lightest)));
        }
        QVERIFY2(lines > 0, "the test can fail: all have room next to their lines");
    }

    // Of several measurements at one place the chosen one, else the newest, has its value; the others have their numbers of the list.
    void oneOfSeveralMeasurementsAtOnePlaceHasItsValue() {
        const auto labels = [](std::optional<std::size_t> chosen) {
            CellMarks marks;
            for (std::size_t n = 0; n < 5; ++n) // the last one is elsewhere
                marks.measures.push_back(
                    {{2 * n, 2 * n + 1}, {{0, 1}}, "0.534 m ± 0.021 m", {}, n == chosen, "M" + QString::number(n + 1)});
            const auto placeOf = [](std::size_t cell) {
                const double far = cell >= 8 ? 300.0 : 6.0 * static_cast<double>(cell / 2);
                return std::optional(QPointF(100.0 + 40.0 * static_cast<double>(cell % 2), 100.0 + far));
            };
            QStringList words;
            for (const auto& measure : screenMarks(marks, placeOf).measures) words << measure.label;
            words.sort();
            return words;
        };
        const QString value = QString::fromUtf8("0.534 m ± 0.021 m");
        QCOMPARE(labels(std::nullopt), QStringList({value, value, "M1", "M2", "M3"}));
        QCOMPARE(labels(1), QStringList({value, value, "M1", "M3", "M4"}));
    }

    // A length in a small image has its line only: its label would cover the image, and the cloud has it.
    void aSmallViewHasNoLabelsOfLengths() {
        const CellMarks marks{{}, {{{1, 2}, {{0, 1}}, "1.402 m"}}};
        const auto placeOf = [](std::size_t cell) { return std::optional(QPointF(10.0 * static_cast<double>(cell), 5.0)); };
        QCOMPARE(screenMarks(marks, placeOf).measures.front().label, QString("1.402 m"));
        QVERIFY(screenMarks(marks, placeOf, true).measures.front().label.isEmpty());
        QCOMPARE(screenMarks(marks, placeOf, true).measures.front().lines.size(), std::size_t{1});
    }

    // The chosen measurement has a thicker line with a light rim, and rings at its ends.
    void theChosenMeasurementHasARim() {
        const auto lightness = [](bool active, const QPoint& at) {
            QImage picture(120, 60, QImage::Format_RGB32);
            picture.fill(Qt::gray);
            QPainter painter(&picture);
            const CellMarks marks{{}, {{{0, 1}, {{0, 1}}, QString(), {}, active}}};
            const auto placeOf = [](std::size_t cell) { return std::optional(QPointF(cell == 0 ? 20.0 : 100.0, 30.0)); };
            (void)drawScreenMarks(painter, picture.rect(), screenMarks(marks, placeOf));
            return qGray(picture.pixel(at));
        };
        for (const QPoint at : {QPoint(60, 26), QPoint(20, 22), QPoint(100, 22), QPoint(108, 30)}) // rim, rings
            QVERIFY2(std::abs(lightness(true, at) - lightness(false, at)) > 40, qPrintable(QString("%1, %2").arg(at.x()).arg(at.y())));
    }

    // In a view without room for all tags that of the target on the card is over the others.
    void theTagOfTheActiveTargetIsOverTheOthers() {
        QImage picture(150, 40, QImage::Format_RGB32);
        QPainter painter(&picture);
        ScreenMarks marks;
        for (int n = 0; n < 5; ++n) marks.targets.push_back({QPointF(30.0 + 4 * n, 25), false, QString("%1 · 19.11 m").arg(n + 1), n == 4});
        marks.measures = {{{}, {}, "1.402 m", QPointF(60, 20)}};
        marks.measures[0].lines = {QLineF(50, 20, 70, 20)};
        const auto tags = drawScreenMarks(painter, picture.rect(), marks);
        QCOMPARE(tags.size(), std::size_t{6});
        bool covered = false;
        for (std::size_t n = 1; n < tags.size(); ++n) covered = covered || tags[n].intersects(tags[0]);
        QVERIFY2(covered, "the test can fail: there is no room for all");
        for (const double share : {0.1, 0.5, 0.9}) { // its upper margin has no letters
            const QPoint at(static_cast<int>(tags[0].left() + share * tags[0].width()), static_cast<int>(tags[0].top()) + 2);
            QVERIFY2(qGray(picture.pixel(at)) > 180, qPrintable(QString("%1 %2").arg(share).arg(qGray(picture.pixel(at)))));
        }
    }

    // The label in the pictures has the digits of the card.
    void labelAndCardHaveTheSameDigits() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        QVERIFY(pin(on, someCells(*on.picture().detection->scan, 1)));
        const auto& known = on.viewer.targets.known().targets;
        QVERIFY(known.size() == 1);
        const QString tag = on.viewer.views.gray().marks().targets.front().tag;
        QVERIFY2(tag.endsWith(" · " + distanceText(known.begin()->second)), qPrintable(tag));
    }

    void initTestCase() {
        Scan scan = test::boxesScan(120, 160, 3, 0.02);
        bare_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(scan, bare_)));
        scan.placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
        placed_ = (folder_ / "placed.json").string();
        QVERIFY(bool(files::saveScan(scan, placed_)));
    }

    void thePositionsOfAllPinsAreSeenAndCopiedWithUnits() {
        for (const bool placed : {false, true}) {
            WindowFixture on;
            on.window.resize(1280, 800);
            QVERIFY(on.showWith(placed ? placed_ : bare_) && on.activate());
            const Scan& scan = *on.picture().detection->scan;
            const auto cells = someCells(scan, 3);
            QVERIFY(pin(on, cells));
            on.viewer.targets.rename(2, "keystone");
            QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
            const QListWidget& list = *on.viewer.targetsPanel.targets();
            on.viewer.targetsPanel.copyAllButton()->click();
            const QStringList rows = QGuiApplication::clipboard()->text().trimmed().split('\n');
            QCOMPARE(rows.size(), 4);
            QVERIFY2(rows[0].startsWith("Target\tName\tDistance [m]\t± [m]\tX [m]\tY [m]\tZ [m]\tE [m]\tN [m]\tRL [m]"),
                     qPrintable(rows[0]));
            for (int n = 0; n < 3; ++n) {
                const edges::Probe probe = edges::probeCell(*on.picture().detection, cells[static_cast<std::size_t>(n)]);
                const Eigen::Vector3d& at = placed ? *probe.mineM : probe.pointM;
                const QStringList row = rows[n + 1].split('\t');
                QCOMPARE(row[0], QString::number(n + 1));
                QCOMPARE(row[1], n == 1 ? QString("keystone") : QString());
                for (int axis = 0; axis < 3; ++axis) {
                    const QString number = QString::number(at[axis], 'f', 3);
                    QCOMPARE(row[(placed ? 7 : 4) + axis], number);
                    const QString listed = QString::number(at[axis], 'f', placed ? 2 : 3); // mine coordinates in one line of the list
                    QVERIFY2(list.item(n)->text().contains(listed), qPrintable(list.item(n)->text()));
                }
                QVERIFY2(placed || list.item(n)->text().endsWith(" m"), qPrintable(list.item(n)->text()));
                QCOMPARE(row[10].toInt(), probe.line);
                QCOMPARE(row[11].toInt(), probe.beam);
            }
        }
    }

    // Between the name of a row and its number.
    void aClickOnTheLegendPinsNothingBelowIt() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bare_) && on.activate());
        QTRY_VERIFY(on.viewer.legend.isVisible() && on.viewer.views.cloud().atRest());
        const QPoint corner = on.viewer.legend.pos();
        for (int x = 2; x < on.viewer.legend.width() - 2; x += 12) {
            for (int y = 2; y < 8; y += 3) { // its margin, above all rows
                QTest::mouseClick(on.viewer.legend.window()->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                                  on.viewer.views.cloud().mapTo(&on.window, corner + QPoint(x, y)));
            }
        }
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{0});
        QVERIFY(!on.viewer.views.pinned());
    }

    // In the views, on the desk and in a cab: nothing new is pinned at the surface behind a label.
    void aClickOnALabelChoosesWhatItNames() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bare_) && on.activate());
        LinkedViews& views = on.viewer.views;
        const auto cells = someCells(*on.picture().detection->scan, 3);
        QVERIFY(pin(on, cells));
        on.viewer.targets.keepMeasure(
            {inspect::MeasureKind::Distance, {static_cast<std::uint32_t>(cells[1]), static_cast<std::uint32_t>(cells[2])}, {}});
        QTRY_VERIFY(on.viewer.targets.settled());
        auto* overlay = views.cloud().findChild<CloudOverlay*>();
        const auto click = [&](bool inCloud, const MarkName& mark, Qt::KeyboardModifiers keys = Qt::NoModifier) {
            std::optional<QPoint> at;
            int same = 0;
            const auto drawn = [&] { // and rests: it avoids the prompt of a tool
                const auto before = std::exchange(at, std::nullopt);
                for (const MarkTag& tag : inCloud ? overlay->tags() : views.gray().tags()) {
                    if (tag.of == mark) at = tag.center().toPoint();
                }
                same = at.has_value() && at == before && views.cloud().atRest() ? same + 1 : 0;
                return same > 5;
            };
            if (!eventually(drawn)) qFatal("the tag is not drawn");
            QWidget& view = inCloud ? static_cast<QWidget&>(views.cloud()) : views.gray();
            QTest::mouseClick(&view, Qt::LeftButton, keys, *at);
        };
        const auto& notebook = on.viewer.targets.notebook();
        for (const bool cab : {false, true}) {
            on.window.cab().set(cab);
            for (const bool inCloud : {true, false}) {
                if (cab && !inCloud) on.window.cab().useViews("range range small");
                for (const std::size_t cell : cells) {
                    const auto chosen = [&] { // a cab takes no tap for a moment where its small picture was
                        click(inCloud, {false, cell});
                        return on.viewer.targets.active() != nullptr && on.viewer.targets.active()->cell == cell;
                    };
                    QVERIFY2(eventually(chosen), qPrintable(QString("%1 %2 %3").arg(cab).arg(inCloud).arg(cell)));
                }
                const bool labelled = inCloud || views.gray().tags().size() > cells.size(); // a small image has no lengths
                if (labelled) click(inCloud, {true, 0});
                QCOMPARE(on.viewer.targets.chosenMeasure().has_value(), labelled);
                QCOMPARE(notebook.targets.size(), cells.size());
                // A tool takes what is behind the label, which may be far from its cell, and the target's own cell at its ring.
                on.viewer.measures.start(inspect::MeasureKind::Distance);
                click(inCloud, {false, cells[0]});
                const auto& picked = on.viewer.measures.picked();
                QVERIFY(std::ranges::none_of(picked, [&](const auto& each) { return each.clicked == cells[0]; }));
                if (inCloud && !cab) {
                    (void)on.viewer.measures.removeLastPick();
                    QTest::mouseClick(&views.cloud(), Qt::LeftButton, Qt::NoModifier,
                                      views.cloud().pixelOf(static_cast<std::uint32_t>(cells[0]))->toPoint());
                    QCOMPARE(views.marks().measures.back().cells, std::vector<std::size_t>{cells[0]});
                }
                on.viewer.measures.stop();
            }
        }
        on.window.cab().set(false);
        // While a rock is split, a label is not what is clicked; a menu is of the target on whose label it opens.
        const std::size_t behind = cells[1];
        QCOMPARE(static_cast<std::size_t>(
                     on.viewer.targets.at({static_cast<std::uint32_t>(cells[0]), static_cast<std::uint32_t>(behind)})->cell),
                 behind);
        views.setPinsOnClick(false);
        bool onLabel = false;
        const auto watch =
            connect(&views, &LinkedViews::clicked, this, [&](const inspect::ClickedCell& at) { onLabel = at.clicked == cells[2]; });
        click(true, {false, cells[2]});
        disconnect(watch);
        QVERIFY(!onLabel);
        views.setPinsOnClick(true);
        click(false, {false, cells[0]}, Qt::ShiftModifier); // the cell itself
        QCOMPARE(notebook.targets.size(), cells.size() + 1);
    }

    // What is green under the pointer is what a click takes, and the target is on an edge.
    void aClickOnAnEdgePinsAnEdge() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        CloudView& cloud = on.viewer.cloud;
        QVERIFY(eventually([&] { return cloud.atRest(); }));
        const edges::Detection& detection = *on.picture().detection;
        const auto isEdge = [&](std::size_t cell) { return detection.mask->cells[cell] == 255; };
        int seen = 0, taken = 0, pinned = 0;
        for (std::size_t n = 0; n < detection.edges->size(); n += 7) {
            const auto at = cloud.pixelOf((*detection.edges)[n]);
            if (!at || !cloud.rect().contains(at->toPoint()) || cloud.cellAt(*at) != (*detection.edges)[n]) continue;
            ++seen;
            const auto under = cloud.cellAt(*at + QPointF(0.9, 0.9)); // on the same square
            if (!under || !isEdge(*under)) continue;
            ++taken;
            pinned += isEdge(on.viewer.views.nearSideCell(*under).cell) ? 1 : 0;
            // On its dark outline, too: what is behind it may be far away.
            const auto outline = cloud.cellAt(*at + QPointF(2.4, 0.0));
            QVERIFY(outline && isEdge(*outline));
        }
        QVERIFY2(seen > 50 && taken == seen, qPrintable(QString("%1 of %2").arg(taken).arg(seen)));
        qInfo("clicks on edges: %d of %d pin an edge", pinned, taken);
        QVERIFY2(10 * pinned >= 9 * taken, qPrintable(QString("%1 of %2").arg(pinned).arg(taken)));
    }

    // The label counts more than what is near it; a finger need not hit a ring.
    void aMarkIsHitWhereItIsDrawn() {
        ScreenMarks marks;
        marks.targets = {{QPointF(50, 50), false, "1", false, 7}, {QPointF(90, 50), false, "2", true, 8}};
        marks.measures = {{{QLineF(50, 90, 150, 90)}, {QPointF(50, 90), QPointF(150, 90)}, "1 m", QPointF(100, 90), false, 3}};
        const std::vector<MarkTag> tags{{QRectF(60, 30, 40, 15), {false, 7}}, {QRectF(100, 70, 40, 15), {true, 3}}};
        const auto at = [&](double x, double y, bool finger = false) { return markAt(marks, tags, QPointF(x, y), finger); };
        QVERIFY(at(65, 35) == MarkName({false, 7, true}) && at(110, 75) == MarkName({true, 3, true}));
        QVERIFY(at(50, 43) == MarkName({false, 7}) && at(90, 57) == MarkName({false, 8}) && at(151, 91) == MarkName({true, 3}));
        QVERIFY(!at(35, 50) && at(35, 50, true) == MarkName({false, 7}));
        QVERIFY(!at(100, 90) && !at(300, 300, true)); // the line, and what is far from all
        QVERIFY(at(70, 25, true) == MarkName({false, 7, true}));
        marks.targets.front().active = true; // a tap next to its label chose it again, and nothing else happened
        QVERIFY(!at(70, 25, true) && at(65, 35, true) == MarkName({false, 7, true}));
        marks.targets.front().isTarget = false; // a remark, as "✓ edge"
        QVERIFY(!at(65, 35) && !at(50, 43) && at(90, 57) == MarkName({false, 8}));
    }
};

int pins_test(int argc, char** argv) { return runWindowTest<PinsTest>(argc, argv); }

#include "pins_test.moc"
