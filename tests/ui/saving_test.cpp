// Saving in the real window: a file is replaced only after a question that names it, and a preset never replaces a file that is not a
// preset.
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/panels/dialogs/export_dialog.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/window/cab_mode.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

template <class Dialog>
Dialog* shownDialog() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* dialog = qobject_cast<Dialog*>(widget); dialog != nullptr && dialog->isVisible()) return dialog;
    }
    return nullptr;
}

// Types a name into the file dialog when it appears, and then answers the following questions, one after the other.
struct Hand : QObject {
    Hand(const QString& name, QStringList answers) : name_(name), answers_(std::move(answers)) {
        connect(&timer_, &QTimer::timeout, this, &Hand::look);
        timer_.start(30);
    }
    QStringList asked; // object names of the questions

private:
    void look() {
        if (auto* box = shownDialog<QMessageBox>()) {
            asked << box->objectName();
            const QString answer = answers_.isEmpty() ? QString() : answers_.takeFirst();
            for (QAbstractButton* button : box->buttons()) {
                if (button->objectName() == answer) return QTest::mouseClick(button, Qt::LeftButton);
            }
            return QTest::keyClick(box, Qt::Key_Escape);
        }
        auto* dialog = shownDialog<QFileDialog>();
        if (dialog == nullptr) return;
        if (typed_) return QTest::keyClick(dialog, Qt::Key_Escape); // asked again: cancels
        typed_ = true;
        auto* edit = dialog->findChild<QLineEdit*>("fileNameEdit");
        edit->setText(name_); // keyboard input would open the list of completions
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
    }

    QTimer timer_;
    QString name_;
    QStringList answers_;
    bool typed_ = false;
};

bool acceptExport() {
    auto* dialog = shownDialog<ExportDialog>();
    if (dialog != nullptr) dialog->accept();
    return dialog != nullptr;
}

} // namespace

class SavingTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_, other_;

    [[nodiscard]] QString path(const char* name) const { return QString::fromStdString((folder_ / name).string()); }
    [[nodiscard]] std::string text(const char* name) const { return test::fileText((folder_ / name).string()); }

