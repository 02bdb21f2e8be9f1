// The window in other languages: every text has a translation, and only texts change.
#include "core/base/whole_file.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/presets.h"
#include "core/exports/html/scan_page.h"
#include "core/files/live_feed/live_health.h"
#include "core/files/open_save/open_scan.h"
#include "core/inspect/change_detection/change_report.h"
#include "core/rocks/attributes/study.h"
#include "core/rocks/selection/rock_settings.h"
#include "core/scan/grid/reading_options.h"
#include "core/scanner/cola/link.h"
#include "tests/support/folders.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/language/catalogue.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/files/file_filters.h"
#include "ui/controllers/report_words.h"
#include "ui/panels/dialogs/export_dialog.h"
#include "ui/panels/dialogs/opening_card.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/target_words.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/window/cab_mode.h"
#include "ui/window/view_choices.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QRegularExpression>
#include <QToolButton>

#include <algorithm>
#include <filesystem>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

const QString kTexts = QString::fromStdString(test::sourceFolder()) + "/resources/languages";

QStringList placeholdersOf(const QString& text) {
    static const QRegularExpression placeholder("%[0-9n]");
    QStringList found;
    for (auto all = placeholder.globalMatch(text); all.hasNext();) found << all.next().captured();
    found.sort();
    return found;
}

int mnemonicsIn(const QString& text) { return text.count('&') - 2 * text.count("&&"); }

QSet<QString> keysOf(const QWidget& window) {
    QSet<QString> keys;
    for (const QAction* action : window.findChildren<QAction*>()) {
        for (const QKeySequence& key : action->shortcuts()) keys << key.toString();
    }
    return keys;
}

/// Visible texts: actions, labels, buttons, titles.
QStringList shownIn(const QWidget& window) {
    QStringList shown;
    for (const QAction* action : window.findChildren<QAction*>()) shown << action->text() << action->toolTip();
    for (const QLabel* label : window.findChildren<QLabel*>()) shown << label->text() << label->toolTip();
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) shown << button->text() << button->toolTip();
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) shown << dock->windowTitle();
    return shown;
}

/// The same and all other texts: lists, tables, fields, names for screen readers, tools. One line per text.
QSet<QString> everyTextIn(const QWidget& window) {
    QSet<QString> shown;
    for (const QString& text : shownIn(window)) shown << text;
    for (const QComboBox* list : window.findChildren<QComboBox*>()) {
        for (int n = 0; n < list->count(); ++n) shown << list->itemText(n) << list->itemData(n, Qt::ToolTipRole).toString();
    }
    for (const QAbstractItemView* view : window.findChildren<QAbstractItemView*>()) {
        const QAbstractItemModel* model = view->model();
        if (model == nullptr) continue;
        for (int n = 0; n < model->columnCount(); ++n)
            shown << model->headerData(n, Qt::Horizontal).toString().replace('\n', ' ')
                  << model->headerData(n, Qt::Horizontal, Qt::ToolTipRole).toString();
        for (int row = 0; row < std::min(model->rowCount(), 5); ++row) {
            for (int n = 0; n < model->columnCount(); ++n) shown << model->index(row, n).data().toString();
        }
    }
    for (const QLineEdit* field : window.findChildren<QLineEdit*>()) shown << field->placeholderText();
    for (const QGroupBox* box : window.findChildren<QGroupBox*>()) shown << box->title();
    for (const QWidget* widget : window.findChildren<QWidget*>())
        shown << widget->toolTip() << widget->statusTip() << widget->accessibleName() << widget->windowTitle();
    QSet<QString> lines;
    for (const QString& text : shown) {
        for (const QString& line : text.split('\n')) lines << line.trimmed();
    }
    return lines;
}

/// With a scan, rocks, a target, a measurement, A/B, confidence and the scanner's panel on the screen.
bool laidOut(WindowFixture& on, const std::string& scan) {
    on.window.resize(1920, 1080);
    if (!on.showWith(scan)) return false;
    on.viewer.comparing.keep();
    on.viewer.rocks.setShown(true);
    on.viewer.confidence.setOn(true);
    on.viewer.views.pin(on.viewer.views.cellAt(20, 30));
    on.viewer.live.panel().show();
    edges::Settings other = on.viewer.engine.settings();
    other.sensitivity = 1.4;
    return on.use(other) && eventually([&] {
               return on.viewer.targets.settled() && on.viewer.rocks.picture() != nullptr && on.viewer.confidence.made() != nullptr &&
                      on.viewer.comparing.settled();
           });
}

} // namespace

class LanguagesTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    std::string scan_;

