// The themes as a menu.
#include "ui/main/theme_menu.h"

#include "ui/base/themes.h"
#include "ui/main/main_window.h"
#include "ui/session/memory.h"

#include <QAction>
#include <QActionGroup>

namespace edgescan::ui {

Command themeMenu(MainWindow& window, Memory& memory) {
    constexpr const char* kKey = "view/theme";
    const Theme& remembered = themeOf(memory.text(kKey));
    if (&remembered != &themeInUse()) useColours(remembered);
    auto* group = new QActionGroup(&window);
    Command menu = submenu("&Theme", {});
    for (const Theme& theme : themes()) {
        Command made = toggle(theme.label, "", nullptr, false, [&memory, &theme](bool) {
            useColours(theme);
            memory.keep(kKey, QString(theme.key));
        });
        menu.submenu.push_back(linked(made, [group, &theme](QAction& action) {
            group->addAction(&action);
            action.setObjectName(QString("theme-") + theme.key);
            action.setChecked(&theme == &themeInUse());
        }));
    }
    return menu;
}

} // namespace edgescan::ui
