// Asks for values that a file may lack or have wrong: angles, mounting, unit, sensor, pose and calibration.
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

    /// The values of the fields; empty fields are taken from the file.
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
