// Dialogs that only show information.
#include "ui/panels/dialogs/sheets.h"

#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/exports/report.h"
#include "core/scan/grid/scan.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"

#include <nlohmann/json.hpp>

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

namespace edgescan::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostListed = 12; // values of a list

/// Names of the report in words; the others are shown with blanks between their words.
constexpr std::pair<const char*, const char*> kNames[] = {
    {"input", QT_TRANSLATE_NOOP("QObject", "File")},
    {"name", QT_TRANSLATE_NOOP("QObject", "Name")},
    {"format", QT_TRANSLATE_NOOP("QObject", "Format")},
    {"sha256", QT_TRANSLATE_NOOP("QObject", "SHA-256")},
    {"lines", QT_TRANSLATE_NOOP("QObject", "Scan lines")},
    {"beams", QT_TRANSLATE_NOOP("QObject", "Beams")},
    {"cells", QT_TRANSLATE_NOOP("QObject", "Cells")},
    {"valid", QT_TRANSLATE_NOOP("QObject", "with a range")},
    {"no_return", QT_TRANSLATE_NOOP("QObject", "no return")},
    {"status", QT_TRANSLATE_NOOP("QObject", "device status")},
    {"out_of_window", QT_TRANSLATE_NOOP("QObject", "out of window")},
    {"masked", QT_TRANSLATE_NOOP("QObject", "masked")},
    {"lost", QT_TRANSLATE_NOOP("QObject", "lost")},
    {"range_mm", QT_TRANSLATE_NOOP("QObject", "Ranges [m]")},
    {"min", QT_TRANSLATE_NOOP("QObject", "smallest")},
    {"max", QT_TRANSLATE_NOOP("QObject", "largest")},
    {"unit_mm", QT_TRANSLATE_NOOP("QObject", "Unit of the file [mm]")},
    {"frame", QT_TRANSLATE_NOOP("QObject", "Frame")},
    {"pose", QT_TRANSLATE_NOOP("QObject", "Pose")},
    {"warnings", QT_TRANSLATE_NOOP("QObject", "Warnings")},
    {"geometry", QT_TRANSLATE_NOOP("QObject", "Geometry")},
    {"axis", QT_TRANSLATE_NOOP("QObject", "Mounting of the stepper")},
    {"beam_deg", QT_TRANSLATE_NOOP("QObject", "Beam angles [°]")},
    {"line_deg", QT_TRANSLATE_NOOP("QObject", "Line angles [°]")},
    {"intensity", QT_TRANSLATE_NOOP("QObject", "Intensity")},
    {"acquisition", QT_TRANSLATE_NOOP("QObject", "Measured")},
    {"vendor", QT_TRANSLATE_NOOP("QObject", "Maker")},
    {"model", QT_TRANSLATE_NOOP("QObject", "Model")},
    {"serial", QT_TRANSLATE_NOOP("QObject", "Serial number")},
    {"firmware", QT_TRANSLATE_NOOP("QObject", "Firmware")},
    {"start_utc", QT_TRANSLATE_NOOP("QObject", "Begin (UTC)")},
    {"end_utc", QT_TRANSLATE_NOOP("QObject", "End (UTC)")},
    {"clock_source", QT_TRANSLATE_NOOP("QObject", "Clock")},
    {"contamination", QT_TRANSLATE_NOOP("QObject", "Window of the scanner")},
    {"echo_filter", QT_TRANSLATE_NOOP("QObject", "Echo filter")},
    {"lines_expected", QT_TRANSLATE_NOOP("QObject", "Lines of the sweep")},
    {"first", QT_TRANSLATE_NOOP("QObject", "first")},
    {"last", QT_TRANSLATE_NOOP("QObject", "last")},
    {"count", QT_TRANSLATE_NOOP("QObject", "number")},
    {"step", QT_TRANSLATE_NOOP("QObject", "step")},
    {"uneven", QT_TRANSLATE_NOOP("QObject", "uneven")},
    {"line_direction", QT_TRANSLATE_NOOP("QObject", "Direction of the stepper")},
    {"attached_points", QT_TRANSLATE_NOOP("QObject", "Points behind others")},
    {"points", QT_TRANSLATE_NOOP("QObject", "Points of the list")},
    {"in_file", QT_TRANSLATE_NOOP("QObject", "in the file")},
    {"without_cell", QT_TRANSLATE_NOOP("QObject", "without a cell")},
    {"note", QT_TRANSLATE_NOOP("QObject", "Remark")},
    {"sensor_m", QT_TRANSLATE_NOOP("QObject", "Scanner at [m]")},
    {"origin_enh_m", QT_TRANSLATE_NOOP("QObject", "Origin E, N, RL [m]")},
    {"grid_scale", QT_TRANSLATE_NOOP("QObject", "Scale of the grid")},
    {"grid", QT_TRANSLATE_NOOP("QObject", "Grid")},
    {"source", QT_TRANSLATE_NOOP("QObject", "Source")},
    {"robot", QT_TRANSLATE_NOOP("QObject", "Robot")},
    {"scan_start", QT_TRANSLATE_NOOP("QObject", "Begin of the scan")},
    {"scan_end", QT_TRANSLATE_NOOP("QObject", "End of the scan")},
    {"time", QT_TRANSLATE_NOOP("QObject", "Time of the pose")},
    {"age_s", QT_TRANSLATE_NOOP("QObject", "Age of the pose [s]")},
    {"out_of_spec", QT_TRANSLATE_NOOP("QObject", "Out of spec")},
    {"poses", QT_TRANSLATE_NOOP("QObject", "Poses")},
    {"boom", QT_TRANSLATE_NOOP("QObject", "Boom")},
    {"pivot_m", QT_TRANSLATE_NOOP("QObject", "Pivot [m]")},
    {"head_m", QT_TRANSLATE_NOOP("QObject", "Head [m]")},
};

