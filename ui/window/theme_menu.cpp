// The themes as a menu.
#include "ui/window/theme_menu.h"

#include "ui/base/themes.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"

#include <QAction>
#include <QActionGroup>

namespace edgescan::ui {

Command themeMenu(QObject& parent, Preferences& preferences) {
    constexpr const char* kKey = "view/theme";
    const Theme& remembered = themeOf(preferences.text(kKey));
    if (&remembered != &themeInUse()) useColours(remembered);
    auto* group = new QActionGroup(&parent);
    Command menu = submenu("&Theme", {});
    for (const Theme& theme : themes()) {
        Command made = toggle(theme.label, "", nullptr, false, [&preferences, &theme](bool) {
            useColours(theme);
            preferences.keep(kKey, QString(theme.key));
        });
        menu.submenu.push_back(linked(made, [group, &theme](QAction& action) {
            group->addAction(&action);
            action.setObjectName(QString("theme-") + theme.key);
            action.setChecked(&theme == &themeInUse());
        }));
    }
    return menu;
}

Command imagesFirstCommand(PanePlaces& places) {
    return linked(
        toggle("Images F&irst", "Ctrl+M", "view/images-first", false, [&places](bool on) { places.setImagesFirst(on); }),
        [&places](QAction& action) { QObject::connect(&places, &PanePlaces::imagesFirstChanged, &action, &QAction::setChecked); });
}

Command cabCommand(CabMode& cab, Preferences& preferences) {
    constexpr const char* kKey = "view/cab";
    const auto use = [&cab, &preferences](bool on) {
        cab.set(on);
        preferences.keep(kKey, on);
    };
    QObject::connect(&cab, &CabMode::leaveRequested, &cab, [use] { use(false); });
    return linked(toggle("C&ab Mode", "Shift+F11", nullptr, false, use), [&cab](QAction& action) {
        action.setObjectName("cab-mode");
        const auto follow = [&action](bool on) {
            action.setChecked(on);
            action.setEnabled(!on); // holding Locked ends cab mode
        };
        follow(cab.on());
        QObject::connect(&cab, &CabMode::changed, &action, follow);
    });
}

} // namespace edgescan::ui
