// "Does this look right?" after opening: shows evidence against the reading of the scan, with corrections to click.
#pragma once

#include "core/files/plausibility/opening_check.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace edgescan::ui {

class Files;
class NoticeBar;
class OpeningCard;
class Engine;

/// GUI thread only. The objects passed to it must outlive it.
class Opening : public QObject {
    Q_OBJECT
public:
    Opening(Engine& engine, Files& files, NoticeBar& notice);

    /// Shows the card about the file on the screen.
    void show();
    /// Null before it was first shown.
    [[nodiscard]] OpeningCard* card() const { return card_; }
    /// The file on the screen was checked.
    [[nodiscard]] bool settled() const { return !check_.behind(); }
    /// For the file on the screen; empty until known.
    [[nodiscard]] const std::optional<std::vector<files::OpeningPoint>>& points() const { return points_; }

private:
    struct Question {
        std::shared_ptr<const Scan> scan;
        ReadingOptions options;
    };
    static std::vector<files::OpeningPoint> checked(const Question& question, const Asker& asker);
    void follow();
    void storePoints(const std::shared_ptr<const Scan>& scan, const std::vector<files::OpeningPoint>& points);
    void fillCard();
    void preview(int point, int other);
    void adopt(int point, int other);
    void closed();
    [[nodiscard]] const files::OtherReading* otherAt(int point, int other) const;

    Engine& engine_;
    Files& files_;
    NoticeBar& notice_;
    OpeningCard* card_ = nullptr;
    std::optional<std::vector<files::OpeningPoint>> points_;
    QString path_;                                              // the file of points_
    std::optional<ReadingOptions> before_;                      // set while a preview is on the screen
    bool cardWanted_ = false;                                   // show the card as soon as the points are known
    Derived<Question, std::vector<files::OpeningPoint>> check_; // last
};

} // namespace edgescan::ui
