// An undo step, for every part of the viewer's state; and its name: in the language of the sources for the audit log, and in the language
// of the window.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoCommand>
#include <QUndoStack>
#include <QVariant>

#include <functional>
#include <utility>

namespace edgescan::ui {

/// In the form that QUndoCommand takes: text() before the line break, the menu's text after it. `given` fills %1, %2 ...
template <class... Given>
[[nodiscard]] QString stepName(const char* text, const Given&... given) {
    QString source = QString::fromUtf8(text), shown = QObject::tr(text);
    ((source = source.arg(given)), ...);
    ((shown = shown.arg(given)), ...);
    return source + '\n' + shown;
}

/// The number of a new drag: steps with the same number become one.
[[nodiscard]] inline int nextDrag() {
    static int last = 0;
    return ++last;
}

/// A step that may belong to one scan.
class ScanStep {
public:
    /// True while that scan is on the screen; empty: the step belongs to no scan.
    using Here = std::function<bool()>;

    explicit ScanStep(Here here) : here_(std::move(here)) {}
    ScanStep(const ScanStep&) = delete;
    ScanStep& operator=(const ScanStep&) = delete;
    virtual ~ScanStep() = default;
    /// False: the step would change nothing, because another scan is on the screen.
    [[nodiscard]] bool applies() const { return !here_ || here_(); }
    /// What undoing it does, in the language of the window, for a step whose name has two values: in their order. Empty: "Undone: NAME".
    [[nodiscard]] virtual QString undoneText() const { return {}; }

private:
    Here here_;
};

inline constexpr const char* kDrops = "drops"; ///< property of a stack that drops steps: the operator undoes nothing

/// After another scan was opened, and after each step: takes away the next steps that belong to another scan, so that Undo and Redo name
/// only what they can do.
inline void dropStepsOfOtherScans(QUndoStack& stack) {
    if (stack.property(kDrops).toBool()) return;
    stack.setProperty(kDrops, true);
    const auto drop = [&stack](int fromIndex, void (QUndoStack::*pass)()) {
        const auto isOfOther = [&] {
            const auto* step = dynamic_cast<const ScanStep*>(stack.command(stack.index() + fromIndex)); // null outside of the stack
            return step != nullptr && !step->applies();
        };
        for (int before = -1; stack.count() != before && isOfOther();) {
            before = stack.count();
            (stack.*pass)(); // changes nothing, and the stack forgets the step
        }
    };
    drop(-1, &QUndoStack::undo);
    const int all = stack.count();
    drop(0, &QUndoStack::redo);
    if (stack.count() != all) { // Qt reports no step that goes by Redo
        emit stack.canRedoChanged(stack.canRedo());
        emit stack.redoTextChanged(stack.redoText());
    }
    stack.setProperty(kDrops, false);
}

/// True if Undo would undo this step.
[[nodiscard]] inline bool isNewest(const QUndoStack& stack, const QUndoCommand* step) {
    return stack.index() > 0 && stack.command(stack.index() - 1) == step;
}

/// Two values of one part of the state.
template <class Value>
class UndoStep : public QUndoCommand, public ScanStep {
public:
    /// Makes the value the part's value. False: the value belongs to another scan than the one on the screen; the step is obsolete.
    using Use = std::function<bool(const Value& value)>;
    using Name = std::function<QString(const Value& before, const Value& after)>;

    /// `here`: on another scan the step is obsolete.
    UndoStep(const QString& name, Value before, Value after, Use use, Here here = {})
        : QUndoCommand(name), ScanStep(std::move(here)), before_(std::move(before)), after_(std::move(after)), use_(std::move(use)) {}
    /// Of a drag, whose steps become one under the name of all that it changed.
    UndoStep(int drag, Name name, Value before, Value after, Use use)
        : QUndoCommand(name(before, after)), ScanStep({}), before_(std::move(before)), after_(std::move(after)), use_(std::move(use)),
          drag_(drag), name_(std::move(name)) {}

    /// Where this step is obsolete, undo or redo continues with the next step of the stack.
    void giveWayIn(QUndoStack& stack) { stack_ = &stack; }

    void undo() override { apply(before_, &QUndoStack::undo); }
    void redo() override { apply(after_, &QUndoStack::redo); }
    [[nodiscard]] int id() const override { return drag_; }
    [[nodiscard]] QString undoneText() const override { return name_ ? name_(after_, before_).section('\n', -1) : QString(); }
    bool mergeWith(const QUndoCommand* later) override {
        if (later->id() != id()) return false;
        after_ = static_cast<const UndoStep*>(later)->after_;
        setText(name_(before_, after_));
        return true;
    }

private:
    void apply(const Value& value, void (QUndoStack::*next)()) {
        if (applies() && use_(value)) return;
        setObsolete(true);
        if (stack_ != nullptr) QMetaObject::invokeMethod(stack_, next, Qt::QueuedConnection);
    }

    Value before_, after_;
    Use use_;
    int drag_ = -1; // QUndoCommand: never merged
    Name name_;
    QUndoStack* stack_ = nullptr;
};

} // namespace edgescan::ui
