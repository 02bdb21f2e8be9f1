// "Does this look right?" in the real window: a file read in the wrong unit causes a notice; another reading is previewed, adopted and
// undone.
#include "tests/support/folders.h"
#include "tests/support/point_lists.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/opening_card.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QStyle>
#include <QToolButton>
#include <QTreeWidget>

#include <fstream>

using namespace edgescan;
using namespace edgescan::ui;

class OpeningWindowTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string metres_;

    // Whole numbers in tenths of a metre: read as millimetres they are ten to twenty times too near.
    static void writeTable(const std::string& path, int unitMm = 10) {
        const Scan scan = test::boxesScan(40, 1141, 3, 0.0);
        std::ofstream file(path);
        for (int i = 0; i < scan.lines(); ++i) {
            for (int j = 0; j < scan.beams(); ++j)
                file << (j > 0 ? "," : "")
                     << (scan.state.at(i, j) == CellState::Valid ? static_cast<int>(scan.rangeMm.at(i, j)) / unitMm : 0);
            file << "\n";
        }
    }
    static double medianM(WindowFixture& on) {
        const Scan& scan = *on.picture().detection->scan;
        std::vector<float> ranges;
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] == CellState::Valid) ranges.push_back(scan.rangeMm[k]);
        }
        std::sort(ranges.begin(), ranges.end());
        return static_cast<double>(ranges[ranges.size() / 2]) / 1000.0;
    }
    // Clicks the reading whose text begins with these words.
    static bool choose(OpeningCard& card, const QString& words) {
        QTreeWidget* list = card.list();
        for (int n = 0; n < list->topLevelItemCount(); ++n) {
            for (int m = 0; m < list->topLevelItem(n)->childCount(); ++m) {
                QTreeWidgetItem* row = list->topLevelItem(n)->child(m);
                if (!row->text(1).startsWith(words)) continue;
                list->scrollToItem(row);
                QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(row).center());
                return true;
            }
        }
        return false;
    }
    static bool allIsRead(const QTreeWidget& list) {
        for (const QTreeWidgetItem* row = list.topLevelItem(0); row != nullptr; row = list.itemBelow(row)) {
            const int margin = 2 * (list.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
            const QRect room(0, 0, list.columnWidth(1) - margin, 10000);
            const QRect needed = list.fontMetrics().boundingRect(room, Qt::TextWordWrap, row->text(1));
            const int high = list.visualItemRect(row).height();
            // no gaps between rows either
            if (high < needed.height() || high > needed.height() + 3 * list.fontMetrics().height()) return false;
        }
        return true;
    }
    static bool checked(WindowFixture& on) {
        return on.settled() && eventually([&] { return on.viewer.opening.points().has_value(); });
    }

private slots:
    void cleanup() { useLanguage("en"); }

    void initTestCase() {
        metres_ = (folder_ / "table.csv").string();
        writeTable(metres_);
    }

    void aWrongUnitIsToldLookedAtAdoptedAndUndone() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(metres_) && on.activate());
        QVERIFY(checked(on));
        const double asOpened = medianM(on);
        QVERIFY2(asOpened < 1.0, "the table was not taken as millimetres");
        auto* offer = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QVERIFY2(offer->isVisible(), qPrintable(on.viewer.notice.text()));
        QTest::mouseClick(offer, Qt::LeftButton);
        OpeningCard* card = on.viewer.opening.card();
        QVERIFY(card != nullptr && QTest::qWaitForWindowExposed(card, kPatienceMs));
        QVERIFY(!card->isModal());
        // Preview: the scan is ten times larger, without an undo step.
        QVERIFY(choose(*card, "centimetres"));
        QVERIFY(eventually([&] { return on.settled() && medianM(on) > 5 * asOpened; }));
        QVERIFY(!on.viewer.undo.canUndo());
        // Closed: restored.
        card->reject();
        QVERIFY(eventually([&] { return on.settled() && std::abs(medianM(on) - asOpened) < 0.01; }));
        QVERIFY(!on.viewer.files.options().unitMm);
        // Adopted: one undo step; undo restores the former reading.
        QVERIFY(checked(on));
        on.viewer.opening.show();
        QVERIFY(choose(*card, "centimetres"));
        QTest::mouseClick(card->adopt(), Qt::LeftButton);
        QVERIFY(eventually([&] { return on.settled() && on.viewer.undo.count() == 1; }));
        card->reject();
        QVERIFY(eventually([&] { return on.settled() && medianM(on) > 5 * asOpened; }));
        QCOMPARE(on.viewer.files.options().unitMm.value_or(0.0), 10.0);
        on.viewer.undo.undo();
        QVERIFY(eventually([&] { return on.settled() && std::abs(medianM(on) - asOpened) < 0.01; }));
        QVERIFY(!on.viewer.files.options().unitMm);
    }

    // Another error replaced the notice before it was read: a button shows the notice again, with its action.
    void aNoteThatWasReplacedIsNotLost() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(metres_) && on.activate());
        QVERIFY(checked(on));
        NoticeBar& notice = on.viewer.notice;
        auto* offer = notice.findChild<QToolButton*>("notice-action");
        auto* earlier = notice.findChild<QToolButton*>("notice-earlier");
        notice.withdraw({"This scan is flat and quiet: with the preset Smooth walls low steps far away are edges too."}); // no folds
        QVERIFY2(offer->isVisible() && earlier->isHidden(), qPrintable(notice.text()));
        const QString first = notice.text(), missing = QString::fromStdString((folder_ / "missing.json").string());
        for ([[maybe_unused]] const int again : {1, 2}) {
            on.viewer.files.open({missing});
            QVERIFY(eventually([&] { return notice.text().contains("missing.json") && on.settled(); }));
            QVERIFY(!offer->isVisible() && !earlier->isHidden());
            notice.unfold(true);
            QCOMPARE(earlier->text(), QString("1 of 2")); // the same notice twice counts once
        }
        QTest::mouseClick(earlier, Qt::LeftButton);
        QCOMPARE(notice.text(), first);
        QVERIFY(offer->isVisible());
        QTest::mouseClick(earlier, Qt::LeftButton); // the button cycles
        QVERIFY(notice.text().contains("missing.json"));
        // A hint is about one step: it hides no notice and does not come back.
        QTest::keyClick(&on.window, Qt::Key_I);
        QVERIFY2(notice.text().startsWith("Nothing is selected"), qPrintable(notice.text()));
        QCOMPARE(earlier->text(), QString("1 of 3"));
        QTest::mouseClick(earlier, Qt::LeftButton);
        QVERIFY(notice.text().contains("missing.json"));
        QTest::mouseClick(earlier, Qt::LeftButton);
        QTest::mouseClick(offer, Qt::LeftButton);
        QVERIFY(on.viewer.opening.card() != nullptr && QTest::qWaitForWindowExposed(on.viewer.opening.card(), kPatienceMs));
        on.viewer.opening.card()->reject();
        // A closed notice counts as read.
        QVERIFY(on.activate());
        for (int n = 0; n < 2; ++n) QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(!notice.isVisible());
        QTest::keyClick(&on.window, Qt::Key_I);
        QVERIFY(notice.isVisible() && !earlier->isVisible());
    }

    void aFileThatSaysItselfAsksNothing() {
        WindowFixture on;
        const std::string path = (folder_ / "grid.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3, 0.0), path)));
        QVERIFY(on.showWith(path));
        QVERIFY(checked(on));
        QVERIFY2(!files::looksWrong(*on.viewer.opening.points()), "something speaks against a sweep that was simulated");
        QVERIFY(!on.viewer.notice.isVisible());
    }

    void theCardGoesWithItsScan() {
        WindowFixture on;
        QVERIFY(on.showWith(metres_) && on.activate());
        QVERIFY(checked(on));
        on.viewer.opening.show();
        QVERIFY(choose(*on.viewer.opening.card(), "metres"));
        const std::string path = (folder_ / "other.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3, 0.0), path)));
        QVERIFY(on.settled());
        QVERIFY(on.open(path));
        QVERIFY(!on.viewer.opening.card()->isVisible());
        QVERIFY(!on.viewer.files.options().unitMm);
        QCOMPARE(on.viewer.files.path(), QString::fromStdString(path));
    }

    // A bag of two lasers: the card lists both with what each gives, and a click shows the other one.
    void theTopicsOfABagAreChosenInTheWindow() {
        const auto laser = [](int lines, int beams) {
            Scan scan = test::boxesScan(lines, beams, 3, 0.0);
            auto& polar = std::get<PolarGeometry>(scan.geometry);
            polar.axis = Axis::Sweep;
            for (int i = 0; i < lines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -20 + 0.5 * i;
            return scan;
        };
        test::RosMessages bag = test::rosMessagesOf(laser(60, 90));
        const test::RosMessages rear =
            test::rosMessagesOf(laser(40, 70), {.from = test::AngleFrom::Joint, .scanTopic = "/rear/scan", .frame = "rear"});
        const auto first = static_cast<std::uint32_t>(bag.topics.size());
        bag.topics.insert(bag.topics.end(), rear.topics.begin(), rear.topics.end());
        for (const auto& message : rear.messages) bag.message(message.topic + first, message.ns, message.bytes);
        const std::string path = (folder_ / "two.bag").string();
        const Bytes bytes = test::bag1Of(bag);
        test::writeText(path, std::string(bytes.begin(), bytes.end()));
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(path) && on.activate());
        QVERIFY(checked(on));
        QCOMPARE(on.picture().detection->scan->lines(), 60);
        auto* offer = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QVERIFY2(offer->isVisible(), qPrintable(on.viewer.notice.text()));
        QTest::mouseClick(offer, Qt::LeftButton);
        OpeningCard* card = on.viewer.opening.card();
        QVERIFY(card != nullptr && QTest::qWaitForWindowExposed(card, kPatienceMs));
        QVERIFY(card->list()->topLevelItem(0)->text(1).contains("/robot/scan: lines of 90 beams; messages: 60, per second: 25"));
        QVERIFY(choose(*card, "/rear/scan: lines of 70 beams; messages: 40"));
        QVERIFY(eventually([&] { return on.settled() && on.picture().detection->scan->lines() == 40; }));
        QTest::mouseClick(card->adopt(), Qt::LeftButton);
        QVERIFY(eventually([&] { return on.settled() && on.viewer.undo.count() == 1; }));
        QCOMPARE(on.viewer.files.options().topic, std::string("/rear/scan"));
        card->reject();
    }

    // In each language: sentences about the scan are translated, numbers are not, and every row is high enough for its text.
    void whatItSaysOfTheScanIsInTheLanguageOfTheWindow() {
        for (const auto& [code, words] : {std::pair{"fr", "la moitié des distances est inférieure à "},
                                          {"es", "la mitad de las distancias es inferior a "},
                                          {"pt", "metade das distâncias é inferior a "},
                                          {"en", "half of the ranges are below "}}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            on.window.resize(1280, 800);
            QVERIFY(on.showWith(metres_) && on.activate());
            QVERIFY(checked(on));
            on.viewer.opening.show();
            OpeningCard* card = on.viewer.opening.card();
            QVERIFY(QTest::qWaitForWindowExposed(card, kPatienceMs));
            QTreeWidget* list = card->list();
            const files::OpeningPoint& unit = on.viewer.opening.points()->front();
            const QString sentence = list->topLevelItem(0)->text(1);
            QVERIFY2(sentence.contains(QString(words) + QString::fromStdString(unit.taken.values.front())), qPrintable(sentence));
            // Every sentence is translated; none stays English.
            const auto& points = *on.viewer.opening.points();
            int others = 0;
            for (int n = 0; n < list->topLevelItemCount(); ++n) {
                for (int m = 0; m < list->topLevelItem(n)->childCount(); ++m) {
                    const QTreeWidgetItem* row = list->topLevelItem(n)->child(m);
                    if (row->data(0, Qt::UserRole).isNull()) continue;
                    const files::OtherReading& other =
                        points[static_cast<std::size_t>(n)].others[static_cast<std::size_t>(row->data(0, Qt::UserRole).toInt())];
                    QCOMPARE(row->text(1), shownSentence(other.words));
                    QCOMPARE(row->text(1) == QString::fromStdString(other.words.text()), QString(code) == "en");
                    ++others;
                }
            }
            QVERIFY(others > 4);
            for (const int width : {680, 1000}) { // row heights depend on the width
                card->resize(width, 500);
                QTRY_VERIFY2(allIsRead(*list), qPrintable(QString("%1 %2").arg(code).arg(width)));
            }
        }
    }

    void withoutAFileItSaysSo() {
        WindowFixture on;
        QVERIFY(on.show());
        on.viewer.opening.show();
        QVERIFY(on.viewer.notice.isVisible() && on.viewer.opening.card() == nullptr);
    }

    // In a cab the operator judges the picture: the card leaves most of the cloud in sight, and its texts do not cover its list.
    void theCardIsBesideThePicture() {
        const std::string path = (folder_ / "assumed.csv").string();
        writeTable(path, 1);
        const std::vector<std::pair<const char*, QSize>> all{
            {"es", {853, 480}}, {"fr", {853, 480}}, {"pt", {1024, 743}}, {"en", {853, 480}}, {"en", {1280, 775}}};
        for (const auto& [code, size] : all) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(path) && checked(on));
            on.window.cab().set(true);
            on.window.resize(size);
            QTRY_COMPARE(on.window.size(), size);
            on.viewer.opening.show();
            OpeningCard& card = *on.viewer.opening.card();
            QVERIFY(QTest::qWaitForWindowExposed(&card, kPatienceMs));
            const auto check = [&, code = code, size = size](const char* when) {
                const QRect place = card.frameGeometry();
                const CloudView& cloud = on.viewer.views.cloud();
                const QByteArray where = QString("%1 %2 %3").arg(code).arg(size.width()).arg(when).toUtf8();
                QVERIFY2(place.left() - cloud.mapToGlobal(QPoint()).x() >= 0.45 * cloud.width(), where);
                QVERIFY2(card.screen()->availableGeometry().contains(place), where);
                for (const QLabel* each : card.findChildren<QLabel*>()) {
                    QVERIFY2(each->height() >= each->heightForWidth(each->width()), where + each->text().toUtf8());
                    QVERIFY2(!each->geometry().intersects(card.list()->geometry()), where + each->text().toUtf8());
                }
            };
            check("opened");
            if (QString(code) == "en") {
                QVERIFY2(card.verdict().contains("assumed (mounting, line angles), and the scan itself does not contradict it"),
                         qPrintable(card.verdict()));
                QVERIFY(choose(card, "a step of"));
                QApplication::processEvents();
                check("looked at");
            }
            card.reject();
            QVERIFY(on.settled());
            on.window.cab().set(false);
        }
    }
};

int opening_window_test(int argc, char** argv) { return runWindowTest<OpeningWindowTest>(argc, argv); }
#include "opening_window_test.moc"
