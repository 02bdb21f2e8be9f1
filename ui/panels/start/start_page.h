// The page shown while no scan is open: first steps, and recent scans.
#pragma once

#include <QFrame>
#include <QImage>
#include <QStringList>

#include <atomic>
#include <functional>

class QCommandLinkButton;
class QHBoxLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace edgescan::ui {

struct RecentScan {
    QString path;
    bool exists = false; ///< the file exists
    QString words;       ///< "2026-11-19 08:12 UTC · 1,000 lines · RECORDED"; for an unreadable file the reason
    QImage picture;      ///< null: no picture

    bool operator==(const RecentScan&) const = default;
};

inline constexpr int kThumbnailPx = 132; ///< longest side

/// Reads the scan if `cache` has no picture of it, or the file changed since. `goOn` returning false cancels. For any thread.
[[nodiscard]] RecentScan recentScan(const QString& path, const QString& cache, const std::function<bool()>& goOn);
/// Deletes the oldest pictures until at most `most` are left.
void trimThumbnails(const QString& cache, int most);

/// GUI thread only. Pictures are made one after the other on a separate thread.
class StartPage : public QFrame {
    Q_OBJECT
public:
    /// `cache`: folder of the stored pictures; empty: do not store them.
    explicit StartPage(const QString& cache, QWidget* parent = nullptr);
    ~StartPage() override { ending_ = true; }

    void showRecent(const QStringList& paths);
    /// The session that can be continued; empty: none.
    void showSession(const QString& path);
    /// Names neither keys nor a mouse, and has no buttons for them.
    void setForTouch(bool on);
    /// Strips above it cover so much of its top.
    void setTopCovered(int pixels);
    [[nodiscard]] QListWidget& list() { return *list_; }
    /// All pictures are made.
    [[nodiscard]] bool settled() const { return waiting_.isEmpty() && !looking_; }

signals:
    void openRequested();
    void connectRequested();
    void continueRequested();
    void demoRequested();
    void demoPairRequested();
    void scanRequested(const QString& path);
    /// The operator wants to search for a scan that is no longer at its path.
    void locateRequested(const QString& path);
    void clearRequested();
    void cabRequested();
    void keysRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    QWidget* makeTitle();
    QWidget* makeFoot();
    void lookAtNext();
    void showPreview(const RecentScan& scan);

    QString cache_;
    QCommandLinkButton *open_, *connect_, *session_;
    QPushButton *cab_ = nullptr, *keys_ = nullptr;
    QWidget *title_ = nullptr, *foot_ = nullptr;
    QHBoxLayout* row_ = nullptr;
    QVBoxLayout* all_ = nullptr;
    QListWidget* list_;
    QLabel* none_;
    QPushButton* clear_;
    QStringList waiting_; // to be previewed
    bool looking_ = false, forTouch_ = false;
    int covered_ = 0; // px of its top
    std::atomic<bool> ending_{false};
};

} // namespace edgescan::ui
