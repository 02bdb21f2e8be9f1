// The panel under the views: which scanner, connect, record, keep, follow; and its health.
#pragma once

#include "core/scanner/sweep_assembly/sweep_settings.h"
#include "ui/panels/live/health_strip.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace edgescan::ui {

class SweepForm;

/// GUI thread only. Says what the operator wants and shows what it is told; it connects to nothing by itself.
class LivePanel : public QWidget {
    Q_OBJECT
public:
    explicit LivePanel(QWidget* parent = nullptr);

    void setAddress(const QString& host, int port);
    [[nodiscard]] QString host() const;
    [[nodiscard]] int port() const;
    void setSweep(const SweepSettings& settings);
    [[nodiscard]] SweepSettings sweep() const;
    /// The cursor into the host.
    void askAddress();

    void setConnected(bool connected);
    void setRecording(bool recording);
    void setFollowing(bool following);
    void showHealth(const LiveHealth& health, HealthStrip::Picture picture);

    [[nodiscard]] HealthStrip& strip() { return *strip_; }
    [[nodiscard]] QString scannerShown() const;

signals:
    void connectWanted();
    void disconnectWanted();
    void recordWanted(bool on);
    void keepWanted();
    void followWanted(bool on);
    /// Mounting or steps were typed while the scanner is connected.
    void sweepWanted();

private:
    void addSweepMenu();

    QLineEdit* host_;
    QSpinBox* port_;
    QPushButton* connect_;
    QToolButton* sweepButton_;
    SweepForm* sweep_;
    QPushButton* record_;
    QPushButton* keep_;
    QPushButton* follow_;
    QLabel* scanner_;
    HealthStrip* strip_;
    bool connected_ = false;
};

} // namespace edgescan::ui