/// Values that are words of EdgeScan, not names of a file.
constexpr const char* kWordValues[] = {
    QT_TRANSLATE_NOOP("QObject", "mine grid"),
    QT_TRANSLATE_NOOP("QObject", "scanner"),
    QT_TRANSLATE_NOOP("QObject", "beam x line angles"),
    QT_TRANSLATE_NOOP("QObject", "organised points"),
    QT_TRANSLATE_NOOP("QObject", "spin"),
    QT_TRANSLATE_NOOP("QObject", "sweep"),
};
constexpr std::string_view kKeysOfWords[] = {"frame", "geometry", "axis"};

QString nameOf(const std::string& key) {
    const auto known = std::ranges::find_if(kNames, [&](const auto& each) { return key == each.first; });
    if (known != std::end(kNames)) return QObject::tr(known->second);
    return shownText(key).replace('_', ' ');
}

QString valueOf(const Json& value) {
    if (value.is_null()) return QStringLiteral("–");
    if (value.is_number_integer()) return countText(value.get<std::int64_t>());
    if (value.is_boolean()) return value.get<bool>() ? QObject::tr("yes") : QObject::tr("no");
    if (value.is_string()) return value.get<std::string>().empty() ? QStringLiteral("–") : shownText(value.get<std::string>());
    return shownText(jsonText(value));
}

/// The words of EdgeScan in the language of the window.
QString valueOf(const std::string& key, const Json& value) {
    const bool known = value.is_string() && std::ranges::count(kKeysOfWords, key) > 0 &&
                       std::ranges::any_of(kWordValues, [&](const char* word) { return value.get<std::string>() == word; });
    return known ? QObject::tr(value.get<std::string>().c_str()) : valueOf(value);
}

/// A list: short values in one line, sentences below each other.
QString listOf(const Json& list) {
    if (list.empty()) return QStringLiteral("–");
    QStringList values;
    for (std::size_t n = 0; n < std::min(list.size(), kMostListed); ++n)
        values << (list[n].is_structured() ? QStringLiteral("…") : valueOf(list[n]).toHtmlEscaped());
    if (list.size() > kMostListed) values << QObject::tr("and %1 more").arg(list.size() - kMostListed);
    return values.join(list.front().is_string() ? "<br>" : ", ");
}

