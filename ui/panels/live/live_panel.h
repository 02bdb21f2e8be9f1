// The panel above the views: hold, the scanner's health and progress; scanner address, connect, record, keep.
#pragma once

#include "core/scanner/sweep_assembly/sweep_settings.h"
#include "ui/panels/live/health_strip.h"

#include <QElapsedTimer>
#include <QWidget>

class QDialog;
class QHBoxLayout;
class QCheckBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace edgescan::ui {

class FlowLayout;
class SweepForm;
class TopicMenu;

/// GUI thread only. Signals the operator's choices and displays the values it is given; it opens no connection.
class LivePanel : public QWidget {
    Q_OBJECT
public:
    explicit LivePanel(QWidget* parent = nullptr);

    void setAddress(const QString& host, int port);
    [[nodiscard]] QString host() const;
    /// "HOST:PORT" and "[IPv6]:PORT" in the field of the address fill both fields, as on the command line.
    void splitAddress();
    /// That of "ws://HOST:PORT", else of its own field.
    [[nodiscard]] int port() const;
    /// The address is that of a robot's bridge.
    [[nodiscard]] bool bridge() const { return bridge_; }
    /// Of a bridge: ranges that repeat far apart from the rest are measured.
    [[nodiscard]] bool keepsRepeated() const;
    void setKeepRepeated(bool on);
    void setSweep(const scanner::SweepSettings& settings);
    [[nodiscard]] scanner::SweepSettings sweep() const;
    /// The axis that the ranges show, in the field of the mounting; empty: they show none.
    void showAxisFromRanges(std::optional<Axis> axis);
    /// Puts the text cursor into the host field.
    void askAddress();
    /// The same; a second time it closes the panel.
    void toggleAddress();
    /// Closes the panel if the operator opened it with askAddress(). False: it was not open, or a scanner is connected.
    bool closeAddress();
    /// Opens the fields of mounting and steps.
    void askSweep();

    void setConnected(bool connected);
    void setRecording(bool recording);
    /// Fewer fields, for cab mode.
    void setBrief(bool on);
    [[nodiscard]] bool brief() const { return brief_; }
    /// Hold and Follow each have a place of their own: a second tap does not do the opposite.
    void setFollowing(bool following);
    /// After Stop: a button shows one of these sweeps, and asks which where there are several. Empty: there is nothing else to show.
    void offerOthers(const QStringList& sweeps, const QString& help);
    [[nodiscard]] bool offers() const { return !others_.isEmpty(); }
    /// `note`: one sentence about the picture on the screen; the strip shows it while the scanner is well.
    void showHealth(const files::LiveHealth& health, HealthStrip::Picture picture, const QString& note = {});

    /// Hides the panel with all that it says about the last scanner.
    void forgetScanner();

    [[nodiscard]] TopicMenu& topics() { return *topics_; }
    [[nodiscard]] HealthStrip& strip() { return *strip_; }
    [[nodiscard]] QString scannerShown() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void connectRequested();
    void disconnectRequested();
    void recordRequested(bool on);
    void keepRequested();
    void followRequested(bool on);
    /// A place of offerOthers().
    void otherRequested(int place);
    /// The operator typed mounting or steps while the scanner is connected.
    void sweepRequested();
    /// The operator closed the panel.
    void closed();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addSweepDialog();
    void close();
    void reserveWidths();
    void showFields();
    void nameOther();
    void nameRecord();
    void askOther();
    void followAddress();

    QLabel* title_;
    QLineEdit* host_;
    QSpinBox* port_;
    QPushButton* connect_;
    QCheckBox* keepRepeated_;
    QToolButton* sweepButton_;
    QDialog* sweepDialog_;
    SweepForm* sweep_;
    TopicMenu* topics_;
    QPushButton* record_;
    QPushButton* keep_;
    QPushButton* hold_;
    QPushButton* follow_;
    QPushButton* other_;
    QToolButton* close_;
    StateBadge* recorded_; // its place stays free while nothing is recorded
    QLabel* scanner_;
    HealthStrip* strip_;
    QElapsedTimer sinceStop_;
    FlowLayout* buttons_ = nullptr;
    QHBoxLayout* stripRow_ = nullptr;
    bool connected_ = false, brief_ = false, bridge_ = false;
    bool asking_ = false; // the operator asked for the fields of the address
    QStringList others_;  // sweeps that the button offers after Stop
    QMenu* otherMenu_;
};

} // namespace edgescan::ui
