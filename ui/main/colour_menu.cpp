// Colours of the cloud as a menu.
#include "ui/main/colour_menu.h"

#include "ui/control/scan_look.h"
#include "ui/main/main_window.h"
#include "ui/session/memory.h"

#include <QAction>
#include <QActionGroup>

#include <tuple>

namespace edgescan::ui {

Command colourMenu(MainWindow& window, Memory& memory) {
    constexpr const char* kKey = "view/colour-by";
    auto* group = new QActionGroup(&window);
    const auto row = [&](Command made, const char* name, ColourBy by) {
        made.set = [&window, &memory, name, by](bool) {
            window.look().setColourBy(by);
            memory.keep(kKey, QString(name));
        };
        return linked(made, [&window, &memory, group, name, by](QAction& action) {
            group->addAction(&action);
            action.setObjectName(QString("colour-") + name);
            const bool chosen = memory.text(kKey, "gray") == name;
            action.setChecked(chosen);
            if (chosen) window.look().setColourBy(by);
        });
    };
    return submenu("Cloud C&olour", {
                                        row(toggle("G&ray", "", nullptr, false, nullptr), "gray", ColourBy::Nothing),
                                        row(toggle("By &Range", "Shift+J", nullptr, false, nullptr), "range", ColourBy::Range),
                                        row(toggle("By &Height", "Shift+H", nullptr, false, nullptr), "height", ColourBy::Height),
                                        row(toggle("By &Line", "", nullptr, false, nullptr), "line", ColourBy::Line),
                                    });
}

} // namespace edgescan::ui
