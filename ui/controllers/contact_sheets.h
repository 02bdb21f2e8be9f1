// The contact sheet of the slider in use: computed on its own thread, picture by picture; a click adopts a value.
#pragma once

#include "core/edges/tuning/contact_sheet.h"
#include "ui/engine/worker_bridge/newest.h"

#include <QImage>
#include <QObject>

#include <atomic>
#include <memory>
#include <vector>

namespace edgescan::ui {

class ContactCard;
class NoticeBar;
class Engine;
class Tuning;

/// GUI thread only. The objects passed to it must outlive it.
class ContactSheets : public QObject {
    Q_OBJECT
public:
    ContactSheets(Engine& engine, Tuning& tuning, NoticeBar& notice, QObject* parent);
    ~ContactSheets() override { wanted_ = 0; }

    /// Shows the sheet of the setting that was changed last, else of the method's main setting.
    void show();
    /// Null before the first sheet.
    [[nodiscard]] ContactCard* card() const { return card_; }
    [[nodiscard]] const std::vector<edges::SheetEntry>& entries() const { return entries_; }

private:
    struct Question {
        std::uint64_t number = 0;
        std::shared_ptr<const Scan> scan;
        edges::Settings settings;
        const edges::Parameter* parameter = nullptr;
        std::vector<double> values;
    };
    struct Answer {
        std::uint64_t number = 0;
        std::vector<edges::SheetEntry> entries;
    };
    [[nodiscard]] Answer run(const Question& question); // worker's thread
    void add(std::uint64_t number, const edges::SheetEntry& entry, const QImage& picture);
    void take(const Answer& answer);

    Engine& engine_;
    Tuning& tuning_;
    NoticeBar& notice_;
    ContactCard* card_ = nullptr;
    Question asked_;
    std::vector<edges::SheetEntry> entries_;
    std::uint64_t sheets_ = 0;
    std::atomic<std::uint64_t> wanted_{0}; // number of the awaited sheet; 0: none
    Newest<Question, Answer> worker_;      // last
};

} // namespace edgescan::ui
