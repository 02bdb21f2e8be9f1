// What takes time now: opening, comparing, saving ... Each with its stage, its progress and a way to cancel it, for one place on the
// screen.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

namespace edgescan::ui {

/// `stage`: as the core names it.
[[nodiscard]] QString stageWords(const char* stage);

/// GUI thread only.
class Works : public QObject {
    Q_OBJECT
public:
    /// Work that lasts as long as this object.
    class Running {
    public:
        Running(Works& works, QString title, std::function<void()> cancel);
        ~Running();
        Running(const Running&) = delete;
        Running& operator=(const Running&) = delete;
        void progress(const QString& stage, double fraction);

        const QString title;
        QString stage;         ///< empty: not known yet
        double fraction = 0.0; ///< of the whole work, 0 to 1
        const std::function<void()> cancel;

    private:
        QPointer<Works> works_; // work that is still being saved may end after the list
    };

    using QObject::QObject;
    /// `cancel` ends the work; it may destroy the result of this function.
    [[nodiscard]] std::unique_ptr<Running> start(const QString& title, std::function<void()> cancel);
    /// The work that began last of those that still run; null: none runs.
    [[nodiscard]] const Running* newest() const { return running_.empty() ? nullptr : running_.back(); }
    /// Cancels the newest. False: none runs.
    bool cancel();
    void cancelAll();

signals:
    /// Work began or ended, or its progress changed.
    void changed();

private:
    std::vector<const Running*> running_;
};

} // namespace edgescan::ui
