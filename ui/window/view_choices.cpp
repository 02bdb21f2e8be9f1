// Choices in the menu View.
#include "ui/window/view_choices.h"

#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/base/themes.h"
#include "ui/controllers/scan_look.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/sheets.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace edgescan::ui {

Command themeMenu(QObject& parent, Preferences& preferences) {
    constexpr const char* kKey = "view/theme";
    const QString key = preferences.text(kKey);
    const Theme& remembered = themeOf(key);
    if (&remembered != &themeInUse()) useColours(remembered);
    auto* group = new QActionGroup(&parent);
    Command menu = submenu("&Theme", {});
    for (const Theme& theme : themes()) {
        Command made = toggle(theme.label, "", nullptr, false, [&preferences, &theme](bool) {
            useColours(theme);
            preferences.keep(kKey, QString(theme.key));
        });
        menu.submenu.push_back(choice(std::move(made), *group, QString("theme-") + theme.key, &theme == &themeInUse()));
    }
    return menu;
}

Command languageMenu(QWidget& window, Preferences& preferences, NoticeBar& notice) {
    auto* group = new QActionGroup(&window);
    Command menu = submenu("Lan&guage", {});
    for (const Language& language : kLanguages) {
        const QString code = language.code;
        Command made{.text = QString::fromUtf8(language.name), .set = [&window, &preferences, &notice, code](bool) {
                         preferences.keep("language", code);
                         notice.showNotice(NoticeBar::Kind::Done, QObject::tr("The window uses this language from the next start on."));
                         if (preferences.dataFolder().isEmpty()) return;      // the next start would not know it
                         notice.offer(QObject::tr("Restart Now"), [&window] { // closing stores the session
                             if (window.close()) QCoreApplication::instance()->setProperty(kStartsAgain, QStringList());
                         });
                     }};
        menu.submenu.push_back(choice(std::move(made), *group, "language-" + code, code == languageInUse()));
    }
    return menu;
}

Command mouseMenu(QObject& parent, CloudView& cloud, Preferences& preferences) {
    constexpr const char* kKey = "view/mouse";
    auto* group = new QActionGroup(&parent);
    const QString remembered = preferences.text(kKey, "default");
    const auto preset = [&, group](const char* text, const QString& name, MousePreset mouse) {
        if (remembered == name) cloud.setMousePreset(mouse);
        Command made = toggle(text, "", nullptr, false, [&cloud, &preferences, name, mouse](bool) {
            cloud.setMousePreset(mouse);
            preferences.keep(kKey, name);
        });
        return choice(std::move(made), *group, "mouse-" + name, remembered == name);
    };
    return submenu("&Mouse", {
                                 preset("&Default: middle pans, right zooms", "default", MousePreset::Default),
                                 preset("&CloudCompare: right pans, middle zooms", "cloudcompare", MousePreset::CloudCompare),
                                 kLine,
                                 habit(toggle("&Wheel the other way", "", "view/wheel-reversed", false,
                                              [&cloud](bool on) { cloud.setWheelReversed(on); })),
                             });
}

Command colourMenu(QObject& parent, ScanLook& look) {
    auto* group = new QActionGroup(&parent);
    const auto row = [group, &look](Command made, ColourBy by) {
        made.set = [&look, by](bool) { look.setColourBy(by); };
        return chosenWhile(choice(made, *group, QString("colour-") + colourKey(by), look.colourBy() == by), look,
                           &ScanLook::colourByChanged, by);
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

Command shareMenu(QObject& parent, PanePlaces& places) {
    auto* group = new QActionGroup(&parent);
    const auto preset = [group, &places](const char* text, Share share) {
        const Command made = toggle(text, "", nullptr, false, [&places, share](bool) { places.setShare(share); });
        return chosenWhile(choice(made, *group, "share-" + kShareNames.at(static_cast<int>(share)), places.share() == share), places,
                           &PanePlaces::shareChanged, share);
    };
    return submenu("&Sizes of Views",
                   {command("&Next Sizes of Views", "Ctrl+M", [&places] { places.setShare(next(places.share())); }), kLine,
                    preset("&Balanced", Share::Balanced), preset("&Images Large", Share::Images), preset("&Cloud Large", Share::Cloud)});
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
            action.setEnabled(!on); // only its button, when held, ends cab mode
        };
        follow(cab.on());
        QObject::connect(&cab, &CabMode::changed, &action, follow);
    });
}

} // namespace edgescan::ui
