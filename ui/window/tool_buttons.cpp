// The table of the tool bar's buttons.
#include "ui/window/tool_buttons.h"

#include "ui/panels/keys/shortcuts.h"
#include "ui/window/main_window.h"
#include "ui/window/tool_bar.h"

#include <QAction>
#include <QMenu>

#include <algorithm>
#include <array>
#include <vector>

namespace edgescan::ui {
namespace {

/// A row without a command is a gap.
struct ToolRow {
    const char* command = nullptr; ///< its untranslated name: menu and text of the source
    const char* sign = nullptr;
    const char* word = nullptr;
    ToolBar::Word shown = ToolBar::Word::Next;
    bool ofScan = false; ///< disabled before a scan is open
};

constexpr bool kOfScan = true;

constexpr std::array kBefore{
    ToolRow{"File/Open", "open", QT_TRANSLATE_NOOP("QObject", "Open"), ToolBar::Word::First},
    ToolRow{"File/Connect to Scanner", "connect", QT_TRANSLATE_NOOP("QObject", "Connect"), ToolBar::Word::First},
    ToolRow{},
    ToolRow{"Edit/Undo", "undo", QT_TRANSLATE_NOOP("QObject", "Undo"), ToolBar::Word::Last},
    ToolRow{"Edit/Redo", "redo", QT_TRANSLATE_NOOP("QObject", "Redo"), ToolBar::Word::Last},
    ToolRow{},
    ToolRow{"Measure/Pin", "pin", QT_TRANSLATE_NOOP("QObject", "Pin"), ToolBar::Word::Next, kOfScan},
};
constexpr std::array kBehind{
    ToolRow{"Edges/Why Is This Cell an Edge or Not?", "why", QT_TRANSLATE_NOOP("QObject", "Why"), ToolBar::Word::Next, kOfScan},
    ToolRow{},
    ToolRow{"View/Look from/From Scanner", "view-from-scanner", QT_TRANSLATE_NOOP("QObject", "Scanner view"), ToolBar::Word::Last, kOfScan},
    ToolRow{"View/Fit All Views", "fit", QT_TRANSLATE_NOOP("QObject", "Fit"), ToolBar::Word::Last, kOfScan},
    ToolRow{},
    ToolRow{"Rocks/Show Rocks", "rocks", QT_TRANSLATE_NOOP("QObject", "Rocks"), ToolBar::Word::Next, kOfScan},
};
constexpr std::array kLast{
    ToolRow{"File/Report", "report", QT_TRANSLATE_NOOP("QObject", "Report"), ToolBar::Word::Next, kOfScan},
    ToolRow{},
    ToolRow{"View/Cab Mode", "cab-mode", QT_TRANSLATE_NOOP("QObject", "Cab")},
};

/// An entry of a button's menu; an empty text is a separator.
struct MenuRow {
    const char* name;
    const char* sign;
    const char* word;
    std::vector<const char*> commands;
    std::vector<const char*> lights; ///< commands that highlight the button while they are on
};

const std::vector<const char*> kWaysToMeasure{"Measure/Distance",    "Measure/Vertical",      "Measure/Angle",
                                              "Measure/Spans a × b", "Measure/Along Surface", "Measure/Throat Width"};
const MenuRow kMeasures{"tool-measure", "measure", QT_TRANSLATE_NOOP("QObject", "Measure"), kWaysToMeasure, kWaysToMeasure};
const MenuRow kSelections{"tool-select",
                          "select",
                          QT_TRANSLATE_NOOP("QObject", "Select"),
                          {"Measure/Box", "Measure/Lasso", "", "Measure/Zoom to Selected", "Measure/Isolate Selected",
                           "Measure/Hide Selected", "Measure/Show All", "", "Measure/Range Gate", "Measure/Export Selected"},
                          {"Measure/Box", "Measure/Lasso"}};
const MenuRow kCompares{"tool-compare",
                        "ab",
                        QT_TRANSLATE_NOOP("QObject", "A/B"),
                        {"Edges/Compare A/B/Keep This as A", "Edges/Compare A/B/Compare with Earlier Scan",
                         "Edges/Compare A/B/Exchange A and B", "Edges/Compare A/B/Demo before and after a Blast", "",
                         "Edges/Compare A/B/Show A", "Edges/Compare A/B/Show What Changed", "Edges/Compare A/B/Next Changed Region",
                         "Edges/Compare A/B/Previous Changed Region", "", "Edges/Compare A/B/Forget A"},
                        {"Edges/Compare A/B/Show A"}};

const MenuRow kExports{"tool-export",
                       "export",
                       QT_TRANSLATE_NOOP("QObject", "Export"),
                       {"File/Export/Edge Cloud", "File/Export/Edge Drawing (DXF)", "File/Export/Full Cloud", "File/Export/Selected Cells",
                        "File/Export/Targets", "Rocks/Export Rocks", "", "File/Export/Edge Image", "File/Export/Gray Image",
                        "File/Export/Range Image", "File/Screenshot", "", "File/Report"},
                       {}};

template <class Rows>
void addRows(ToolBar& bar, const QList<KeyedCommand>& commands, const Rows& rows) {
    for (const ToolRow& row : rows) {
        if (row.command == nullptr) {
            bar.addGap();
            continue;
        }
        bar.add(actionOf(commands, row.command), row.sign, QObject::tr(row.word), row.shown);
        if (row.ofScan) bar.needsScan(actionOf(commands, row.command));
    }
}

void addMenu(ToolBar& bar, const QList<KeyedCommand>& commands, const MenuRow& row) {
    auto* menu = new QMenu;
    for (const char* id : row.commands) {
        if (*id == '\0')
            menu->addSeparator();
        else
            menu->addAction(&actionOf(commands, id));
    }
    menu->setToolTipsVisible(true); // why a command is off
    QList<QAction*> lights;
    for (const char* id : row.lights) lights << &actionOf(commands, id);
    bar.add(menu, row.name, row.sign, QObject::tr(row.word), lights);
}

} // namespace

void addToolButtons(MainWindow& window) {
    const QList<KeyedCommand> commands = keyedCommands(window.actions());
    ToolBar& bar = window.viewer().tools;
    addRows(bar, commands, kBefore);
    for (const MenuRow* row : {&kMeasures, &kSelections}) addMenu(bar, commands, *row);
    addRows(bar, commands, kBehind);
    addMenu(bar, commands, kCompares);
    bar.addGap();
    addMenu(bar, commands, kExports);
    addRows(bar, commands, kLast);
    for (const KeyedCommand& command : commands) { // the menus whose commands have no meaning without a scan
        const auto isOf = [&command](const char* menu) { return command.id.startsWith(menu); };
        const bool ofTargets = command.id == "File/Export/Targets"; // off also while there are none
        if ((isOf("Rocks/") || isOf("Measure/") || isOf("File/Export/")) && !ofTargets) bar.needsScan(*command.action);
    }
    bar.setScanOpen(false);
    QObject::connect(&window, &MainWindow::pictureShown, &bar, [&bar] { bar.setScanOpen(true); });
}

} // namespace edgescan::ui
