// Commands of the A/B comparison and of edge confidence.
#include "ui/window/compare_menu.h"

#include "ui/controllers/comparing.h"
#include "ui/controllers/confidence.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/window/main_window.h"

namespace edgescan::ui {

Command compareMenu(Comparing& comparing) {
    const auto whileKept = onlyWhile(comparing, &Comparing::pictureAChanged);
    const auto flipped = [&comparing, whileKept](QAction& action) {
        whileKept(action);
        QObject::connect(&comparing, &Comparing::flipped, &action, &QAction::setChecked);
    };
    return submenu(
        "Compare &A/B",
        {
            command("&Keep This as A", "Shift+A", [&comparing] { comparing.keep(); }),
            command("&Compare with Earlier Scan…", "", [&comparing] { comparing.askScan(); }),
            linked(command("Exchange A and &B", "", [&comparing] { comparing.swap(); }), whileKept),
            command("&Demo before and after a Blast", "", [&comparing] { comparing.openDemoPair(); }),
            kLine,
            linked(toggle("Show &A", "", nullptr, false, [&comparing](bool on) { comparing.flip(on); }), flipped),
            linked(toggle("Show What &Changed", "Shift+D", nullptr, true, [&comparing](bool on) { comparing.setDifferenceShown(on); }),
                   [&comparing, whileKept](QAction& action) {
                       whileKept(action);
                       action.setChecked(true);
                       action.setProperty(kInSessions, "compare/changes");
                       QObject::connect(&comparing, &Comparing::differenceShownChanged, &action, &QAction::setChecked);
                   }),
            linked(toggle("&Colour by Distance from A", "", nullptr, false, [&comparing](bool on) { comparing.setByDistance(on); }),
                   [&comparing](QAction& action) {
                       action.setObjectName("compare-distance");
                       QObject::connect(&comparing, &Comparing::byDistanceChanged, &action, &QAction::setChecked);
                   }),
            linked(command("&Next Changed Region", "Shift+N", [&comparing] { comparing.nextRegion(); }), whileKept),
            linked(command("&Previous Changed Region", "Shift+B", [&comparing] { comparing.previousRegion(); }), whileKept),
            kLine,
            linked(command("&Forget A", "", [&comparing] { comparing.forget(); }), whileKept),
        });
}

void followChanges(MainWindow& w) {
    const auto follow = [&w] {
        w.viewer().changeLegend.showOverRocks(w.viewer().views.scene().pointsOver != nullptr);
        w.viewer().legend.setVisible(w.viewer().views.scene().picture != nullptr && w.viewer().views.scene().insteadNow() == nullptr);
    };
    QObject::connect(&w.viewer().views, &LinkedViews::picturesChanged, &w, follow);
}

Command confidenceCommand(Confidence& confidence) {
    return linked(toggle("Edge Con&fidence", "Shift+W", nullptr, false, [&confidence](bool on) { confidence.setOn(on); }),
                  [](QAction& action) {
                      action.setObjectName("edge-confidence");
                      action.setProperty(kInSessions, "edges/confidence");
                      action.setToolTip(QObject::tr("Colours and sizes of edges by how many settings near these find them too"));
                  });
}

} // namespace edgescan::ui
