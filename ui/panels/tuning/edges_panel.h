// The panel "Edges": presets, one row per parameter of the table, and the lock that keeps upper = 3 x lower.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/edge_count_curve.h"
#include "core/edges/settings/presets.h"

#include <QWidget>

#include <map>
#include <memory>
#include <optional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace edgescan::edges {
struct Parameter;
} // namespace edgescan::edges

namespace edgescan::ui {

class CountCurve;
class ParameterRow;

/// The name of a built-in preset in plain words; of any other preset its own name.
[[nodiscard]] QString presetName(const std::string& name);

/// GUI thread only. Displays settings and signals the operator's changes; it changes no settings itself.
class EdgesPanel : public QWidget {
    Q_OBJECT
public:
    explicit EdgesPanel(QWidget* parent = nullptr);

    void show(const edges::Settings& settings);
    /// Shows the values of automatic parameters and the edge count.
    void showResult(const edges::Detection& detection);
    /// Shows the edge count for each value of this parameter.
    void showCounts(const QString& parameter, const edgescan::edges::EdgeCountCurve& curve);
    void forgetCounts();
    /// On: the picture does not match the numbers yet.
    void setBehind(bool behind);

    /// The preset that reset buttons restore, and that "modified" refers to.
    void setPreset(const edges::Preset& preset);
    [[nodiscard]] const edges::Preset& preset() const { return preset_; }
    [[nodiscard]] bool modified() const { return !(shown_ == preset_.settings); }
    [[nodiscard]] bool ratioLocked() const;
    /// The curve under the slider of "lower", "step" or "sensitivity".
    [[nodiscard]] CountCurve* curve(const char* key) const;
    [[nodiscard]] ParameterRow* row(const char* key) const;
    /// On: each slider has buttons for steps.
    void setForGloves(bool on);

public slots:
    void setRatioLocked(bool locked);

signals:
    void edited(const edgescan::edges::Settings& settings, bool dragging);
    void editEnded();
    /// The typed text is not a value; the sentence gives the reason.
    void refused(const QString& sentence);
    void presetChosen(const edgescan::edges::Preset& preset);
    void savePresetRequested();
    void openPresetRequested();
    void ratioLockChanged(bool locked);

private:
    void addPresets(QGridLayout& grid);
    void addRow(const edges::Parameter& parameter, QGridLayout& grid);
    void addNoise(QGridLayout& grid);
    void addCurve(const edges::Parameter& parameter, QGridLayout& grid);
    void addMeaning(QGridLayout& grid);
    [[nodiscard]] Result<double> lowerOfDepth(const QString& text) const;
    /// On the scan of the picture; NaN if it has none or it is unknown.
    [[nodiscard]] double automaticValue(const edges::Parameter& p) const;
    void addUpper(QGridLayout& grid);
    void edit(const edges::Parameter& parameter, double value, bool dragging);
    void noteThreshold(const edges::Settings& settings);
    void showPresetName();
    void showUpper();
    void showInUse();
    void showMeaning();

    edges::Settings shown_;
    edges::Settings lastGray_ =
        edges::cannySettings(); // the last settings with gray levels: their threshold is carried over to another method
    struct Carried {
        double lower = 0.0; // as set by the change of method
        edges::Method chosenFor = edges::Method::Canny;
        double chosen = 0.0;
    };
    std::map<edges::Method, Carried> carried_; // per method: the last change to it; undo returns to it
    struct InUse;
    std::shared_ptr<const InUse> inUse_; // what the method took on the scan of the picture
    edges::Preset preset_;
    std::vector<ParameterRow*> rows_;
    QComboBox* presets_ = nullptr;
    QLabel* modified_ = nullptr;
    QLabel* purpose_ = nullptr; // of the preset
    std::vector<CountCurve*> curves_;
    QLabel* upper_ = nullptr;
    QToolButton* fold_ = nullptr;
    QLabel* meaning_ = nullptr;
    QLabel* noise_ = nullptr;
    QLabel* behind_ = nullptr;
    QToolButton* lock_ = nullptr;
    QWidget* advanced_ = nullptr;
};

} // namespace edgescan::ui