private slots:
    void initTestCase() {
        qRegisterMetaType<exports::ExportContent>("edgescan::ExportContent");
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        scan_ = (folder_ / "shown.json").string();
        other_ = (folder_ / "other.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3, 0.05), scan_)));
        QVERIFY(bool(files::saveScan(test::boxesScan(50, 70, 4, 0.05), other_)));
    }

    void aPresetNeverReplacesAScan() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        const std::string before = text("other.json");
        {
            Hand hand(path("other"), {}); // typed without its extension
            on.viewer.tuning.askSavePreset();
            QCOMPARE(hand.asked, QStringList("kept-file"));
        }
        QVERIFY(text("other.json") == before);
        // A new name needs no question; an existing preset needs one, which can be declined.
        {
            Hand hand(path("mine"), {});
            on.viewer.tuning.askSavePreset();
            QVERIFY(hand.asked.isEmpty());
        }
        QVERIFY(bool(edges::findPreset((folder_ / "mine.json").string())));
        edges::Settings other;
        other.creaseDeg = 44;
        QVERIFY(on.use(other));
        {
            Hand hand(path("mine"), {"no"});
            on.viewer.tuning.askSavePreset();
            QCOMPARE(hand.asked, QStringList("replace-question"));
        }
        QVERIFY(edges::findPreset((folder_ / "mine.json").string())->settings.creaseDeg != 44);
        {
            Hand hand(path("mine"), {"replace"});
            on.viewer.tuning.askSavePreset();
        }
        QCOMPARE(edges::findPreset((folder_ / "mine.json").string())->settings.creaseDeg, 44.0);
    }

    void aScreenshotAsksAlsoWhereTheExtensionWasNotTyped() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.activate());
        QFile there(path("shot.png"));
        QVERIFY(there.open(QIODevice::WriteOnly));
        there.write("precious");
        there.close();
        {
            Hand hand(path("shot"), {"no"});
            QTest::keyClick(&on.window, Qt::Key_F12);
            QCOMPARE(hand.asked, QStringList("replace-question"));
        }
        QVERIFY(text("shot.png") == "precious");
        QVERIFY(on.activate()); // the question dialog had the focus
        {
            Hand hand(path("shot"), {"replace"});
            QTest::keyClick(&on.window, Qt::Key_F12);
            QCOMPARE(hand.asked, QStringList("replace-question"));
        }
        QVERIFY(QImage(path("shot.png")).width() > 100);
    }

    // With the dialog, whether the extension was typed or not: the file has it once, and opens as a session. A name that ends in .json is
    // used as it was typed.
    void aSessionHasItsEndingAndOpensAgain() {
        for (const char* typed : {"day", "night.edgescan-session.json", "s1.json"}) {
            const QString file = path(QString(typed).contains('.') ? typed : "day.edgescan-session.json");
            {
                WindowFixture on;
                QVERIFY(on.showWith(scan_) && on.activate());
                on.viewer.views.pin(on.viewer.views.cellAt(10, 12));
                Hand hand(path(typed), {});
                QTest::keyClick(&on.window, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
                QVERIFY(eventually([&] { return QFile::exists(file) && on.window.sessions().settled(); }));
                QVERIFY(hand.asked.isEmpty());
            }
            WindowFixture on;
            QVERIFY(on.show());
            on.window.sessions().open({file});
            QVERIFY(eventually([&] { return on.viewer.targets.notebook().targets.size() == 1; }));
            QCOMPARE(on.window.sessions().path(), file);
        }
        QVERIFY(QDir(QString::fromStdString(folder_.path().string())).entryList({"*.edgescan"}).isEmpty());
    }

    // The button of a cab opens the menu of the tool bar: targets and rocks are in it. Targets go to a table or a drawing.
    void theCabExportsTargetsAndRocksToo() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        const auto tap = [&on](const char* id) -> QAction* {
            QTest::mouseClick(tool(on.window, "cab-export"), Qt::LeftButton);
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QAction* wanted = &actionOf(keyedCommands(on.window.actions()), id);
            if (menu == nullptr || !menu->actions().contains(wanted)) return nullptr;
            menu->close();
            return wanted;
        };
        QVERIFY(tap("Rocks/Export Rocks") != nullptr);
        QAction* const targets = tap("File/Export/Targets");
        QVERIFY(targets != nullptr && !targets->isEnabled());
        on.viewer.views.pin(10 * 80 + 20);
        on.viewer.views.pin(30 * 80 + 40);
        QVERIFY(tap("File/Export/Targets")->isEnabled());
        QStringList formats;
        const Meanwhile chosen([&] {
            auto* dialog = shownDialog<ExportDialog>();
            if (dialog == nullptr) return false;
            formats = dialog->filters();
            dialog->accept();
            return true;
        });
        QSignalSpy saved(&on.viewer.engine, &Engine::saved);
        const Hand hand(path("pins"), {});
        targets->trigger();
        QCOMPARE(formats.size(), 2);
        QVERIFY2(formats.join('|').contains("*.csv") && formats.join('|').contains("*.dxf"), qPrintable(formats.join('|')));
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY2(on.viewer.notice.text().contains("2 targets"), qPrintable(on.viewer.notice.text()));
        QVERIFY(QFile::exists(path("pins.csv")) || QFile::exists(path("pins.dxf")));
    }

    // The provenance record of the file would be lost as well.
    void anExportAsksForTheRecordToo() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QFile record(path("e.pcd.provenance.json"));
        QVERIFY(record.open(QIODevice::WriteOnly));
        record.write(R"({"format": "edgescan-provenance/1"})");
        record.close();
        const auto ask = [&](const QStringList& answers) {
            const Meanwhile accepted([] { return acceptExport(); });
            Hand hand(path("e"), answers);
            on.viewer.exports.ask(exports::ExportContent::EdgeCloud);
            return hand.asked;
        };
        QCOMPARE(ask({"no"}), QStringList("replace-question"));
        QVERIFY(text("e.pcd.provenance.json") == R"({"format": "edgescan-provenance/1"})");
        QVERIFY(!QFile::exists(path("e.pcd")));
        QSignalSpy saved(&on.viewer.engine, &Engine::saved);
        QCOMPARE(ask({"replace"}), QStringList("replace-question"));
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(QFile::exists(path("e.pcd")));
    }

    void theExtensionIsThatOfTheKindThatWasChosen() {
        const QStringList filters{"Point Cloud Library (*.pcd)", "CSV (*.csv)", "E57 (*.e57 *.E57)"};
        QCOMPARE(withExtension("/a/b", filters, filters[1]), QString("/a/b.csv"));
        QCOMPARE(withExtension("/a/b.PCD", filters, filters[1]), QString("/a/b.PCD"));
        QCOMPARE(withExtension("/a/bell_1.00", filters, filters[0]), QString("/a/bell_1.00.pcd"));
        QCOMPARE(withExtension("/a.pcd/b", filters, {}), QString("/a.pcd/b.pcd"));
        QCOMPARE(withExtension("/a/.pcd", filters, {}), QString("/a/.pcd.pcd"));
    }

    void theNameSaysWhatTheEdgesWereFoundWith() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        const auto proposed = [&] {
            QString name;
            const Meanwhile accepted([] { return acceptExport(); });
            QTimer look;
            connect(&look, &QTimer::timeout, this, [&name] {
                if (auto* dialog = shownDialog<QFileDialog>()) {
                    name = dialog->findChild<QLineEdit*>("fileNameEdit")->text();
                    QTest::keyClick(dialog, Qt::Key_Escape);
                }
            });
            look.start(30);
            on.viewer.exports.ask(exports::ExportContent::EdgeCloud);
            return name;
        };
        edges::Settings strong;
        strong.sensitivity = 1.5;
        QVERIFY(on.use(strong));
        const QString name = proposed();
        QVERIFY2(name.contains("_edges_edgescan+_edge-strength1.5_") && !name.contains("_K"), qPrintable(name));
        edges::Settings canny = edges::cannySettings();
        canny.lower = 7;
        QVERIFY(on.use(canny));
        QVERIFY2(proposed().contains("_edges_canny_lower-threshold7_"), qPrintable(proposed()));
    }

    // The first folder is that of the scan, with or without a settings memory; never the folder in which the program was started.
    void aDialogBeginsWhereTheScanLies() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        const auto begins = [&](const std::function<void()>& ask) {
            QString folder;
            QTimer look;
            connect(&look, &QTimer::timeout, this, [&folder] {
                if (auto* dialog = shownDialog<QFileDialog>()) {
                    folder = dialog->directory().canonicalPath();
                    QTest::keyClick(dialog, Qt::Key_Escape);
                }
            });
            look.start(30);
            ask();
            return folder;
        };
        const QString folder = QFileInfo(QString::fromStdString(scan_)).canonicalPath();
        QVERIFY(folder != QDir::current().canonicalPath());
        QCOMPARE(begins([&] { on.viewer.files.ask(); }), folder);
        QCOMPARE(begins([&] { on.viewer.exports.askScreenshot(QImage(8, 8, QImage::Format_RGB32)); }), folder);
        QCOMPARE(begins([&] { on.window.sessions().ask(); }), folder);
        QCOMPARE(begins([&] { on.viewer.tuning.askOpenPreset(); }), folder);
        // After saving elsewhere the dialog begins there, until that folder is deleted.
        const QString elsewhere = path("elsewhere");
        QVERIFY(QDir().mkpath(elsewhere));
        on.preferences.keepFolder("presets", elsewhere + "/mine.json");
        QCOMPARE(begins([&] { on.viewer.tuning.askOpenPreset(); }), QDir(elsewhere).canonicalPath());
        QVERIFY(QDir().rmdir(elsewhere));
        QCOMPARE(begins([&] { on.viewer.tuning.askOpenPreset(); }), folder);
        // What one command saved is where the others begin, whatever they save.
        QVERIFY(QDir().mkpath(elsewhere));
        for (const auto content : {exports::ExportContent::EdgeImage, exports::ExportContent::EdgeCloud}) {
            on.preferences.keepFolder("exports", QString::fromStdString(scan_));
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            on.viewer.engine.save(content, elsewhere + (exports::isCloud(content) ? "/a.pcd" : "/a.png"));
            QTRY_COMPARE(saved.count(), 1);
            QCOMPARE(begins([&] { on.viewer.exports.askScreenshot(QImage(8, 8, QImage::Format_RGB32)); }), QDir(elsewhere).canonicalPath());
            QCOMPARE(begins([&] { on.window.sessions().ask(); }), QDir(elsewhere).canonicalPath());
        }
    }

    // The dialog has the same writing choices as the command line; the record names them.
    void theWritingChoicesAreThoseOfTheCommandLine() {
        const auto detection = edges::detectEdges(std::make_shared<const Scan>(*files::openScan(scan_)), edges::Settings{});
        ExportDialog dialog(detection, exports::ExportContent::EdgeCloud);
        dialog.show();
        QVERIFY(dialog.options().choices == files::WritingChoices{});
        for (const files::WritingChoice& choice : files::kWritingChoices) {
            auto* box = dialog.findChild<QCheckBox*>(choice.key);
            QVERIFY2(box != nullptr, choice.key);
            QCOMPARE(box->isEnabled(), choice.member != &files::WritingChoices::filled); // this scan has no filled cells
            if (!box->isEnabled() || !choice.changes(".csv")) continue;                  // the command line refuses the others
            QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {8, box->height() / 2});
            QVERIFY2(dialog.options().choices.*choice.member, choice.key);
        }
        const std::string csv = (folder_ / "chosen.csv").string();
        QVERIFY(bool(exports::exportWithProvenance(dialog.content(), *detection, csv, dialog.options())));
        QCOMPARE(
            test::runCli("detect '" + scan_ + "' --comments --with-confidence --with-borders --edges " + (folder_ / "cli.csv").string())
                .code,
            0);
        QVERIFY(text("chosen.csv") == text("cli.csv"));
        QVERIFY(text("chosen.csv").find('#') != std::string::npos);
    }
};

int saving_test(int argc, char** argv) { return runWindowTest<SavingTest>(argc, argv); }

#include "saving_test.moc"
