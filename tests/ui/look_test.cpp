// The look: what is on the screen once, what needs one line, what can be pressed, and what asks in time.
#include "core/base/whole_file.h"
#include "core/edges/settings/parameters.h"
#include "tests/support/folders.h"
#include "tests/support/placements.h"
#include "tests/ui/sized_window.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/cell_marks.h"
#include "ui/base/elided_label.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/controllers/report_pdf.h"
#include "ui/panels/cab/keypad.h"
#include "ui/panels/dialogs/export_dialog.h"
#include "ui/panels/dialogs/report_form.h"
#include "ui/panels/live/health_strip.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"
#include "ui/window/theme.h"
#include "ui/window/tool_bar.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QPlainTextEdit>
#include <QProcess>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

#include <map>
#include <set>

using namespace edgescan;
using namespace edgescan::ui;

class LookTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bell_;
    QString opened_;

    static QMenu* menuNamed(const MainWindow& window, const QString& name) {
        for (QAction* each : window.menuBar()->actions()) {
            if (each->text().remove('&') == name) return each->menu();
        }
        return nullptr;
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        sim::SimulationSettings settings;
        settings.seed = 101;
        settings.lines = 150;
        settings.beams = 171;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, bell_)));
    }

    void aNoticeTakesOneLineAndTheRestIsShownOnRequest() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_));
        NoticeBar& notice = on.viewer.notice;
        auto* more = notice.findChild<QToolButton*>("notice-unfold");
        notice.showNotice(NoticeBar::Kind::Warning, "short");
        QTRY_VERIFY(notice.isVisible());
        const int one = notice.height();
        const QString text = QString("line of a long warning\n").repeated(12).trimmed();
        notice.showNotice(NoticeBar::Kind::Warning, text);
        QTRY_VERIFY(more->isVisible());
        QVERIFY2(notice.height() <= one + 2, qPrintable(QString("%1 after %2").arg(notice.height()).arg(one)));
        QCOMPARE(notice.text(), text);
        QTest::mouseClick(more, Qt::LeftButton);
        QVERIFY(notice.unfolded());
        QTRY_VERIFY(notice.height() > 5 * one);
        QTest::mouseClick(more, Qt::LeftButton);
        QTRY_VERIFY(notice.height() <= one + 2);
        notice.unfold(true);
        notice.showNotice(NoticeBar::Kind::Warning, text + " again"); // the next one is folded
        QVERIFY(!notice.unfolded());
    }

    // Nothing is over the pictures, and no view moves when a note comes or goes.
    void aNoteMovesNoView() {
        for (const bool cab : {false, true}) {
            WindowFixture on;
            on.window.resize(1280, 800);
            QVERIFY(on.showWith(bell_));
            on.window.cab().set(cab);
            NoticeBar& notice = on.viewer.notice;
            notice.hide();
            const auto places = [&] {
                for (int n = 0; n < 5; ++n) QApplication::processEvents();
                QList<QRect> all;
                for (const QWidget* view : std::initializer_list<const QWidget*>{&on.viewer.gray, &on.viewer.edges, &on.viewer.cloud})
                    all << (view->isVisible() ? QRect(view->mapTo(&on.window, QPoint()), view->size()) : QRect());
                return all;
            };
            const QList<QRect> before = places();
            for (const char* words :
                 {"short", "a sentence that is long enough for more than one line of a window that is this wide, and for two"}) {
                notice.showNotice(NoticeBar::Kind::Warning, words);
                notice.offer("Does this look right?", [] {});
                QCOMPARE(places(), before);
                notice.hide();
                QCOMPARE(places(), before);
            }
            // On the desk it is next to the menus: without a note nothing is empty.
            QVERIFY(cab || notice.mapTo(&on.window, QPoint()).x() >= on.window.menuBar()->geometry().right());
            for (const char* sign : {"first", "second"})
                notice.showNotice(NoticeBar::Kind::Warning, QString("a sentence that is long enough for lines %1 ").arg(sign).repeated(60));
            notice.unfold(true);
            for (const QRect& view : places()) QVERIFY(!view.intersects(QRect(notice.mapTo(&on.window, QPoint()), notice.size())));
            QVERIFY2(cab || on.viewer.edges.isVisible(), "the details leave the edge map its room");
            on.window.cab().set(false);
        }
    }

    // A hint and a success are about one step: they pass with the next one. What is wrong with the scan stays.
    void aHintPassesWithTheNextStep() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        NoticeBar& notice = on.viewer.notice;
        notice.hide();
        const auto step = [&] { on.viewer.undo.push(new QUndoCommand("a step")); };
        notice.showHint("click nearer");
        step();
        QVERIFY(!notice.isVisible());
        notice.showNotice(NoticeBar::Kind::Done, "Saved");
        on.viewer.undo.undo();
        QVERIFY(!notice.isVisible());
        notice.showNotice(NoticeBar::Kind::Warning, "the scan is old");
        notice.showHint("click nearer");
        step();
        QVERIFY(notice.isVisible());
        QCOMPARE(notice.text(), QString("the scan is old"));
        step();
        QVERIFY(notice.isVisible());
        QCOMPARE(notice.earlier(), std::size_t{0});
    }

    // A button is at the same place of every note that has it, whichever others are shown.
    void theButtonsOfNotesKeepTheirPlaces() {
        for (const QSize size : {QSize(1024, 768), QSize(1280, 800)}) {
            WindowFixture on;
            on.window.resize(size);
            QVERIFY(on.showWith(bell_));
            NoticeBar& notice = on.viewer.notice;
            notice.hide();
            const QString longText = QString("a sentence that is long enough for lines ").repeated(20);
            std::map<QString, std::set<int>> places; // px from the end of the bar that each is at
            const auto look = [&] {
                QApplication::processEvents();
                QRect words;
                for (const auto* each : notice.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
                    words = words.united(each->geometry());
                for (const auto* each :
                     notice.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) { // not those of the details
                    const QRect at = each->geometry();
                    if (each->isVisible() && each->objectName() != "notice-unfold") // the sign, at the other end
                        places[each->objectName()].insert(notice.width() - each->mapTo(&notice, at.topRight() - at.topLeft()).x());
                    QVERIFY(!each->isVisible() || !words.intersects(at));
                }
            };
            for (const QString& words : {QString("short"), longText}) {
                notice.showNotice(NoticeBar::Kind::Warning, words);
                look();
                notice.offer("Open", [] {});
                look();
                notice.offer("Does this look right?", [] {});
                look();
                notice.unfold(true);
                look();
                notice.showSaved(QString::fromStdString((folder_ / "page.html").string()));
                look();
            }
            QCOMPARE(places.size(), std::size_t{2});
            for (const auto& [name, ends] : places)
                QVERIFY2(ends.size() == 1,
                         qPrintable(QString("%1: %2 and %3 of %4").arg(name).arg(*ends.begin()).arg(*ends.rbegin()).arg(size.width())));
        }
    }

    // Each line of an unfolded note is in sight, however long the note is and whichever buttons it has, also when they come later.
    void anUnfoldedNoteIsWhole() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_));
        NoticeBar& notice = on.viewer.notice;
        const auto* text = notice.findChild<QLabel*>("notice-text");
        auto* unfold = notice.findChild<QToolButton*>("notice-unfold");
        const auto isWhole = [&] {
            return text->isVisible() && text->height() >= text->heightForWidth(text->width()) &&
                   text->geometry().bottom() <= notice.height() - 1;
        };
        QString words = "Split: rock 5 is now rocks 18 (1.95 × 1.17 m), 21 (1.89 × 1.11 m). Other rocks:";
        for (int n = 6; n < 40; ++n) {
            words += QString(" %1 is now %2,").arg(n).arg(n - 1);
            notice.showNotice(NoticeBar::Kind::Done, words + " and 177 more.");
            notice.offerUndo(on.viewer.undo);
            QTRY_VERIFY(notice.isVisible() && unfold->isVisible());
            QTest::mouseClick(unfold, Qt::LeftButton);
            QTRY_VERIFY2(isWhole(), qPrintable(QString("%1 words, %2 x %3 needs %4, bar %5")
                                                   .arg(n)
                                                   .arg(text->width())
                                                   .arg(text->height())
                                                   .arg(text->heightForWidth(text->width()))
                                                   .arg(notice.height())));
        }
    }

    // Close ends one note, and the number of notes is in sight.
    void closeEndsOneNote() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_));
        NoticeBar& notice = on.viewer.notice;
        notice.hide();
        auto* close = notice.findChild<QToolButton*>("notice-close");
        auto* next = notice.findChild<QToolButton*>("notice-earlier");
        for (const char* words : {"the first", "the second", "the third"}) notice.showNotice(NoticeBar::Kind::Warning, words);
        QCOMPARE(next->text(), QString("1 of 3"));
        notice.unfold(true);
        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(notice.text(), QString("the second"));
        QCOMPARE(next->text(), QString("2 of 3"));
        QTest::mouseClick(close, Qt::LeftButton);
        QCOMPARE(notice.text(), QString("the first"));
        QCOMPARE(next->text(), QString("2 of 2"));
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_Escape); // first its details
        QCOMPARE(notice.text(), QString("the first"));
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QCOMPARE(notice.text(), QString("the third"));
        QVERIFY(!next->isVisible());
        QTest::mouseClick(close, Qt::LeftButton);
        QVERIFY(!notice.isVisible());
    }

    // Where the line is too short for a path, the name of the file is still read.
    void aNoteKeepsTheNameOfItsFile() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_));
        NoticeBar& notice = on.viewer.notice;
        const auto* line = static_cast<const ElidedLabel*>(notice.findChild<QLabel*>("notice-line"));
        const QString path = "/home/operator/" + QString("a-folder-with-a-long-name/").repeated(6) + "drawbell-edges.dxf";
        notice.showSaved(path, "12 points");
        QTRY_VERIFY2(line->shown().contains("drawbell-edges.dxf"), qPrintable(line->shown()));
        notice.showNotice(NoticeBar::Kind::Error, "The disk is full: " + path + "; free some space");
        QTRY_VERIFY2(line->shown().contains("drawbell-edges.dxf"), qPrintable(line->shown()));
        // A long name too, though what follows it has no room.
        const QString name = "demo-draw-bell-rocks-nr-2.pcd";
        notice.hide();
        notice.showSaved("/home/operator/" + name, "22,057 points in the frame of the scanner",
                         "Its record is next to it, for the archive.");
        QTRY_VERIFY2(line->shown().contains(name) && line->shown().endsWith("…"), qPrintable(line->shown()));
        notice.hide();
        // One sentence, the first; the details have all, once.
        notice.showNotice(NoticeBar::Kind::Warning, "No cell has a range.\nGUESS: the unit is the metre.");
        QTRY_COMPARE(line->shown(), QString("No cell has a range. …"));
        notice.unfold(true);
        QTRY_VERIFY2(line->shown().isEmpty(), qPrintable(line->shown()));
        notice.hide();
        // Of two scans the common part is left out, not the word that differs.
        QCOMPARE(shownApart("demo draw-bell after the blast", "demo draw-bell", 20), QString("… after the blast"));
        QCOMPARE(shownApart("north_2026-11-20_before_scan", "north_2026-11-20_after_scan", 9), QString("…before…"));
        QCOMPARE(shownApart("short", "shore", 20), QString("short"));
    }

    // A file was written, and something else happened right after it: its button comes back, and is not one of "earlier".
    void aNoteWithAButtonComesBack() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        NoticeBar& notice = on.viewer.notice;
        auto* leaves = notice.findChild<QTimer*>("notice-leaves");
        auto* action = notice.findChild<QToolButton*>("notice-action");
        notice.hide();
        notice.showSaved(QString::fromStdString(bell_));
        const QString saved = notice.text();
        QCOMPARE(action->text(), QString("Open folder"));
        for (const char* words : {"the scan is old", "the scan is displaced"}) {
            notice.showNotice(NoticeBar::Kind::Warning, words);
            QCOMPARE(notice.text(), QString(words)); // to be read
            QVERIFY(leaves->isActive());
        }
        leaves->setInterval(1);
        QTRY_COMPARE(notice.text(), saved);
        QVERIFY(action->isVisible());
        QCOMPARE(notice.earlier(), std::size_t{2});
        // A press that is on its way when a note changes by itself is not for the other note.
        auto* close = notice.findChild<QToolButton*>("notice-close");
        if (!close->isEnabled()) { // else the machine was slow
            QTest::mouseClick(close, Qt::LeftButton);
            QCOMPARE(notice.text(), saved);
        }
        QTRY_VERIFY(close->isEnabled());
        for (const char* words : {"the scan is old", "the scan is displaced"}) {
            QTest::mouseClick(notice.findChild<QToolButton*>("notice-earlier"), Qt::LeftButton);
            QCOMPARE(notice.text(), QString(words));
        }
        QVERIFY(!leaves->isActive()); // asked for
        QTest::mouseClick(notice.findChild<QToolButton*>("notice-earlier"), Qt::LeftButton);
        QCOMPARE(notice.text(), saved);
        notice.showNotice(NoticeBar::Kind::Done, "copied");
        QCOMPARE(notice.text(), QString("copied"));
        QTRY_COMPARE(notice.text(), saved);
        notice.showHint("click nearer");
        notice.endPassing();
        QCOMPARE(notice.text(), saved);
        // An error stays, and a note with a button of its own.
        notice.showNotice(NoticeBar::Kind::Warning, "the scan is displaced");
        notice.offer("Straighten", [] {});
        QVERIFY(!leaves->isActive() && action->text() == "Straighten");
        notice.showNotice(NoticeBar::Kind::Error, "the disk is full");
        QVERIFY(!leaves->isActive());
        notice.hide();
    }

    // A click is aimed at some of them, such as the mine grid: they moved when the pointer left the cloud.
    void factsOfTheStatusLineStayWhereTheyAre() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        const edges::Detection& bell = *on.picture().detection;
        for (const bool placed : {false, true}) {
            edges::Detection detection = bell;
            auto scan = std::make_shared<Scan>(*bell.scan);
            if (placed) scan->placement = test::randomPlacement(3, 1, true);
            detection.scan = scan;
            StatusLine line;
            line.show();
            line.showSettings({});
            line.showCounts(detection);
            line.showPlace(*scan);
            const auto places = [&line] {
                QApplication::processEvents();
                QStringList found;
                for (const char* name : {"place", "no-pose", "counts", "settings", "recorded"}) {
                    const auto* fact = line.findChild<QWidget*>(name);
                    const QPoint at = fact->mapTo(&line, QPoint());
                    found << QString("%1 %2 %3 %4").arg(name).arg(fact->isVisible()).arg(at.x()).arg(fact->width());
                }
                return found.join(", ");
            };
            for (int wide = 2000; wide > 800; wide -= 60) {
                line.resize(wide, 30);
                const QString before = places();
                for (const std::uint32_t k : {detection.edges->front(), detection.edges->back()}) {
                    for (const auto cell : {StatusLine::Cell::Pointer, StatusLine::Cell::Pin, StatusLine::Cell::MovedPin}) {
                        edges::Probe probe = edges::probeCell(detection, k);
                        probe.kind = edges::DepthEdge::Convex;
                        line.showProbe(probe, cell);
                        QCOMPARE(places(), before);
                    }
                }
                line.showProbe(std::nullopt, StatusLine::Cell::Pin);
                QCOMPARE(places(), before);
            }
        }
    }

    // With a pose it has six coordinates; the number of edges has its room next to them.
    void theNumberOfEdgesStaysNextToAPose() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        edges::Detection detection = *on.picture().detection;
        auto scan = std::make_shared<Scan>(*detection.scan);
        for (float& range : scan->rangeMm.cells) range *= 6; // as far as a draw-bell
        Placement place;
        place.originEnhM = {1000, 2000, 1500};
        scan->placement = std::make_shared<const Placement>(place);
        detection.scan = scan;
        StatusLine line;
        line.addPinned(new QPushButton("⚠ 2 warnings"));
        line.show();
        line.resize(1280, 30);
        line.showSettings({});
        line.showCounts(detection);
        line.showPlace(*scan);
        line.showProbe(edges::probeCell(detection, detection.edges->front()), StatusLine::Cell::MovedPin);
        const auto* counts = line.findChild<QLabel*>("counts");
        QApplication::processEvents();
        QVERIFY2(counts->isVisible() && counts->text().contains("edge cells"), qPrintable(counts->text()));
    }

    void openFile(const QUrl& url) { opened_ = url.toLocalFile(); }

    // The button opens a page itself, and the folder of other files.
    void theNoteOfAFileOpensIt() {
        WindowFixture on;
        QVERIFY(on.show());
        const QString page = QString::fromStdString((folder_ / "page.html").string());
        QVERIFY(bool(writeWholeFile(folder_ / "page.html", "<html></html>")));
        auto* action = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QDesktopServices::setUrlHandler("file", this, "openFile");
        on.viewer.notice.showSaved(page);
        QCOMPARE(action->text(), QString("Open"));
        action->click();
        QCOMPARE(opened_, page);
        auto* folder = on.viewer.notice.findChild<QToolButton*>("notice-folder");
        on.viewer.notice.unfold(true);
        QTRY_VERIFY(folder->isVisible());
        QTest::mouseClick(folder, Qt::LeftButton);
        QCOMPARE(opened_, QFileInfo(page).absolutePath());
        on.viewer.notice.showSaved(QString::fromStdString(bell_));
        QVERIFY(!folder->isVisible()); // the first button opens it
        action->click();
        QCOMPARE(opened_, QFileInfo(QString::fromStdString(bell_)).absolutePath());
        QDesktopServices::unsetUrlHandler("file");
        // A note whose button was pressed does not come back.
        on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "the scan is old");
        QVERIFY(!on.viewer.notice.findChild<QTimer*>("notice-leaves")->isActive());
    }

    void noMenuOfTheWindowIsLong() {
        WindowFixture on;
        QVERIFY(on.show());
        const QMenu* view = menuNamed(on.window, "View");
        QVERIFY(view != nullptr);
        int entries = 0;
        for (const QAction* each : view->actions()) entries += each->isSeparator() ? 0 : 1;
        QVERIFY2(entries <= 20, qPrintable(QString::number(entries)));
    }

    // A button that opens a menu has an arrow, and no other has one.
    void aButtonWithAMenuHasAnArrow() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        int menus = 0;
        for (auto* button : on.viewer.tools.findChildren<QToolButton*>()) {
            if (!button->isVisible() || !button->isEnabled() || button->isChecked()) continue;
            const QImage drawn = button->grab().toImage();
            const bool arrow = drawn.pixelColor(drawn.width() - 7, drawn.height() - 7) == button->palette().color(QPalette::ButtonText);
            QVERIFY2(arrow == (button->menu() != nullptr), qPrintable(button->accessibleName()));
            menus += arrow ? 1 : 0;
        }
        QVERIFY(menus >= 4);
    }

    void whatNeedsAScanIsDisabledBeforeOneIsOpen() {
        WindowFixture on;
        QVERIFY(on.show());
        const auto enabled = [&] {
            QStringList names;
            for (const auto* button : on.viewer.tools.findChildren<QToolButton*>()) {
                if (!button->accessibleName().isEmpty() && button->isEnabled()) names << button->accessibleName();
            }
            return names;
        };
        QCOMPARE(enabled(), (QStringList{"Open", "Connect", "Cab"}));
        QVERIFY(on.open(bell_));
        const QStringList then = enabled();
        for (const char* name :
             {"Open", "Connect", "Pin", "Measure", "Select", "Why", "Scanner view", "Fit", "Rocks", "A/B", "Export", "Report"})
            QVERIFY2(then.contains(name), name);
    }

    void theBadgeIsInTheToolBarAtEveryWidth() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        for (const int width : {900, 1100, 1280, 1920}) {
            on.window.resize(width, 700);
            QCoreApplication::processEvents();
            const StateBadge& badge = on.viewer.origin;
            const QRect place(badge.mapTo(&on.window, QPoint()), badge.size());
            const QByteArray at =
                QByteArray::number(width) + ": " + QByteArray::number(place.left()) + " to " + QByteArray::number(place.right());
            QVERIFY2(badge.isVisible() && on.window.rect().contains(place) && badge.width() >= badge.minimumSizeHint().width(), at);
            QVERIFY2(place.right() > on.window.width() - 20, at);
            QCOMPARE(badge.parentWidget()->parentWidget()->objectName(), QString("badge-bar"));
        }
    }

    void theClassesAreListedOnce() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        for (const edges::Choice& choice : edges::findParameter("classes")->choices) {
            int listed = 0;
            for (const auto* box : on.window.findChildren<QCheckBox*>()) listed += box->text().startsWith(choice.label) ? 1 : 0;
            QVERIFY2(listed <= 1, choice.label);
        }
    }

    void theExportAsksForItsFormatAndFitsASmallScreen() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        ExportDialog dialog(on.picture().detection, exports::ExportContent::EdgeCloud);
        dialog.offerFormats({{"Point Cloud Library (*.pcd)", ".pcd"}, {"Polygon (*.ply)", ".ply"}, {"Text (*.csv)", ".csv"}}, ".ply");
        QCOMPARE(dialog.extension(), QString(".ply"));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, kPatienceMs));
        QVERIFY2(dialog.width() <= 640 && dialog.height() <= 640, qPrintable(QString("%1 x %2").arg(dialog.width()).arg(dialog.height())));
        auto* format = dialog.findChild<QComboBox*>("format");
        QVERIFY(format->isVisible());
        format->setCurrentIndex(2);
        QCOMPARE(dialog.extension(), QString(".csv"));
        dialog.findChild<QAbstractButton*>("gray")->click();
        QCOMPARE(dialog.extension(), QString(".png"));
        QVERIFY(!format->isVisible());
    }

    /// Two to `most`, with nothing in their right margins, and none but the last is half empty.
    void hasFullPages(const char* name, int most) {
        constexpr int kInkLevel = 200;
        constexpr double kRightMargin = 196.0 / 210.0, kFull = 0.6; // of the width and the height; the number of the page is below 0.9
        QProcess painter;
        painter.start("pdftoppm", {"-gray", "-r", "30", QString::fromStdString((folder_ / name).string()),
                                   QString::fromStdString((folder_ / name).string())});
        if (!painter.waitForFinished()) return;
        const QDir folder(QString::fromStdString(folder_.path().string()));
        const QStringList pages = folder.entryList({QString(name) + "-*.pgm"}, QDir::Files, QDir::Name);
        QVERIFY2(pages.size() >= 2 && pages.size() <= most, qPrintable(pages.join(' ')));
        for (const QString& each : pages) {
            const QImage page(folder.filePath(each));
            int lowest = 0, outside = 0;
            for (int y = 0; y < page.height() * 0.9; ++y) {
                for (int x = 0; x < page.width(); ++x) {
                    if (qGray(page.pixel(x, y)) > kInkLevel) continue;
                    lowest = y;
                    outside += x > page.width() * kRightMargin ? 1 : 0;
                }
            }
            QVERIFY2(outside == 0, qPrintable(each + ": over the margin"));
            QVERIFY2(each == pages.last() || lowest > page.height() * kFull, qPrintable(each + ": half empty"));
        }
    }

    void theReportSaysWhatTheFormWasGivenAndIsAlsoAPdf() {
        const std::string logo = (folder_ / "logo.png").string();
        QImage picture(40, 20, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(QString::fromStdString(logo)));
        for (const char* language : {"es", "fr", "pt", "en"}) { // no text of the formats is cut
            QVERIFY(useTexts(language));
            ReportForm translated({}, nullptr);
            translated.show();
            const auto* format = translated.findChild<QComboBox*>("report-format");
            for (int n = 0; n < format->count(); ++n)
                QVERIFY2(format->fontMetrics().horizontalAdvance(format->itemText(n)) + 40 < format->width(),
                         qPrintable(format->itemText(n)));
        }
        ReportForm form({"Panel 3 <west>", "A. Miner", "one\ntwo & three", QString::fromStdString(logo), ".pdf"});
        form.show();
        form.findChild<QLineEdit*>("report-author")->setText(" B. Miner ");
        const ReportWords words = form.words();
        QCOMPARE(words.author, QString("B. Miner"));
        QCOMPARE(words.remark, QString("one\ntwo & three"));
        QCOMPARE(words.extension, QString(".pdf"));

        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        const auto made = [&](const char* name, const ReportWords& with) {
            QSignalSpy ended(&on.viewer.report, &ScanReport::ended);
            const std::string path = (folder_ / name).string();
            on.viewer.report.writeTo(QString::fromStdString(path), with);
            if (!ended.wait(4 * kPatienceMs)) return std::string();
            return test::fileText(path);
        };
        const std::string page = made("report.html", words);
        for (const char* part : {"Panel 3 &lt;west&gt;", "B. Miner", "one<br>\ntwo &amp; three", "class=\"logo\"", "--site"})
            QVERIFY2(page.find(part) != std::string::npos, part);
        const std::string pdf = made("report.pdf", words);
        QVERIFY2(pdf.starts_with("%PDF-"), pdf.substr(0, 20).c_str());
        QVERIFY2(pdf.size() > 20'000, "with its pictures");
        QVERIFY(pdf.find("%%EOF") != std::string::npos);
        QProcess reader; // of poppler-utils, where it is installed
        reader.start("pdftotext", {"-layout", QString::fromStdString((folder_ / "report.pdf").string()), "-"});
        if (reader.waitForFinished()) {
            const QString text = QString::fromUtf8(reader.readAllStandardOutput());
            for (const char* joined : {R"([0-9] m[0-9])", R"([0-9] mequal)", R"(Pictures\s*\f)"})
                QVERIFY2(!QRegularExpression(joined).match(text).hasMatch(), qPrintable(text));
            // The values of facts are next to their names. Flags and paths are not for paper.
            for (const char* row : {R"(Site +Panel 3 <west>)", R"(Report by +B\. Miner)"})
                QVERIFY2(QRegularExpression(row).match(text).hasMatch(), qPrintable(text));
            QVERIFY2(!text.contains("--") && !text.contains(QString::fromStdString(folder_.path().string())), qPrintable(text));
            QVERIFY2(!QRegularExpression("\\f\\s*(Gray levels:|Edges\\. Across)").match(text).hasMatch(), "a caption without its picture");
        }
        QProcess images; // the gray ramp, and the bar of the cloud's scale
        images.start("pdfimages", {"-list", QString::fromStdString((folder_ / "report.pdf").string())});
        if (images.waitForFinished()) {
            const QString list = QString::fromUtf8(images.readAllStandardOutput());
            QVERIFY2(QRegularExpression(R"(\b160 +12\b)").match(list).hasMatch(), qPrintable(list));
            // The bar has the share of the cloud's picture that it has on the page for browsers. Pixels and pixels per inch:
            const QRegularExpression row(R"((\d+) +\d+ +(?:rgb|gray)(?: +\S+){6} +(\d+) )");
            std::vector<double> wide;
            for (auto all = row.globalMatch(list); all.hasNext();) {
                const auto found = all.next();
                wide.push_back(found.captured(1).toDouble() / found.captured(2).toDouble());
            }
            const auto share = QRegularExpression(R"(flex:none;width:([0-9.]+)%)").match(QString::fromStdString(page));
            QVERIFY2(wide.size() >= 5 && share.hasMatch(), qPrintable(list));
            const double drawn = 100 * wide.back() / wide[wide.size() - 2];
            QVERIFY2(std::abs(drawn / share.captured(1).toDouble() - 1) < 0.03, qPrintable(QString::number(drawn) + list));
        }
        // Rocks that are shown are in it, unless the operator leaves them out.
        on.viewer.rocks.setShown(true);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind(); }));
        ReportWords bare = words;
        bare.rocks = false;
        QVERIFY(made("with.html", words).find("id=\"rocks\"") != std::string::npos);
        QVERIFY(made("rocks.pdf", words).starts_with("%PDF-"));
        QVERIFY(useTexts("es"));
        QVERIFY(made("rocas.pdf", words).starts_with("%PDF-"));
        QVERIFY(useTexts("en"));
        for (const char* name : {"report.pdf", "rocks.pdf", "rocas.pdf"}) hasFullPages(name, 3);
        for (std::size_t n = 0; n < 5; ++n) on.viewer.views.pin(on.viewer.rocks.picture()->study.rocks[n].cell);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{5});
        QCOMPARE(on.viewer.targets.withRocks().back().rock, on.viewer.rocks.picture()->study.rocks[4].label);
        QVERIFY(made("targets.pdf", words).starts_with("%PDF-"));
        hasFullPages("targets.pdf", 4);
        while (!on.viewer.targets.notebook().empty()) on.viewer.undo.undo();
        // Their table has the names of the targets on them.
        on.viewer.views.pin(on.viewer.rocks.picture()->study.rocks.front().cell);
        on.viewer.targets.rename(on.viewer.targets.active()->number, "Berta <1>");
        QVERIFY(made("named.html", words).find(">1 Berta &lt;1&gt;</td>") != std::string::npos);
        QVERIFY(made("without.html", bare).find("id=\"rocks\"") == std::string::npos);
        // What is not a PNG picture is refused, and nothing is written.
        ReportWords wrong = words;
        wrong.logo = QString::fromStdString(bell_);
        on.viewer.report.writeTo(QString::fromStdString((folder_ / "wrong.html").string()), wrong);
        QVERIFY2(on.viewer.notice.text().contains("not a PNG picture"), qPrintable(on.viewer.notice.text()));
        QVERIFY(!std::filesystem::exists(folder_ / "wrong.html"));
    }

    // A document of Qt shows no SVG: the size curve and the numbers of rocks are painted.
    void paperHasTheDrawingsOfThePage() {
        QImage picture(200, 100, QImage::Format_RGB32);
        picture.fill(Qt::gray);
        drawOver(picture, "<svg class=\"numbers\" style=\"--unit:30px\" viewBox=\"0 0 100 50\"><text x=\"50.5\" y=\"25\">7</text></svg>");
        int white = 0, outside = 0;
        for (int x = 0; x < 200; ++x) {
            for (int y = 0; y < 100; ++y) {
                const bool near = std::abs(x - 101) < 40 && std::abs(y - 50) < 45;
                (near ? white : outside) += picture.pixelColor(x, y) == QColor(near ? Qt::white : Qt::gray) ? 1 : 0;
            }
        }
        QVERIFY2(white > 50, "the number is on the picture");
        QCOMPARE(outside, 200 * 100 - 79 * 89);
        const QImage curve = imageOfDrawing("<svg viewBox=\"0 0 60 40\"><line x1=\"0\" y1=\"20\" x2=\"60\" y2=\"20\" stroke=\"#ff0000\"/>"
                                            "<path d=\"M10 5 H30 V35\" fill=\"none\" stroke=\"#0000ff\" stroke-width=\"2\"/></svg>",
                                            2.0);
        QCOMPARE(curve.size(), QSize(120, 80));
        QVERIFY(curve.pixelColor(100, 40).red() > 200 && curve.pixelColor(100, 40).blue() < 200);
        QVERIFY(curve.pixelColor(60, 60).blue() > 200 && curve.pixelColor(60, 60).red() < 100);
        QCOMPARE(curve.pixelColor(5, 5), QColor(Qt::white));
    }

    // Also the short legend of cab mode: a class with edges has its row.
    void theRowsOfTheLegendAddUpToItsTotal() {
        sim::SimulationSettings settings;
        settings.lines = 500;
        settings.beams = 571;
        const std::string scan = (folder_ / "voids.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, scan)));
        WindowFixture on;
        QVERIFY(on.showWith(scan));
        const edges::Detection& detection = *on.picture().detection;
        QVERIFY2(std::ranges::count(detection.classes->cells, edges::DepthEdge::Silhouette) > 0, "a class that is rare");
        for (const bool brief : {false, true}) {
            on.viewer.legend.setBrief(brief);
            on.viewer.legend.findChild<QToolButton*>("legend-unfold")->setChecked(true);
            std::size_t shown = 0;
            for (std::size_t n = 0; n < kEdgeClasses; ++n) {
                const auto* box = on.viewer.legend.findChild<QCheckBox*>(QString("legend-%1").arg(n));
                QVERIFY(box != nullptr);
                for (const std::uint32_t k : *detection.edges)
                    shown += !box->isHidden() && static_cast<std::size_t>((*detection.classes)[k]) == n + 1 ? 1 : 0;
            }
            QCOMPARE(shown, detection.edges->size());
        }
    }

    // Folded it is one row, and it stays so at the next start.
    void theLegendOfEdgesFolds() {
        test::TemporaryFolder memory;
        const QString path = QString::fromStdString((memory / "settings.ini").string());
        {
            WindowFixture on(path);
            on.window.resize(1280, 800);
            QVERIFY(on.showWith(bell_));
            EdgeLegend& legend = on.viewer.legend;
            QTRY_VERIFY(legend.unfold()->isVisible());
            const int open = legend.height();
            QTest::mouseClick(legend.unfold(), Qt::LeftButton);
            QTRY_VERIFY2(4 * legend.height() < open, qPrintable(QString("%1 of %2").arg(legend.height()).arg(open)));
            QVERIFY(legend.edges()->isVisible() && !legend.classSwitch(0)->isVisible());
        }
        WindowFixture again(path);
        again.window.resize(1280, 800);
        QVERIFY(again.showWith(bell_));
        QTRY_VERIFY(again.viewer.legend.unfold()->isVisible());
        QVERIFY(!again.viewer.legend.classSwitch(0)->isVisible());
        QTest::mouseClick(again.viewer.legend.unfold(), Qt::LeftButton);
        QTRY_VERIFY(again.viewer.legend.classSwitch(0)->isVisible());
    }

    // A row of the strip that is not needed any more goes, though not at once: nothing moves under a finger with each line.
    void theStripHasNoEmptyRow() {
        HealthStrip strip;
        strip.resize(500, 40);
        strip.setSteady(true);
        files::LiveHealth health;
        health.liveness = files::Liveness::Live;
        health.badge = "LIVE";
        health.lines = "1/600 lines";
        health.rows = 600;
        health.remark = "MOUNTING ASSUMED";
        health.telegrams = files::Condition::OutOfSpec;
        health.contamination = "window clean";
        health.pose = "no pose";
        strip.showHealth(health);
        const int before = strip.minimumHeight();
        health.remark.clear();
        health.contamination.clear();
        health.pose.clear();
        strip.showHealth(health);
        QCOMPARE(strip.minimumHeight(), before);
        strip.findChild<QTimer*>("live-empty-row")->setInterval(1);
        strip.showHealth(health);
        QTRY_VERIFY2(strip.minimumHeight() < before, qPrintable(QString("%1 after %2").arg(strip.minimumHeight()).arg(before)));
    }

    /// A sweep of 600 lines that grows.
    static files::LiveHealth growing() {
        files::LiveHealth health;
        health.liveness = files::Liveness::Live;
        health.badge = "LIVE";
        health.lines = "216/600 lines";
        health.rows = 600;
        health.row = 216;
        health.noReturn = "no return 0.3 %";
        health.telegrams = files::Condition::OutOfSpec;
        health.contamination = "window clean";
        health.pose = "no pose";
        return health;
    }

    // Hold gives the strip no other row, in any window of a desk: the pictures below it do not move.
    void holdKeepsTheRowsOfTheStrip() {
        files::LiveHealth health = growing();
        health.sweep = 2;
        health.end = "20 s left";
        health.remark = "FIRST ANGLE ASSUMED";
        HealthStrip strip;
        strip.show();
        for (int width = 600; width <= 1400; width += 20) {
            strip.resize(width, 40);
            strip.showHealth(health, HealthStrip::Picture::Follows);
            const int following = strip.heightForWidth(width);
            strip.showHealth(health, HealthStrip::Picture::Held);
            QVERIFY2(strip.heightForWidth(width) <= following, qPrintable(QString::number(width)));
        }
    }

    // The legend has their number.
    void theShareWithoutAReturnTakesNoRowForItself() {
        files::LiveHealth health = growing();
        health.sweep = 1;
        health.remark = "START ASSUMED";
        HealthStrip strip;
        strip.show();
        const auto* share = strip.findChild<QLabel*>("live-no-return");
        int shown = 0, dropped = 0;
        for (int width = 600; width <= 1400; width += 20) {
            strip.resize(width, 40);
            strip.showHealth(health);
            const int high = strip.heightForWidth(width);
            (share->isHidden() ? dropped : shown) += 1;
            files::LiveHealth without = health;
            without.noReturn.clear();
            strip.showHealth(without);
            QCOMPARE(strip.heightForWidth(width), high);
        }
        QVERIFY(shown > 0 && dropped > 0);
    }

    // The first sweep was joined in its middle; the second has another remark and an end. The pictures stay where they are.
    void theNextSweepKeepsTheRowsOfTheStrip() {
        files::LiveHealth first = growing();
        first.sweep = 1;
        first.remark = "START ASSUMED";
        files::LiveHealth second = first;
        second.sweep = 2;
        second.remark = "FIRST ANGLE ASSUMED";
        second.end = "20 s left";
        HealthStrip strip;
        strip.show();
        for (int width = 600; width <= 1600; width += 20) {
            strip.resize(width, 40);
            strip.showHealth(first);
            const int high = strip.heightForWidth(width);
            strip.showHealth(second);
            QVERIFY2(strip.heightForWidth(width) <= high, qPrintable(QString::number(width)));
        }
    }

    void aTargetOutOfViewHasNoTag() {
        QImage picture(200, 100, QImage::Format_RGB32);
        QPainter painter(&picture);
        ScreenMarks marks;
        marks.targets = {
            {QPointF(100, 50), false, "1", true}, {QPointF(-60, 50), false, "2", false}, {QPointF(90, 160), false, "3", false}};
        const auto tags = drawScreenMarks(painter, picture.rect(), marks);
        QCOMPARE(static_cast<int>(tags.size()), 1);
        QVERIFY(tags.front().left() > 100);
    }

    // HTML first, then PDF: the second form has the remark of the first; another scan's form has none.
    void theRemarkStaysWithItsScan() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        const auto asked = [&](const QString& typed) {
            QString before;
            QTimer hand;
            connect(&hand, &QTimer::timeout, &on.window, [&] {
                auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
                if (dialog == nullptr) return;
                auto* remark = dialog->findChild<QPlainTextEdit*>("report-remark");
                if (remark == nullptr) return dialog->reject(); // where to save
                before = remark->toPlainText();
                remark->setPlainText(typed);
                dialog->accept();
            });
            hand.start(20);
            on.viewer.report.ask();
            return before;
        };
        QCOMPARE(asked("wet walls"), QString());
        QCOMPARE(asked("wet walls"), QString("wet walls"));
        QVERIFY(on.open(bell_));
        QCOMPARE(asked(""), QString());
    }

    void paperSplitsNeitherShortParagraphsNorRowsAndLeavesNoHeadingAlone() {
        const QString three = "<p>" + QString("one two three four five six seven eight nine ten ").repeated(6) + "</p>";
        const QString row = "<tr><td>" + QString("first second third ").repeated(4) + "</td><td>more</td></tr>";
        for (int before = 0; before < 30; ++before) { // wherever the end of the page is
            QTextDocument document;
            document.setHtml(QString("<p>line</p>").repeated(before) + three.repeated(4) + "<h2>Heading</h2>" + three + "<table>" +
                             row.repeated(12) + "</table>" + three + "<table>" + row.repeated(70) + "</table>");
            document.setPageSize({400, 600});
            QVERIFY(document.pageCount() > 3);
            keepTogether(document);
            int longTable = 0;
            for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
                QVERIFY2(!isSplit(block), qPrintable(QString("%1 lines before: %2").arg(before).arg(block.text())));
                const auto pageOfBlock = [&](const QTextBlock& of) {
                    return pageOf(document, document.documentLayout()->blockBoundingRect(of).bottom() - 2);
                };
                if (block.text() == "Heading") QCOMPARE(pageOfBlock(block), pageOfBlock(block.next()));
                longTable += block.text() == "more" ? 1 : 0;
            }
            QCOMPARE(longTable, 82);
        }
    }

    // One key goes from balanced to images large to cloud large; the choice and an exchange are stored.
    void sharesAndAnExchangeAreStored() {
        const QString ini = QString::fromStdString((folder_ / "places.ini").string());
        const auto titleOf = [](QWidget& view) { return view.parentWidget()->findChild<QLabel*>()->parentWidget(); };
        {
            WindowFixture on(ini);
            on.window.resize(1280, 800);
            QVERIFY(on.showWith(bell_) && on.activate());
            const ImageView &gray = on.viewer.gray, &edges = on.viewer.edges;
            const CloudView& cloud = on.viewer.cloud;
            const auto key = [&] { QTest::keyClick(&on.window, Qt::Key_M, Qt::ControlModifier); };
            QTRY_VERIFY2(gray.width() >= 0.38 * 1280 - 2 && edges.width() == gray.width(), qPrintable(QString::number(gray.width())));
            const int usual = cloud.width();
            key();
            QTRY_VERIFY2(edges.width() >= 600 && cloud.width() < edges.width(), qPrintable(QString::number(edges.width())));
            QCOMPARE(on.window.places().share(), Share::Images);
            key();
            QTRY_VERIFY2(cloud.width() > 1.2 * usual && gray.width() < 0.3 * 1280, qPrintable(QString::number(cloud.width())));
            on.window.showAlone(&on.viewer.edges); // the choice is seen: it ends the large view
            key();
            QTRY_VERIFY(gray.isVisible() && edges.isVisible() && cloud.isVisible() && std::abs(cloud.width() - usual) <= 8);
            QTest::mouseDClick(titleOf(on.viewer.gray), Qt::LeftButton);
            QTRY_COMPARE(on.window.places().text(), QString("gray"));
            QVERIFY(!on.viewer.cloud.grabFrame().isNull());
            key(); // the image that is there stays
            QTRY_VERIFY2(gray.width() >= 600, qPrintable(QString::number(gray.width())));
        }
        WindowFixture on(ini);
        QVERIFY(on.showWith(bell_));
        QTRY_VERIFY(on.viewer.gray.width() > on.viewer.cloud.width());
        QCOMPARE(on.window.places().text(), QString("images gray"));
        QTest::mouseDClick(titleOf(on.viewer.cloud), Qt::LeftButton); // the cloud is large again: the images are not
        QTRY_COMPARE(on.window.places().share(), Share::Balanced);
        on.window.places().setShare(Share::Images);
        on.window.resetLayout();
        QCOMPARE(on.window.places().share(), Share::Balanced);
    }

    void viewsAreStoredAndGivenBack() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_) && on.activate());
        on.viewer.cloud.viewIsometric();
        const CameraPose stored = on.viewer.cloud.camera();
        QTest::keyClick(&on.window, Qt::Key_2, Qt::ControlModifier);
        QVERIFY(on.viewer.savedViews.view(2).has_value());
        on.viewer.cloud.viewTop();
        QVERIFY(on.viewer.cloud.camera() != stored);
        QTest::keyClick(&on.window, Qt::Key_2, Qt::AltModifier);
        QVERIFY(on.viewer.cloud.camera() == stored);
        QTest::keyClick(&on.window, Qt::Key_3, Qt::AltModifier); // there is none
        QVERIFY2(on.viewer.notice.text().contains("Ctrl+3"), qPrintable(on.viewer.notice.text()));
        const QString text = on.viewer.savedViews.text();
        on.viewer.savedViews.use(QString());
        QVERIFY(!on.viewer.savedViews.view(2));
        on.viewer.savedViews.use(text);
        QVERIFY((on.viewer.savedViews.view(2)->position - stored.position).norm() < 1e-6);
        for (const char* damaged : {"2", "x", "2 nan 0 0 0 0 1 0 1 0 45 0", "99 0 0 0 0 0 1 0 1 0 45 0", "2 0 0 0 0 0 0 0 1 0 45 0"}) {
            on.viewer.savedViews.use(damaged);
            QVERIFY2(on.viewer.savedViews.text().isEmpty(), damaged);
        }
    }

    void aFaceOfTheCubeLooksFromThere() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_) && on.activate());
        ViewCube& cube = on.viewer.viewCube;
        QTRY_VERIFY(cube.isVisible());
        // From the scanner's side: it is below these rocks, and up is its z.
        on.viewer.cloud.viewIsometric();
        QTRY_VERIFY(cube.middleOf(ViewCube::Face::Bottom).has_value());
        QVERIFY(!cube.middleOf(ViewCube::Face::Top));
        QTest::mouseClick(&cube, Qt::LeftButton, Qt::NoModifier, cube.middleOf(ViewCube::Face::Bottom)->toPoint());
        const auto forward = [&on] { return on.viewer.cloud.camera().forward(); };
        QVERIFY(forward().z() > 0.999);
        QVERIFY(on.viewer.cloud.camera().right().dot(on.viewer.cloud.geometryOfCloud()->scannerView.right) > 0.99); // as from the scanner
        QTest::keyClick(&on.window, Qt::Key_7);
        QVERIFY(forward().z() < -0.999);
        // Fit All Views fits what is looked at: the direction stays.
        on.viewer.cloud.setCamera(zoomed(on.viewer.cloud.camera(), on.viewer.cloud.camera().focus, 3.0));
        QTest::keyClick(&on.window, Qt::Key_R);
        QVERIFY(forward().z() < -0.999);
        on.viewer.cloud.viewFromScanner();
        const CameraPose first = on.viewer.cloud.camera();
        on.viewer.cloud.setCamera(zoomed(first, first.focus, 3.0));
        QTest::keyClick(&on.window, Qt::Key_R);
        QVERIFY(on.viewer.cloud.camera().position.isApprox(first.position));
        cube.setForGloves(true);
        QVERIFY(!cube.isVisible());
    }

    void aKeypadTypesIntoTheFieldInCabMode() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_) && on.activate());
        QLineEdit field(&on.window);
        field.setGeometry(100, 100, 200, 40);
        field.show();
        field.setFocus();
        Keypad& pad = on.window.cab().keypad();
        QVERIFY(!pad.isVisible());
        field.clearFocus();
        on.window.cab().set(true);
        field.raise();
        field.setFocus();
        QTRY_VERIFY(pad.isVisible());
        QCOMPARE(pad.field(), static_cast<QWidget*>(&field));
        QTest::mouseClick(pad.key("123"), Qt::LeftButton);
        for (const char* key : {"1", "0", ".", "4", "7", "⌫"}) {
            QVERIFY2(pad.key(key) != nullptr, key);
            QVERIFY(pad.key(key)->width() >= 48 && pad.key(key)->height() >= 48);
            QTest::mouseClick(pad.key(key), Qt::LeftButton);
        }
        QCOMPARE(field.text(), QString("10.4"));
        QVERIFY(field.hasFocus());
        field.clearFocus();
        on.window.cab().set(false);
        QVERIFY(!pad.isVisible());
    }
};

int look_test(int argc, char** argv) { return runWindowTest<LookTest>(argc, argv); }

#include "look_test.moc"
