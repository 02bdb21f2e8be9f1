// Writes the report of the scan on the screen.
#include "ui/controllers/scan_report.h"

#include "core/base/inputs.h"
#include "core/base/shell_quoted.h"
#include "core/base/stop.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/edges/settings/command_text.h"
#include "core/exports/html/scan_page.h"
#include "ui/base/core_words.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/report_pdf.h"
#include "ui/controllers/report_words.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/worker_bridge/in_background.h"
#include "ui/engine/worker_bridge/preferences.h"

#include <QDir>
#include <QFileInfo>

#include <atomic>
#include <memory>

namespace edgescan::ui {
namespace {

const QString kPdf = QStringLiteral(".pdf");

bool isPdf(const QString& path) { return path.endsWith(kPdf, Qt::CaseInsensitive); }

std::string bytesOf(const QByteArray& bytes) { return {bytes.constData(), static_cast<std::size_t>(bytes.size())}; }

} // namespace

ScanReport::ScanReport(Engine& engine, const Files& files, Rocks& rocks, const Targets& targets, const Comparing& comparing,
                       NoticeBar& notice, Preferences& preferences)
    : engine_(engine), files_(files), rocks_(rocks), targets_(targets), comparing_(comparing), notice_(notice), preferences_(preferences) {}

void ScanReport::ask() {
    if (!engine_.picture()) {
        notice_.showHint(tr("There is nothing to report yet: open a scan first."));
        return;
    }
    emit asked();
    ReportWords words;
    words.site = preferences_.text("report/site");
    words.author = preferences_.text("report/author");
    words.logo = preferences_.text("report/logo");
    words.extension = preferences_.text("report/extension", ".html");
    words.rocks = rocks_.shown() || !rocks_.edits().empty();
    if (engine_.picture()->source.stream == remarkStream_) { // of the same scan, as in the report before
        words.remark = remark_;
        words.rocks = words.rocks || rocksInReport_;
    }
    ReportForm form(words, notice_.window());
    if (form.exec() != QDialog::Accepted) return;
    words = form.words();
    const bool shown = rocks_.shown();
    if (words.rocks) rocks_.setShown(true); // they are computed while the operator chooses the file
    preferences_.keep("report/site", words.site);
    preferences_.keep("report/author", words.author);
    preferences_.keep("report/logo", words.logo);
    preferences_.keep("report/extension", words.extension);
    remark_ = words.remark;
    rocksInReport_ = words.rocks;
    remarkStream_ = engine_.picture()->source.stream;
    SaveQuestion question;
    question.title = tr("Report");
    question.extension = words.extension;
    const QString name = shownName(exactText(engine_.picture()->detection->scan->name), 80).replace(' ', '-').replace('/', '-');
    question.place = QDir(preferences_.folder("exports")).filePath(name + "_report" + words.extension);
    question.filters << tr("Page for any browser (*.html)") << tr("PDF (*.pdf)");
    const QString path = askWhereToSave(notice_.window(), question);
    if (path.isEmpty()) return rocks_.setShown(shown);
    writeTo(path, words, shown);
}

std::string ScanReport::commandFor(const edges::Detection& detection, const QString& path, const ReportWords& words) const {
    const Scan& scan = *detection.scan;
    if (scan.path.empty()) return "the scan came from a scanner and has no file yet: record it, and report the recording";
    const QString page = isPdf(path) ? path.chopped(kPdf.size()) + ".html" : path; // the program writes pages only
    std::string command = "edgescan-cli report " + shellQuoted(fileName(scan.path)) + " -o " + shellQuoted(fileName(exactBytes(page)));
    const auto add = [&command](const char* flag, const QString& text) {
        if (!text.isEmpty()) command += std::string(" ") + flag + " " + shellQuoted(exactBytes(text));
    };
    add("--operator", words.author);
    add("--site", words.site);
    add("--remark", words.remark);
    add("--logo", QFileInfo(words.logo).fileName());
    const std::string reading = readingFlags(exports::withNames(files_.options()));
    command += (reading.empty() ? "" : " " + reading) + " " + edges::settingsFlags(detection.settings);
    std::string missing; // a remark in shell syntax
    if (!targets_.notebook().empty()) {
        const QString kept = targets_.notebookFile();
        if (kept.isEmpty())
            missing = " # without what was pinned and measured: no file keeps it";
        else
            command += " --targets " + shellQuoted(fileName(exactBytes(kept)));
    }
    if (const auto& compared = comparing_.comparison(); compared && compared->isOfTwoScans()) {
        const std::string& before = compared->asked.before->detection->scan->path;
        if (!before.empty()) command += " --before " + shellQuoted(fileName(before));
    }
    if (!rocks_.shown() || !words.rocks) return command + missing;
    command += " --rocks";
    if (!rocks_.editsFile().empty()) return command + " --edits " + shellQuoted(fileName(rocks_.editsFile())) + missing;
    const std::string flags = rocks::rockSettingsFlags(rocks_.settings());
    return (flags.empty() ? command : command + " " + flags) + missing;
}

void ScanReport::writeTo(const QString& path, const ReportWords& words, bool rocksStay) {
    if (!engine_.picture()) return;
    if (words.rocks && rocks_.behind()) return rocks_.whenKnown(path, [=, this] { writeTo(path, words, rocksStay); });
    const std::shared_ptr<const RockPicture> rocks = words.rocks ? rocks_.picture() : nullptr;
    const std::shared_ptr<const edges::Detection> detection = rocks ? rocks->detection : engine_.picture()->detection;
    std::shared_ptr<const Comparison> compared = comparing_.comparison();
    if (compared && compared->asked.now != engine_.picture()) compared = nullptr; // of the previous picture
    exports::PageWords said{commandFor(*detection, path, words),
                            exactBytes(words.author),
                            {},
                            utcText(utcNow()),
                            exactBytes(words.site),
                            exactBytes(words.remark),
                            {}};
    if (!words.logo.isEmpty()) {
        const auto bytes = readInput(exactBytes(words.logo));
        const auto logo = bytes ? exports::logoFrom(textOf(*bytes), exactBytes(words.logo)) : Result<std::string>(bytes.error());
        if (!logo) return notice_.showError(logo.error());
        said.logoPng = *logo;
    }
    if (!rocksStay) rocks_.setShown(false);
    preferences_.keepFolder("exports", path);
    ++working_;
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    const std::shared_ptr<Works::Running> work =
        engine_.works().start(tr("Making the report %1").arg(QFileInfo(path).fileName()), [stop] { *stop = true; });
    inBackground(
        this,
        [this, detection, rocks, said, path, notebook = targets_.notebook(), compared, stop]() -> std::function<void()> {
            const BindStop bound(*stop);
            exports::PageNotes notes{rocks ? &rocks->study : nullptr, &notebook, nullptr, {}, inLanguage};
            if (compared) {
                const edges::Detection& before = *compared->asked.before->detection;
                notes.change = &compared->change;
                notes.earlier = compared->isOfTwoScans() ? before.scan->name : "this scan by other settings";
            }
            const std::string page = reportInLanguage(exports::scanPage(*detection, said, notes), exactBytes(languageInUse()));
            const auto written =
                isPdf(path) ? writeWholeFile(exactBytes(path), bytesOf(pdfOfPage(page))) : writeWholeFile(exactBytes(path), page);
            return [this, written, path] {
                if (!written) return notice_.showError(written.error());
                notice_.showSaved(path, isPdf(path) ? tr("pages to print") : tr("a page for any browser"));
                emit saved(path);
            };
        },
        [this](const QString& what) { notice_.showNotice(NoticeBar::Kind::Error, tr("The report could not be made (%1).").arg(what)); },
        [this, running = std::make_shared<std::shared_ptr<Works::Running>>(work)] {
            running->reset();
            --working_;
            emit ended();
        });
}

} // namespace edgescan::ui

#include "moc_scan_report.cpp"