private slots:
    void initTestCase() {
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(files::saveScan(test::boxesScan(40, 60, 3, 0.05), scan_));
    }
    void cleanup() { useLanguage("en"); }

    // All texts of a report, with targets, rocks and a comparison; what an operator wrote stays.
    void theReportIsInTheLanguage() {
        sim::SimulationSettings settings;
        settings.lines = 150;
        settings.beams = 190;
        const auto before = std::make_shared<const Scan>(sim::simulate(settings)->scan);
        settings.afterBlast = true;
        settings.repeat = 1;
        const auto scan = std::make_shared<const Scan>(sim::simulate(settings)->scan);
        const auto detection = edges::detectEdges(scan, {}, edges::KeepFor::Rocks);
        const auto change = inspect::sceneChange({scan, detection->mask}, {before, edges::detectEdges(before, {})->mask});
        QVERIFY(bool(change));
        const std::uint32_t edge = detection->edges->front(), other = detection->edges->back();
        const rocks::Study study = rocks::studyRocks(rocks::rockInputs(*detection), {}, {{rocks::EditKind::NotRock, {edge}}});
        inspect::Notebook notebook;
        notebook.targets.push_back({1, "Rocks", edge, false, "2026-11-29T10:00:00Z", {}, {}, "none"});
        notebook.targets.back().asPinned = {
            {"Resolves", "31 mm"}, {"Surface", "26° ± 1° off the beam"}, {"Confidence", "90 % of 33 settings"}};
        notebook.measures.push_back({inspect::MeasureKind::Distance, {edge, other}, {}, {}, 1});
        exports::PageWords words;
        words.site = "File";
        words.remark = "Cells\nNumber";
        words.madeUtc = "2026-11-29T10:00:00Z";
        const std::string page = exports::scanPage(*detection, words, {&study, &notebook, &*change, "bell"});
        static const QRegularExpression texts(">([^<>]+)<|(?:data-name|alt|aria-label)=\"([^\"]+)\""), letters("[A-Za-z]{3}"),
            code("<(script|style|pre|code)[ >].*?</\\1>", QRegularExpression::DotMatchesEverythingOption);
        const auto nodesOf = [&](const std::string& html) {
            QStringList nodes;
            for (auto all = texts.globalMatch(QString::fromStdString(html).remove(code)); all.hasNext();) {
                const auto text = all.next();
                nodes << (text.captured(1) + text.captured(2)).trimmed();
            }
            return nodes;
        };
        const QStringList english = nodesOf(page);
        QVERIFY(english.size() > 100);
        QCOMPARE(reportInLanguage(page, "en"), page);
        const QStringList stay{"Rocks", "none", "File", "Cells", "Number", "EdgeScan+", "bell"};
        for (const Language& language : kLanguages) {
            if (language.code == std::string("en")) continue;
            QVERIFY(useLanguage(language.code, kTexts));
            const exports::PageNotes notes{&study, &notebook, &*change, "bell", inLanguage};
            const std::string translated = reportInLanguage(exports::scanPage(*detection, words, notes), language.code);
            const QStringList nodes = nodesOf(translated);
            QCOMPARE(nodes.size(), english.size());
            QStringList same;
            for (int n = 0; n < nodes.size(); ++n) {
                if (nodes[n] == english[n] && letters.match(nodes[n]).hasMatch()) same << nodes[n];
            }
            for (const QString& each : stay) QVERIFY2(same.contains(each) || each == "bell" || each == "EdgeScan+", qPrintable(each));
            // Words that are the same in both languages, names and hashes.
            Catalogue catalogue;
            QVERIFY(catalogue.read(kTexts + "/" + language.code + ".ts"));
            // The last is the same word in French.
            static const QRegularExpression name("UTC$|^auto: |^[0-9a-f]{64}$|^(EdgeScan|Scan) |^simulated$|^1 Rocks$|^M1 Distance$");
            QStringList left;
            for (const QString& each : same) {
                if (!stay.contains(each) && !catalogue.texts().contains(each) && !name.match(each).hasMatch()) left << each;
            }
            QVERIFY2(left.isEmpty(), qPrintable(left.join(" | ")));
            QVERIFY(translated.find("<html lang=\"" + std::string(language.code) + "\">") != std::string::npos);
        }
    }

    void everyTextHasItsTranslation_data() {
        QTest::addColumn<QString>("code");
        for (const Language& language : kLanguages) {
            if (language.code != std::string("en")) QTest::newRow(language.code) << QString(language.code);
        }
    }
    void everyTextHasItsTranslation() {
        QFETCH(QString, code);
        Catalogue catalogue;
        QVERIFY(catalogue.read(kTexts + "/" + code + ".ts"));
        QVERIFY2(catalogue.texts().size() > 600, "far fewer texts than the window has");
        static const QRegularExpression promise(
            R"(\b(sûre?s?|sécuris\w*|sécurité|certifi\w+|garant\w+|seguro?s?a?s?|segurança|seguridad|estable|stable|estáve(l|is))\b)",
            QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
        for (auto text = catalogue.texts().begin(); text != catalogue.texts().end(); ++text) {
            QCOMPARE(placeholdersOf(text.value()), placeholdersOf(text.key()));
            QVERIFY2(text.value().count('\n') == text.key().count('\n'), qPrintable(text.value()));
            QVERIFY2(mnemonicsIn(text.value()) == mnemonicsIn(text.key()), qPrintable(text.value()));
            QVERIFY2(!promise.match(text.value()).hasMatch(), qPrintable(text.value()));
        }
        // Checks the tables of the core directly: labels may be names that are the same in all languages, sentences may not.
        const auto expectSentence = [&](const std::string& text) {
            QVERIFY2(catalogue.texts().contains(QString::fromStdString(text)), text.c_str());
        };
        for (const edges::Parameter& parameter : edges::parameters()) expectSentence(parameter.help);
        for (const rocks::RockParameter& parameter : rocks::rockParameters()) expectSentence(parameter.help);
        for (const edges::Preset& preset : edges::builtInPresets()) expectSentence(preset.help);
        for (const files::WritingChoice& choice : files::kWritingChoices) expectSentence(choice.help);
    }

    void theFilesAreUpToDateWithTheSources() {
        const auto run = test::runProgram("../../../resources/languages/collect", "--check");
        QVERIFY2(run.code == 0, run.err.c_str()); // with the file and line of each sentence of the core without a translation
    }

    // Filled with values, a sentence of the core comes out as its own translation: no other pattern takes a part of it.
    void everySentenceOfTheCoreIsFound_data() { everyTextHasItsTranslation_data(); }
    void everySentenceOfTheCoreIsFound() {
        QFETCH(QString, code);
        QVERIFY(useLanguage(code, kTexts));
        const auto filled = [](QString text) {
            for (int n = 1; n <= 9; ++n) text.replace(QString("%%1").arg(n), QString("Value%1").arg(n));
            return text.replace("%n", "12");
        };
        // Text in front of the sentence and behind it is not part of a value.
        static const QRegularExpression first("^%[1-9n]"), last("%[1-9n]$");
        QStringList left;
        for (const QString& pattern : sentencesOfTheCore()) {
            const QString words = QObject::tr(pattern.toUtf8().constData()), shown = coreSentence(filled(pattern));
            const auto keeps = [&](const QRegularExpression& place) {
                return !place.match(pattern).hasMatch() || place.match(words).captured() == place.match(pattern).captured();
            };
            if (!keeps(first) || !keeps(last) || shown != coreSentence(filled(words))) left << pattern + " -> " + shown;
        }
        QVERIFY2(sentencesOfTheCore().size() > 1000, "far fewer sentences than the core has");
        QVERIFY2(left.isEmpty(), qPrintable(left.join('\n')));
    }

    void nothingButWordsChanges() {
        QVERIFY(useLanguage("en"));
        QSet<QString> englishKeys;
        QString englishProbe;
        {
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            englishKeys = keysOf(on.window);
        }
        QVERIFY(useLanguage("fr", kTexts));
        QCOMPARE(languageInUse(), QString("fr"));
        Catalogue catalogue;
        QVERIFY(catalogue.read(kTexts + "/fr.ts"));
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QCOMPARE(keysOf(on.window), englishKeys);
        QCOMPARE(QKeySequence("Shift+Del").toString(QKeySequence::NativeText), QString("Maj+Suppr"));
        QCOMPARE(on.window.menuBar()->actions().front()->text(), catalogue.texts().value("&File"));
        int words = 0;
        for (const QString& text : shownIn(on.window)) {
            const QString translated = catalogue.texts().value(text);
            QVERIFY2(translated.isEmpty() || translated == text, qPrintable("shown in English: " + text));
            words += catalogue.texts().values().contains(text) ? 1 : 0;
        }
        QVERIFY2(words > 150, "the window shows texts of its own");
        // Thousands are apart as no decimal mark is; numbers keep their decimal point.
        QCOMPARE(countText(1136154), QString::fromUtf8("1\u202f136\u202f154"));
        static const QRegularExpression comma("[0-9],[0-9]{3}");
        for (const QString& text : everyTextIn(on.window)) QVERIFY2(!comma.match(text).hasMatch(), qPrintable(text));
        auto* number = on.window.findChild<QDoubleSpinBox*>("number-sensitivity");
        QVERIFY(number != nullptr);
        QVERIFY2(number->text().startsWith("1.00"), qPrintable(number->text()));
    }

    void whySpeaksTheLanguageOfTheWindow_data() { everyTextHasItsTranslation_data(); }
    void whySpeaksTheLanguageOfTheWindow() {
        QFETCH(QString, code);
        QVERIFY(useLanguage(code, kTexts));
        static const QRegularExpression english(
            R"(\b(the|is|its|cell|cells|line|lines|strength|above|below|beam|chain|edge|fold|jump|here|with|from|range|gray)\b)",
            QRegularExpression::CaseInsensitiveOption);
        const auto inLanguage = [](const char* text) { return QObject::tr(text).toStdString(); };
        const auto scan = files::openScan(scan_);
        QVERIFY(bool(scan));
        for (const edges::Settings& settings : {edges::Settings{}, edges::cannySettings()}) {
            const auto detection = edges::detectEdges(std::make_shared<const Scan>(*scan), settings);
            for (std::size_t k = 0; k < scan->cells(); k += 7) {
                const edges::Why why = edges::whyCell(*detection, k);
                const QString text = QString::fromStdString(edges::whyVerdict(why, settings, edges::Naming::Labels, inLanguage) + "\n" +
                                                            edges::whyNumbers(why, settings, inLanguage));
                QVERIFY2(!english.match(text).hasMatch(), qPrintable(english.match(text).captured() + ": " + text));
            }
        }
    }

    void theKindsOfFilesToSaveAreNamedInTheLanguageOfTheWindow() {
        QVERIFY(useLanguage("fr", kTexts));
        QStringList names;
        for (const files::Format& format : files::formats()) names << filterOf(format, {".x"});
        QVERIFY2(names.contains("Dessin avec les lignes des arêtes (*.x)"), qPrintable(names.join('\n')));
    }

    // A text that is equal in two languages bypasses the translations, unless it is a name, or a sentence of the core about scans.
    void nothingIsLeftInEnglish_data() { everyTextHasItsTranslation_data(); }
    void nothingIsLeftInEnglish() {
        QFETCH(QString, code);
        QVERIFY(useLanguage("en"));
        QSet<QString> english;
        {
            WindowFixture on;
            QVERIFY(laidOut(on, scan_));
            english = everyTextIn(on.window);
        }
        QVERIFY(useLanguage(code, kTexts));
        Catalogue catalogue;
        QVERIFY(catalogue.read(kTexts + "/" + code + ".ts"));
        static const QRegularExpression keyOrCount(R"( +\([^)]*\)$)");
        QSet<QString> meantAlike; // lines of texts that are rightly the same in both languages
        for (auto text = catalogue.texts().begin(); text != catalogue.texts().end(); ++text) {
            const QString source = QString(text.key()).remove('&');
            if (source == QString(text.value()).remove('&')) meantAlike << source << QString(source).remove(keyOrCount);
        }
        WindowFixture on;
        QVERIFY(laidOut(on, scan_));
        static const QRegularExpression word("[A-Za-z]{3,}");
        static const QRegularExpression name(
            R"(^(Español|Français|Português|English|EdgeScan\+?|edgescan.*|boxes.*|llvmpipe.*|.*\(LLVM.*|qt_.*|Canny.*|Roberts|Sobel|Prewitt|Kirsch|Robinson|UTC|(A: )?boxes.*|[0-9,]+ points|.*\.json.*|.*\d+ ?mm.*)$)");
        QStringList left;
        for (const QString& text : everyTextIn(on.window)) {
            const bool alike = english.contains(text) && word.match(text).hasMatch();
            if (alike && !meantAlike.contains(QString(text).remove('&').remove(keyOrCount)) && !name.match(text).hasMatch()) left << text;
        }
        left.sort();
        QVERIFY2(left.isEmpty(), qPrintable("in English: " + left.join(" | ")));
    }

    // Errors that the window makes itself, without the core.
    void everyErrorOfTheWindowIsTranslated() {
        static const QRegularExpression error(R"(Error\{([^}]*)\})"), text("\"((?:[^\"\\\\\n]|\\\\.)*)\""), words("[a-z]{2,} [a-z]{2,}");
        int found = 0;
        for (const char* language : {"fr", "es", "pt"}) {
            QVERIFY(useLanguage(language, kTexts));
            for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(test::sourceFolder()) / "ui")) {
                if (entry.path().extension() != ".cpp") continue;
                const auto source = readWholeFile(entry.path());
                QVERIFY(bool(source));
                const QString code = QString::fromUtf8(textOf(*source).data(), static_cast<int>(source->size()));
                for (auto errors = error.globalMatch(code); errors.hasNext();) {
                    for (auto all = text.globalMatch(errors.next().captured(1)); all.hasNext();) {
                        const QString sentence = all.next().captured(1);
                        if (!words.match(sentence).hasMatch()) continue;
                        ++found;
                        const QString whole = sentence.endsWith('(') ? sentence + "x)" : sentence;
                        QVERIFY2(coreSentence(whole) != whole, qPrintable(whole));
                    }
                }
            }
        }
        QVERIFY(found > 30);
        useLanguage("en");
    }

    void theChoiceIsKeptAndUsedAtTheNextStart() {
        const QString ini = QString::fromStdString((folder_ / "memory.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(on.showWith(scan_));
            auto* spanish = on.window.findChild<QAction*>("language-es");
            QVERIFY(spanish != nullptr && !spanish->isChecked());
            QVERIFY(on.window.findChild<QAction*>("language-en")->isChecked());
            spanish->trigger();
            QVERIFY(on.viewer.notice.isVisible());
            QCOMPARE(on.preferences.text("language"), QString("es"));
            QVERIFY(!qApp->property(kStartsAgain).isValid());
            QToolButton* restart = nullptr;
            for (auto* each : on.viewer.notice.findChildren<QToolButton*>()) restart = each->text() == "Restart Now" ? each : restart;
            QVERIFY(restart != nullptr && restart->isVisible());
            QTest::mouseClick(restart, Qt::LeftButton);
            QVERIFY(!on.window.isVisible() && qApp->property(kStartsAgain).isValid());
            qApp->setProperty(kStartsAgain, {});
        }
        const Preferences preferences(ini);
        QVERIFY(useLanguage(preferences.text("language"), kTexts));
        WindowFixture on(ini);
        QVERIFY(on.show());
        QVERIFY(on.window.findChild<QAction*>("language-es")->isChecked());
    }

    // Files use one language; a target set in another language counts as unchanged.
    void whatIsKeptIsInTheWordsOfTheSources() {
        const QString ini = QString::fromStdString((folder_ / "kept" / "memory.ini").string());
        QDir().mkpath(QString::fromStdString((folder_ / "kept").string()));
        QVERIFY(useLanguage("fr", kTexts));
        {
            WindowFixture on(ini);
            QVERIFY(on.showWith(scan_));
            on.viewer.views.pin(on.viewer.views.cellAt(20, 30));
            QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
            const auto& kept = on.viewer.targets.notebook().targets.front().asPinned;
            QVERIFY(kept.size() > 3);
            QCOMPARE(kept.front().first, std::string("Distance"));
            QVERIFY(std::ranges::any_of(kept, [](const auto& row) { return row.first == "Resolves"; }));
            // The audit log uses the language of the sources too; the menu uses the window's language.
            on.viewer.markedEdges.mark(on.viewer.views.cellAt(20, 30), true);
            const QUndoStack& undo = on.viewer.undo;
            QCOMPARE(undo.text(undo.index() - 1), QString("Mark as an Edge"));
            QCOMPARE(undo.undoText(), QString("Marque d’arête"));
            on.viewer.tuning.setParameter("classes", edges::kClassConvex);
            QVERIFY(undo.text(undo.index() - 1) != undo.undoText());
        }
        QVERIFY(useLanguage("es", kTexts));
        WindowFixture on(ini);
        QVERIFY(on.showWith(scan_));
        QVERIFY(eventually([&] { return on.viewer.targets.settled() && !on.viewer.targets.notebook().targets.empty(); }));
        on.viewer.views.pin(on.viewer.views.cellAt(20, 30));
        QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
        const QString card = on.viewer.targetsPanel.card().text();
        QVERIFY2(!card.contains("antes:"), qPrintable(card));
    }

    void theSystemChoosesAmongThoseSpoken() {
        QCOMPARE(languageOfSystem({"de-DE", "fr-CA", "en-US"}), QString("fr"));
        QCOMPARE(languageOfSystem({"pt_BR"}), QString("pt"));
        QCOMPARE(languageOfSystem({"C"}), QString("en"));
        QCOMPARE(languageOfSystem({}), QString("en"));
        QVERIFY(!useLanguage("de", kTexts));
        QCOMPARE(languageInUse(), QString("en"));
        QVERIFY(!useLanguage("fr", QString::fromStdString(folder_.path().string())));
        QCOMPARE(languageInUse(), QString("en"));
    }

    void aDamagedFileSaysNothing() {
        const QString path = QString::fromStdString((folder_ / "fr.ts").string());
        QFile whole(kTexts + "/fr.ts");
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray bytes = whole.readAll();
        for (const int length : {0, 10, static_cast<int>(bytes.size()) / 2}) {
            QFile cut(path);
            QVERIFY(cut.open(QIODevice::WriteOnly));
            cut.write(bytes.left(length));
            cut.close();
            Catalogue catalogue;
            QVERIFY(!catalogue.read(path));
        }
    }

    // Whatever a live scanner is: every word of the strip has a translation that is used.
    void theStripSpeaksTheLanguageOfTheWindow() {
        files::LiveStatus status;
        status.connection.sentence = "10.0.0.5:2112: no scan for 3.0 s.";
        status.lines = 312;
        status.linesPerSecond = 25;
        status.sweep.expected = 1000;
        status.sweep.cells[static_cast<std::size_t>(CellState::Valid)] = 958;
        QSet<QString> same;
        int seen = 0;
        for (const char* language : {"fr", "es", "pt"}) {
            QVERIFY(useLanguage(language, kTexts));
            for (const auto phase : {scanner::ConnectionPhase::Connecting, scanner::ConnectionPhase::Live, scanner::ConnectionPhase::Lost,
                                     scanner::ConnectionPhase::Stopped}) {
                for (const double age : {0.0, 5.0, 300.0}) {
                    for (const int part : {0, 1, 2, 3, 4, 5}) {
                        files::LiveStatus now = status;
                        now.connection.phase = phase;
                        now.secondsSinceLine = age;
                        now.sweep.lines = part == 1 ? 1000 : 312;
                        now.sweep.received = part == 2 ? 309 : now.sweep.lines;
                        if (part == 2) now.sweep.lost = {5, 9, 10};
                        now.sweep.growing = part != 1;
                        now.sweep.device.contaminationWarning = part == 3;
                        now.sweep.deviceEver.contaminationError = part == 4;
                        now.sweep.device.error = part == 3;
                        now.sweep.deviceEver.error = part == 4;
                        if (part == 5) now.sweep.assumed = "How a motor turned the scanner was not said in full. ASSUMED: the axis (spin).";
                        if (part == 4) now.recording = files::RecordingState{};
                        const files::LiveHealth health = files::healthOf(now);
                        for (const std::string& each :
                             {health.badge, health.lines, health.lost, health.noReturn, health.remark, health.contamination,
                              health.deviceState, health.pose, health.end, health.recording}) {
                            if (each.empty()) continue;
                            ++seen;
                            if (coreWords(each) == QString::fromStdString(each)) same << QString(language) + ": " + each.c_str();
                        }
                    }
                }
            }
            QVERIFY(coreSentence(status.connection.sentence) != QString::fromStdString(status.connection.sentence));
        }
        QVERIFY(seen > 500);
        QVERIFY2(same.isEmpty(), qPrintable(QStringList(same.values()).join('\n')));
        useLanguage("en");
        const char* assumed =
            "How a motor turned the scanner was not said in full. ASSUMED: the axis (spin), the step from line to line (0.18 degrees, the "
            "motor turning on while a line is measured). Give --axis, --line-step where that is wrong. The first line "
            "received is taken as line 0 of the sweep.";
        for (const char* language : {"fr", "es", "pt"}) {
            QVERIFY(useLanguage(language, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            for (const char* english : {"the ", "Give", "where", "received", "degrees", "--"})
                QVERIFY2(!QRegularExpression(QString("\\b%1").arg(english)).match(coreSentence(std::string(assumed))).hasMatch(),
                         qPrintable(coreSentence(std::string(assumed))));
            QVERIFY(!scanName("sweep 12").contains("sweep") && scanName("sweep 12").endsWith(" 12"));
            QCOMPARE(scanName("north_sweep 12"), QString("north_sweep 12"));
        }
        useLanguage("en");
        QCOMPARE(coreWords("LOST 12 s"), QString("LOST 12 s"));
    }

    // What opening, saving and connecting refuse: both the fault and its remedy are in the language of the window.
    void refusalsAreInTheLanguageOfTheWindow() {
        const auto in = [&](const char* name) { return folder_ / name; };
        QVERIFY(bool(writeWholeFile(in("page.json"), "<!doctype html><html></html>")));
        QVERIFY(bool(writeWholeFile(in("photo.png"), "\xff\xd8\xff\xe0 a picture")));
        std::vector<Error> refused;
        for (const auto& path : {in("absent.json"), std::filesystem::path(folder_ / ""), in("page.json"), in("photo.png")}) {
            const auto opened = files::openScan(path);
            QVERIFY2(!opened, path.c_str());
            refused.push_back(opened.error());
        }
        const auto notWritten = writeWholeFile(in("absent") / "scan.json", "");
        QVERIFY(!notWritten);
        refused.push_back(notWritten.error());
        scanner::ColaLink link({});
        for (const char* host : {"127.0.0.1", ""}) {
            const auto connected = link.connect(host, 1, std::chrono::seconds(5)); // a port on which no program listens
            QVERIFY(!connected);
            refused.push_back(connected.error());
        }
        for (const char* language : {"fr", "es", "pt"}) {
            QVERIFY(useLanguage(language, kTexts));
            for (const Error& each : refused) {
                const QString shown = coreSentence(each.sentence());
                QVERIFY2(!shown.contains(QString::fromStdString(each.what)), qPrintable(shown));
                QVERIFY2(each.hint.empty() || !shown.contains(QString::fromStdString(each.hint)), qPrintable(shown));
            }
        }
        useLanguage("en");
    }

    // Errors, warnings and remarks of the core name flags for the command line; in the window they name places of the window.
    // Ctrl+E: the dialog of the export, then Qt's own for the file, which not every system has translations for.
    void theDialogsOfAnExportSpeakTheLanguageOfTheWindow_data() { everyTextHasItsTranslation_data(); }
    void theDialogsOfAnExportSpeakTheLanguageOfTheWindow() {
        QFETCH(QString, code);
        const auto texts = [&](const QString& language) {
            useLanguage(language, kTexts);
            WindowFixture on;
            if (!on.showWith(scan_)) qFatal("the scan was not shown");
            const ExportDialog dialog(on.picture().detection, exports::ExportContent::EdgeCloud, {}, &on.window);
            const QFileDialog place(&on.window, QString(), QString::fromStdString(folder_.path().string()));
            return everyTextIn(dialog) + everyTextIn(place);
        };
        const QSet<QString> english = texts("en"), here = texts(code);
        static const QRegularExpression word("[A-Za-z]{4,}"), name("^(/.*|.*[.]json.*|qt_.*|root|Export|Format|Type|Image.*)$");
        QStringList left;
        for (const QString& text : here) {
            if (english.contains(text) && word.match(text).hasMatch() && !name.match(text).hasMatch()) left << text;
        }
        left.sort();
        QVERIFY2(left.isEmpty(), qPrintable("in English: " + left.join(" | ")));
    }

    // The smallest screen of a cab is 853 px wide.
    void theFieldsOfASweepFitTheSmallestCab_data() { everyTextHasItsTranslation_data(); }
    void theFieldsOfASweepFitTheSmallestCab() {
        QFETCH(QString, code);
        for (const QString& language : {code, QString("en")}) {
            useLanguage(language, kTexts);
            WindowFixture on;
            QVERIFY(on.show());
            on.window.cab().set(true);
            on.viewer.livePanel.askSweep();
            auto* fields = on.window.findChild<QDialog*>("sweep-dialog");
            QTRY_VERIFY(fields != nullptr && fields->isVisible());
            const int width = fields->minimumSizeHint().width();
            QVERIFY2(width <= 853, qPrintable(QString("%1: %2 px").arg(language).arg(width)));
            fields->close();
        }
    }

    void whatIsSaidOfAPoseAndOfTwoScansIsTranslated() {
        QVERIFY(useLanguage("fr", kTexts));
        for (const char* sentence : {"OUT OF SPEC: the pose is 812 s older than the start of the scan.",
                                     "OUT OF SPEC: without a pose of both, the two scans are lined up by their surfaces alone.",
                                     "OUT OF SPEC: 3 of 90 lines were measured before the first or after the last pose and were given the "
                                     "nearest one.",
                                     "The pose carries no time, so its age is not known."})
            QVERIFY2(coreSentence(QString(sentence)) != sentence, sentence);
        QVERIFY(coreSentence(QString("OUT OF SPEC: the tilt of the head changed by 0.9 degrees while it scanned, more than 0.5."))
                    .endsWith("0.5."));
        inspect::RegistrationResult how;
        how.by = inspect::RegistrationBasis::Surfaces;
        const std::string by = inspect::registrationText(how);
        QVERIFY2(coreWords(by) != QString::fromStdString(by), by.c_str());
        QVERIFY(by.find("no pose") == 0);
        how.by = inspect::RegistrationBasis::Poses;
        QVERIFY2(inspect::registrationText(how).find("pose") == std::string::npos, "of the demo, which has no pose");
        how.inMine = true;
        QCOMPARE(inspect::registrationText(how), std::string("lined up by their poses"));
    }

    // What opening a file says is in the sources of the core; the longest text of each call must be part of a pattern that is translated.
    void everyNoteOfTheCoreHasAPattern() {
        Catalogue catalogue;
        QVERIFY(catalogue.read(kTexts + "/fr.ts"));
        const QString patterns = QStringList(catalogue.texts().keys()).join('\n');
        // verify.cpp speaks to the command line only.
        const QStringList elsewhere{"when it was written.", "Every pixel is the same; the bytes are packed by another zlib."};
        static const QRegularExpression call(
            R"(\b(?:(?:warnings_?|remarks_?|said)(?:\.|->)(?:push_back|emplace_back|insert)|warn|warnOfCount|tell)\()");
        // moc knows no raw strings with quotes
        static const QRegularExpression part("\"((?:[^\"\\\\\\n]|\\\\.)*)\"|[()]"), joint("\"\\s*\\n\\s*\"");
        static const QRegularExpression flag(R"(--[a-z][a-z-]*(?: [A-Z][A-Z,.a-z]*)?(?: \([^)]* > [^)]*\))?)");
        constexpr int kShortest = 20; // letters; shorter ones are parts of sentences that say little
        int calls = 0;
        QStringList left;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(test::sourceFolder()) / "core")) {
            if (entry.path().extension() != ".cpp") continue;
            const auto file = readWholeFile(entry.path());
            QVERIFY(bool(file));
            const QString source = QString::fromUtf8(textOf(*file).data(), static_cast<int>(file->size())).remove(joint);
            for (auto all = call.globalMatch(source); all.hasNext();) {
                QString longest;
                int depth = 1;
                for (auto parts = part.globalMatch(source, all.next().capturedEnd()); depth > 0 && parts.hasNext();) {
                    const auto found = parts.next();
                    depth += found.captured() == "(" ? 1 : found.captured() == ")" ? -1 : 0;
                    for (const QString& piece : found.captured(1).replace("\\\"", "\"").split(flag)) {
                        if (piece.trimmed().size() > longest.size()) longest = piece.trimmed();
                    }
                }
                if (longest.size() < kShortest || elsewhere.contains(longest)) continue;
                ++calls;
                if (!patterns.contains(longest)) left << QString::fromStdString(entry.path().filename().string()) + ": " + longest;
            }
        }
        QVERIFY2(calls > 150, "far fewer notes than the core has");
        QVERIFY2(left.isEmpty(), qPrintable("without a pattern in ui/base/core_words.cpp:\n" + left.join('\n')));
    }

    // The core says them in parts; none may stay in English.
    void notesAreWhollyInTheLanguageOfTheWindow_data() { everyTextHasItsTranslation_data(); }
    void notesAreWhollyInTheLanguageOfTheWindow() {
        QFETCH(QString, code);
        QVERIFY(useLanguage(code, kTexts));
        static const QRegularExpression english(R"(\b(the|is|its|it|was|were|from|and|gives|chooses|ranges|about|degrees)\b)");
        for (const char* note :
             {"Unit taken as metres, from the size of the numbers.",
              "The file's coordinates are left-handed and were turned right-handed: y is mirrored.",
              "The points lie on no scanner grid and were projected about the origin, because no sensor position is known (--sensor X,Y,Z "
              "gives it): 1200 points in, seen over 90 x 45 degrees; 1100 of 200 x 30 cells filled (fill ratio 70.1 %; of the cells around "
              "a filled one 88 %), 3 points attached to a cell with a nearer one.",
              "The file holds 4 scans; this is number 2, --scan chooses another.",
              "12 points are marked as invalid in the file and count as no return. 3 infinite ranges were taken as no return.",
              "--grid-step has no effect: the points have a grid; leave it out.", "this is a FARO scan (FLS), which is not read",
              "give --sensor X,Y,Z, the place in metres that the scan was taken from",
              "bell.las: the header promises 12 points of 20 bytes and the file holds 100 bytes of them; copy the file again.",
              "bell.csv:line 3: holds 2 numbers where a point needs three; choose a point list or a table of ranges.",
              "bell.ptx: scan 2 of this PTX file promises 10 columns of 12 points, and the file ends before them; copy the file again.",
              "bell.e57: scan 3 of this E57 file holds no points; choose another scan or file.",
              "bell.mcap: --scan 4: the recording holds 3 sweeps; use --scan 0 to 2.",
              "bell.bag: no message of the topic /scan is a line of ranges: it has no beams or no stamp; choose another topic."}) {
            const QString shown = coreSentence(QString(note));
            QVERIFY2(!english.match(shown).hasMatch(), qPrintable(english.match(shown).captured() + ": " + shown));
        }
        const files::Sentence angle{"from %1", {"the transform of the frame laser in base"}};
        QVERIFY2(!shownSentence(angle).contains("transform of"), qPrintable(shownSentence(angle)));
        QVERIFY(!coreSentence(QString("Telegrams were lost: lines 1 to 996, 998 to 1993 (1992 in all).")).contains(" to "));
        const QString twice = coreSentence(QString("the file is empty\nthe file is empty"));
        QVERIFY2(!twice.contains("empty"), qPrintable(twice));
        useLanguage("en");
        QCOMPARE(coreSentence(QString("12 points have a return")), QString("12 points have a return"));
    }

    void noNoteOfTheWindowNamesAFlag() {
        static const QRegularExpression text("\"(?:[^\"\\\\\n]|\\\\.)*\"");
        int flags = 0;
        QStringList left;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(test::sourceFolder()) / "core")) {
            if (entry.path().extension() != ".cpp") continue;
            const auto source = readWholeFile(entry.path());
            QVERIFY(bool(source));
            for (auto all = text.globalMatch(QString::fromUtf8(textOf(*source).data(), static_cast<int>(source->size()))); all.hasNext();) {
                const QString found = all.next().captured();
                if (!found.contains(QRegularExpression("--[a-z]"))) continue;
                ++flags;
                if (coreSentence(found).contains(QRegularExpression("--[a-z]"))) left << found + " -> " + coreSentence(found);
            }
        }
        const auto texts = readWholeFile(std::filesystem::path(test::sourceFolder()) / "resources/languages/fr.ts");
        QVERIFY(bool(texts)); // the window's own texts
        const QRegularExpression named("<source>[^<]*--[a-z][^<]*</source>");
        const QString whole = QString::fromUtf8(textOf(*texts).data(), static_cast<int>(texts->size()));
        QCOMPARE(named.match(whole.section("<name>core</name>", 0, 0)).captured(), QString());
        QVERIFY(flags > 40);
        QVERIFY2(left.isEmpty(), qPrintable(left.join('\n')));
        QCOMPARE(coreSentence(QString("combed: --straighten (Scan > Straighten Beams) puts them side by side.")),
                 QString("combed: Scan > Straighten Beams puts them side by side."));
        QCOMPARE(coreSentence(QString("give --beam-start --beam-step --line-start --line-step --axis, or name the columns x, y and z")),
                 QString("give the angles of beams and lines and the axis in Scan > How the Scan Is Read, or name the columns x, y and z"));
        QVERIFY(coreSentence(QString("give --unit m")).contains("How the Scan Is Read"));
        QCOMPARE(coreSentence(QString("--unit cm replaces mm, which the file gives.")),
                 QString("“unit: cm” in Scan > How the Scan Is Read replaces mm, which the file gives."));
        QCOMPARE(
            coreSentence(QString("--scan 3: the file holds one scan; use --scan 0")),
            QString("“scan: 3” in Scan > How the Scan Is Read: the file holds one scan; use “scan: 0” in Scan > How the Scan Is Read"));
        QVERIFY(coreSentence(QString("--unit has no effect")).contains("Read has no effect"));
        QVERIFY(coreSentence(QString("no return (--keep-repeated takes it as measured)")).contains("Scan > Keep Repeated Values"));
    }

    // No line ends before the colon, and one target is not several.
    void frenchSpacesAndSingularsAreRight() {
        QVERIFY(useLanguage("fr", QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        QCOMPARE(QObject::tr("On the screen: %1"), QString("À l'écran") + QChar(0x00A0) + ": %1");
        QCOMPARE(targetCount(1), QString("1 cible"));
        QCOMPARE(targetCount(2), QString("2 cibles"));
        useLanguage("en");
    }
};

int languages_test(int argc, char** argv) { return runWindowTest<LanguagesTest>(argc, argv); }
#include "languages_test.moc"
