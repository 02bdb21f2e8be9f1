// Opens the manual in the browser.
#include "ui/window/manual.h"

#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QKeyEvent>
#include <QUrl>

#include <algorithm>
#include <array>

namespace edgescan::ui {
namespace {

struct Place {
    const char* widget; ///< its object name
    const char* page;
};
// Docks, panels and dialogs.
constexpr std::array kPlaces{
    Place{"dock-edges", "guide/tune"},
    Place{"range-window", "guide/reading-the-picture"},
    Place{"edge-legend", "guide/reading-the-picture"},
    Place{"dock-rocks", "guide/rocks"},
    Place{"dock-rock-table", "guide/rocks"},
    Place{"rock-card", "guide/rocks"},
    Place{"dock-targets", "guide/measure"},
    Place{"target-card", "guide/measure"},
    Place{"section", "guide/measure"},
    Place{"live-panel", "guide/live"},
    Place{"timeline", "guide/live"},
    Place{"start-page", "guide/quick-start"},
    Place{"tour", "guide/quick-start"},
    Place{"command-palette", "guide/keys"},
    Place{"proposals", "guide/tune"},
    Place{"opening-card", "guide/open"},
    Place{"reading-dialog", "guide/open"},
    Place{"scan-properties", "guide/open"},
    Place{"range-gate", "guide/reading-the-picture"},
    Place{"place-dialog", "reference/coordinates"},
    Place{"export-dialog", "guide/exports"},
    Place{"report-form", "guide/hand-over"},
    Place{"why-card", "guide/reading-the-picture"},
};

/// Sees F1 before the dialog does.
class ManualKey : public QObject {
public:
    explicit ManualKey(MainWindow& window) : QObject(&window), window_(window) {}

private:
    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() != QEvent::KeyPress) return false;
        const auto* key = static_cast<const QKeyEvent*>(event);
        const auto* widget = qobject_cast<const QWidget*>(object);
        if (key->key() != Qt::Key_F1 || key->modifiers() != Qt::NoModifier || widget == nullptr) return false;
        if (widget->window() == &window_) return false; // a command of the window, whose key may have been changed
        openManual(window_, widget);
        return true;
    }

    MainWindow& window_;
};

} // namespace

QString manualPageOf(const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget()) {
        const auto known = std::ranges::find_if(kPlaces, [&](const Place& place) { return widget->objectName() == place.widget; });
        if (known != kPlaces.end()) return known->page;
    }
    return QStringLiteral("index");
}

QStringList manualNames(const QString& page) {
    const QString language = languageInUse();
    if (language == "en") return {page};
    // The list of all pages is English; the quick start has it at its side.
    const QString guide = page == "index" ? QStringLiteral("guide/quick-start") : page;
    return {QString(guide).replace("guide/", "guide/" + language + "/"), page};
}

QString manualFile(const QString& page) {
    const QString bin = QCoreApplication::applicationDirPath();
    for (const QString& folder : {bin + "/../share/doc/edgescan/html", bin + "/../manual"}) {
        for (const QString& name : manualNames(page)) {
            const QFileInfo file(folder + "/" + name + ".html");
            if (file.isFile()) return file.canonicalFilePath();
        }
    }
    return {};
}

void openManual(MainWindow& window, const QWidget* at) {
    if (at == nullptr) at = QApplication::focusWidget();
    QString page = manualPageOf(at != nullptr ? at : QApplication::activeWindow());
    if (page == "index" && window.cab().on()) page = QStringLiteral("guide/cab");
    const QString file = manualFile(page);
    if (!file.isEmpty() && QDesktopServices::openUrl(QUrl::fromLocalFile(file))) return;
    window.viewer().notice.showNotice(NoticeBar::Kind::Warning,
                                      file.isEmpty()
                                          ? QObject::tr("The manual is not installed. Its texts are in the folder docs of the source, "
                                                        "page %1.")
                                                .arg(page)
                                          : QObject::tr("No browser opened the manual. It is the file %1.").arg(file));
}

void addManualKey(MainWindow& window) { QCoreApplication::instance()->installEventFilter(new ManualKey(window)); }

} // namespace edgescan::ui