void addRows(QString& rows, const Json& facts, int depth) {
    for (const auto& [key, value] : facts.items()) {
        const QString blanks = QStringLiteral("&nbsp;").repeated(4 * depth);
        const QString name = blanks + nameOf(key).toHtmlEscaped() + "&nbsp;&nbsp;&nbsp;";
        const bool deeper = value.is_object() && !value.empty();
        const QString shown = deeper ? QString() : value.is_array() ? listOf(value) : valueOf(key, value).toHtmlEscaped();
        rows += "<tr><td>" + (depth == 0 ? "<b>" + name + "</b>" : name) + "</td><td>" + shown + "</td></tr>";
        if (deeper) addRows(rows, value, depth + 1);
    }
}

/// Html: a table of names and values.
QString scanProperties(const Scan& scan) {
    QString rows;
    Json facts = exports::infoReport(scan);
    for (Json& range : facts["range_mm"]) { // with the unit and the digits of titles and reports
        if (range.is_number()) range = exactBytes(QString::number(range.get<double>() / 1000.0, 'f', 2));
    }
    addRows(rows, facts, 0);
    return "<table>" + rows + "</table>";
}

QString words(const char* text) { return QObject::tr(text); }

void showSheet(QWidget* parent, const QString& title, QTextBrowser* browser, QSize size) {
    QDialog dialog(parent);
    dialog.setWindowTitle(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(browser);
    column->addWidget(buttons);
    dialog.resize(size);
    dialog.exec();
}

} // namespace

void showShortcuts(QWidget* parent, const QList<QAction*>& actions) {
    QString rows;
    for (const QAction* action : actions) {
        QStringList keys;
        for (const QKeySequence& sequence : action->shortcuts()) keys << sequence.toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        QString name = action->property(kPlainName).isValid() ? action->property(kPlainName).toString() : action->text();
        rows +=
            "<tr><td>" + name.remove('&').toHtmlEscaped() + "&nbsp;&nbsp;</td><td><b>" + keys.join(", ").toHtmlEscaped() + "</b></td></tr>";
    }
    const QString mouse = words(
        "<h3>Mouse in the cloud</h3>Left drag turns, middle drag or Shift+left drag pans, right drag or wheel zooms, Ctrl+left drag rolls; "
        "double-click or middle click sets the centre of rotation; Alt+wheel point size, Ctrl+wheel near clip, Ctrl+Shift+wheel far clip."
        "<h3>Mouse in the images</h3>Left or middle drag pans, wheel zooms, right drag changes the display levels, double-click fits; "
        "Shift+drag looks closer."
        "<h3>Mouse in all views</h3>A click pins a target; while rocks are shown, it selects the rock there, and Shift+click pins. "
        "Ctrl+click selects one more rock. A right click opens the menu of the cell.");
    auto* browser = new QTextBrowser;
    browser->setHtml("<h3>" + words("Keys") + "</h3><table>" + rows + "</table>" + mouse);
    showSheet(parent, words("Keys and mouse"), browser, {560, 700});
}

void showScanProperties(QWidget* parent, const Scan& scan) {
    auto* browser = new QTextBrowser;
    browser->setObjectName("scan-properties");
    browser->setHtml(scanProperties(scan));
    showSheet(parent, words("Scan"), browser, {640, 600});
}

void showAbout(QWidget* parent, const QString& renderer) {
    QMessageBox box(parent);
    box.setWindowTitle(words("About EdgeScan"));
    box.setTextFormat(Qt::RichText);
    box.setText(words("<h3>EdgeScan %1</h3>Finds the edges of rocks in a laser range scan and shows them in the cloud.<br>"
                      "It shows geometry from one viewpoint. It does not judge any rock.<br><br>Licence: BSD-3-Clause<br>Drawn by %2")
                    .arg(QString(version()) + " (" + commit() + ")", renderer.toHtmlEscaped()));
    box.setStandardButtons(QMessageBox::Ok);
    box.exec();
}

} // namespace edgescan::ui
