// The themes: every used pair of colours has enough contrast, and the whole window changes while the views stay dark.
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/base/themes.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/window/side_column.h"
#include "ui/window/theme.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QStatusBar>
#include <QTableWidget>

using namespace edgescan;
using namespace edgescan::ui;

class ThemesTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;

    // Luminance of WCAG 2.
    static double luminance(const QColor& c) {
        const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    }
    static double contrast(const QColor& a, const QColor& b) {
        const double x = luminance(a) + 0.05;
        const double y = luminance(b) + 0.05;
        return std::max(x, y) / std::min(x, y);
    }
    // Chooses the entry of View > Theme like an operator.
    static void choose(MainWindow& window, const char* key) {
        auto* action = window.findChild<QAction*>(QString("theme-") + key);
        QVERIFY(action != nullptr);
        action->trigger();
        QApplication::processEvents();
        QVERIFY(action->isChecked());
    }
    // The difference between the lightest and darkest colour: text and background.
    static double spread(const QImage& image) {
        double least = 1.0, most = 0.0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const double l = luminance(image.pixelColor(x, y));
                least = std::min(least, l);
                most = std::max(most, l);
            }
        }
        return (most + 0.05) / (least + 0.05);
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        const Scan scan = test::boxesScan(120, 160, 3, 0.05);
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(scan, scan_)));
    }
    void cleanupTestCase() { useColours(themes().front()); }

    // As in spreadsheets: the largest first is an arrow downwards, whose upper side is the wide one.
    void theArrowOfTheLargestFirstPointsDown() {
        const auto headWith = [](Qt::SortOrder order) {
            QTableWidget table(1, 1);
            table.setHorizontalHeaderItem(0, new QTableWidgetItem(QString()));
            table.horizontalHeader()->setSortIndicatorShown(true);
            table.horizontalHeader()->setSortIndicator(0, order);
            table.resize(300, 200);
            return table.horizontalHeader()->grab().toImage();
        };
        const QImage largestFirst = headWith(Qt::DescendingOrder), smallestFirst = headWith(Qt::AscendingOrder);
        QCOMPARE(largestFirst.size(), smallestFirst.size());
        // The centre of the dark pixels that only one of the two has: that of a triangle is nearer to its wide side.
        double down = 0.0, up = 0.0;
        int ofDown = 0, ofUp = 0;
        for (int y = 0; y < largestFirst.height(); ++y) {
            for (int x = 0; x < largestFirst.width(); ++x) {
                const double by = luminance(largestFirst.pixelColor(x, y)) - luminance(smallestFirst.pixelColor(x, y));
                if (std::abs(by) < 0.02) continue;
                const bool isOfDown = (by > 0.0) == (luminance(themeInUse().text) > luminance(themeInUse().button));
                (isOfDown ? down : up) += y;
                ++(isOfDown ? ofDown : ofUp);
            }
        }
        QVERIFY2(ofDown > 3 && ofUp > 3, qPrintable(QString("%1 %2").arg(ofDown).arg(ofUp)));
        QVERIFY2(down / ofDown < up / ofUp, qPrintable(QString("%1 %2").arg(down / ofDown).arg(up / ofUp)));
    }

    void everyPairInUseCanBeToldApart() {
        for (const Theme& theme : themes()) {
            for (const ColourPair& pair : pairsInUse()) {
                const double is = contrast(theme.*pair.front, theme.*pair.ground);
                QVERIFY2(is >= pair.least, qPrintable(QString("%1, %2: %3").arg(theme.key, pair.what).arg(is, 0, 'f', 2)));
            }
            QVERIFY2(contrast(Qt::white, theme.chosen) >= 4.5, theme.key); // text of a selected row
            const QPalette palette = paletteOf(theme);
            for (const auto& [words, ground] : {std::pair{QPalette::WindowText, QPalette::Window},
                                                {QPalette::Text, QPalette::Base},
                                                {QPalette::Text, QPalette::AlternateBase},
                                                {QPalette::ButtonText, QPalette::Button},
                                                {QPalette::ToolTipText, QPalette::ToolTipBase},
                                                {QPalette::PlaceholderText, QPalette::Base},
                                                {QPalette::BrightText, QPalette::Window},
                                                {QPalette::HighlightedText, QPalette::Highlight}})
                QVERIFY2(contrast(palette.color(words), palette.color(ground)) >= 4.5, theme.key);
        }
    }

    void theWindowFollowsAndTheViewsStayDark() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(scan_));
        for (const Theme& theme : themes()) {
            choose(on.window, theme.key);
            const QImage shot = on.window.screenshot();
            QCOMPARE(shot.pixelColor(on.window.statusBar()->mapTo(&on.window, QPoint(2, 2))), theme.window);
            const CloudView& cloud = on.viewer.views.cloud();
            QCOMPARE(shot.pixelColor(cloud.mapTo(&on.window, QPoint(cloud.width() - 2, 2))), QColor(48, 48, 48));
            // The column at their side follows, and its signs have the ground of the views.
            SideColumn& side = on.window.side();
            const QImage column = side.grab().toImage();
            QCOMPARE(column.pixelColor(2, 2), theme.window);
            const auto* box = on.viewer.legend.findChild<QCheckBox*>("legend-0");
            const QImage sign = box->icon().pixmap(box->iconSize()).toImage();
            QCOMPARE(sign.pixelColor(0, 0), themes().front().window);
            const auto* words = on.viewer.legend.findChild<QLabel*>();
            QVERIFY2(spread(column.copy(QRect(words->mapTo(&side, QPoint()), words->size()))) >= 4.5, theme.key);
        }
    }

    void whatIsWrittenCanBeReadInEachTheme() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(scan_));
        on.viewer.notice.showNotice(NoticeBar::Kind::Error, "it failed");
        for (const Theme& theme : themes()) {
            choose(on.window, theme.key);
            on.viewer.warnings.showWarnings({QString("a line is missing, ") + theme.key});
            QVERIFY(!on.viewer.warnings.isHidden());
            int seen = 0;
            for (QWidget* each : on.window.findChildren<QWidget*>()) {
                auto* label = qobject_cast<QLabel*>(each);
                auto* button = qobject_cast<QAbstractButton*>(each);
                const QString words = label != nullptr ? label->text() : button != nullptr ? button->text() : QString();
                if (words.trimmed().isEmpty() || !each->isVisible() || each->width() < 8 || each->height() < 8) continue;
                ++seen;
                const double least = each->isEnabled() ? 4.5 : 3.0;
                QVERIFY2(spread(each->grab().toImage()) >= least,
                         qPrintable(QString("%1: \"%2\" of %3").arg(theme.key, words, each->objectName())));
            }
            QVERIFY2(seen > 20, qPrintable(QString::number(seen)));
        }
    }

    void itIsRemembered() {
        const QString ini = QString::fromStdString((folder_ / "theme.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(on.show());
            choose(on.window, "day");
        }
        useColours(themes().front());
        WindowFixture again(ini);
        QVERIFY(again.show());
        QCOMPARE(QString(themeInUse().key), QString("day"));
        QVERIFY(again.window.findChild<QAction*>("theme-day")->isChecked());
        QCOMPARE(again.window.palette().color(QPalette::Window), themeOf("day").window);
        QCOMPARE(QString(themeOf("no such theme").key), QString("night"));
    }
};

int themes_test(int argc, char** argv) { return runWindowTest<ThemesTest>(argc, argv); }
#include "themes_test.moc"
