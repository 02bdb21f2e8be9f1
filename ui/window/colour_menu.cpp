// Colours of the cloud as a menu.
#include "ui/window/colour_menu.h"

#include "ui/controllers/scan_look.h"
#include "ui/panels/dialogs/sheets.h"

#include <QAction>
#include <QActionGroup>

namespace edgescan::ui {

Command colourMenu(QObject& parent, ScanLook& look) {
    auto* group = new QActionGroup(&parent);
    const auto row = [group, &look](Command made, ColourBy by) {
        made.set = [&look, by](bool) { look.setColourBy(by); };
        return linked(made, [group, &look, by](QAction& action) {
            group->addAction(&action);
            action.setObjectName(QString("colour-") + colourKey(by));
            action.setChecked(look.colourBy() == by);
            QObject::connect(&look, &ScanLook::colourByChanged, &action, [&action, by](ColourBy now) {
                if (now == by) action.setChecked(true);
            });
        });
    };
    const auto whereKnown = [&look](const Command& made) {
        return linked(made, [&look, link = made.link](QAction& action) {
            link(action);
            action.setProperty(kPlainName, QObject::tr("By &Intensity"));
            const auto follow = [&action](bool some) {
                action.setEnabled(some);
                action.setText(some ? QObject::tr("By &Intensity") : QObject::tr("By &Intensity (this scan has none)"));
            };
            follow(false);
            QObject::connect(&look, &ScanLook::intensityKnown, &action, follow);
        });
    };
    return submenu("Cloud C&olour", {
                                        row(toggle("G&ray", "", nullptr, false, nullptr), ColourBy::Nothing),
                                        row(toggle("By &Range", "Shift+J", nullptr, false, nullptr), ColourBy::Range),
                                        row(toggle("By &Height", "Shift+H", nullptr, false, nullptr), ColourBy::Height),
                                        row(toggle("By &Line", "", nullptr, false, nullptr), ColourBy::Line),
                                        whereKnown(row(toggle("By &Intensity", "", nullptr, false, nullptr), ColourBy::Intensity)),
                                    });
}

} // namespace edgescan::ui
