// Two numbers; the second is never below the first.
#include "ui/panels/dialogs/range_gate_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>

#include <cmath>

namespace edgescan::ui {
namespace {

QDoubleSpinBox* metres(const char* name, double value) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setRange(0.0, 10000.0);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(QObject::tr(" m"));
    box->setValue(value);
    return box;
}

} // namespace

std::optional<RangeGate> askForRangeGate(QWidget* parent, double nearM, double farM) {
    QDialog dialog(parent);
    dialog.setObjectName("range-gate");
    dialog.setWindowTitle(QObject::tr("Range gate"));
    auto* form = new QFormLayout(&dialog);
    auto* from = metres("gate-near", std::floor(nearM * 100.0) / 100.0);
    auto* to = metres("gate-far", std::ceil(farM * 100.0) / 100.0);
    form->addRow(QObject::tr("Draw cells from"), from);
    form->addRow(QObject::tr("to"), to);
    form->addRow(new QLabel(QObject::tr("All others are hidden in all views. Edges, counts and exports stay as they are.")));
    to->setMinimum(from->value());
    QObject::connect(from, QOverload<double>::of(&QDoubleSpinBox::valueChanged), to, [to](double value) { to->setMinimum(value); });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return RangeGate{from->value(), to->value()};
}

} // namespace edgescan::ui
