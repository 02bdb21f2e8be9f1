// The contact sheet of the slider in use: computed off the GUI thread, picture by picture; a click adopts a value.
#pragma once

#include "core/edges/tuning/values_of_setting.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QImage>
#include <QObject>

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

    /// Shows the sheet of the setting that was changed last, else of the method's main setting.
    void show();
    /// Null before the first sheet.
    [[nodiscard]] ContactCard* card() const { return card_; }
    [[nodiscard]] const std::vector<edges::SheetEntry>& entries() const { return entries_; }

private:
    struct Sheet {
        edges::Settings settings;
        const edges::Parameter* parameter = nullptr;
        std::vector<double> values;
    };
    struct Question {
        std::shared_ptr<const Scan> scan;
        Sheet sheet;
    };
    [[nodiscard]] std::vector<edges::SheetEntry> run(const Question& question, const Asker& asker); // pool's thread
    void add(const edges::SheetEntry& entry, const QImage& picture);
    void take(const std::vector<edges::SheetEntry>& entries);

    Engine& engine_;
    Tuning& tuning_;
    NoticeBar& notice_;
    ContactCard* card_ = nullptr;
    Sheet shown_;
    std::vector<edges::SheetEntry> entries_;                  // of shown_
    Derived<Question, std::vector<edges::SheetEntry>> sheet_; // last
};

} // namespace edgescan::ui
