// Asks what a file may not know of itself, or has wrong: angles, mounting, unit, sensor, pose and calibration.
#pragma once

#include "core/scan/grid/reading_options.h"

#include <QDialog>

#include <vector>

class QFormLayout;
class QLabel;

namespace edgescan::ui {

class ReadingDialog : public QDialog {
    Q_OBJECT
public:
    explicit ReadingDialog(const ReadingOptions& options, QWidget* parent = nullptr);

    /// As they stand in the fields; what is left empty is taken from the file.
    [[nodiscard]] ReadingOptions options() const { return options_; }

    void accept() override;

private:
    struct Field {
        const ReadingOption* option;
        std::function<QString()> text;
    };
    void addField(const ReadingOption& option, QFormLayout& form);

    ReadingOptions options_;
    std::vector<Field> fields_;
    QLabel* refusal_;
};

} // namespace edgescan::ui
