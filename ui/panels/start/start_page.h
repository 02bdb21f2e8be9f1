// The page over the views while nothing is open: what to begin with, and the scans of before.
#pragma once

#include "ui/panels/start/recent_scan.h"

#include <QFrame>
#include <QStringList>

#include <atomic>

class QCommandLinkButton;
class QLabel;
class QListWidget;
class QPushButton;

namespace edgescan::ui {

/// GUI thread only. Pictures are made on a thread of its own, one after the other.
class StartPage : public QFrame {
    Q_OBJECT
public:
    /// `cache`: where pictures are kept; empty: nowhere.
    explicit StartPage(const QString& cache, QWidget* parent = nullptr);
    ~StartPage() override { ending_ = true; }

    void showRecent(const QStringList& paths);
    /// The session that can be gone on with; empty: none.
    void showSession(const QString& path);
    [[nodiscard]] QListWidget& list() { return *list_; }
    /// All pictures are there.
    [[nodiscard]] bool settled() const { return waiting_.isEmpty() && !looking_; }

signals:
    void openWanted();
    void connectWanted();
    void goOnWanted();
    void demoWanted();
    void scanWanted(const QString& path);
    /// A scan that is not where it was is asked for.
    void locateWanted(const QString& path);
    void clearWanted();
    void cabWanted();
    void keysWanted();

private:
    QWidget* makeTitle();
    QWidget* makeFoot();
    void lookAtNext();
    void tell(const RecentScan& scan);

    QString cache_;
    QCommandLinkButton* open_;
    QCommandLinkButton* session_;
    QListWidget* list_;
    QLabel* none_;
    QPushButton* clear_;
    QStringList waiting_; // to be looked at
    bool looking_ = false;
    std::atomic<bool> ending_{false};
};

} // namespace edgescan::ui
