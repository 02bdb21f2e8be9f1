// Sections through two measured cells or through a rock: worked out, shown in true scale, measured in, exported.
#pragma once

#include "core/inspect/section/section.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/engine/worker_bridge/picture.h"
#include "ui/panels/section/section_plot.h"

#include <QObject>

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>
#include <vector>

namespace edgescan::rocks {
struct Study;
} // namespace edgescan::rocks

namespace edgescan::ui {

class Engine;
class LinkedViews;
class NoticeBar;
class Preferences;
class Rocks;
class SectionCard;
class Targets;

/// GUI thread only. The objects passed to it must outlive it.
class Sections : public QObject {
    Q_OBJECT
public:
    Sections(Engine& engine, LinkedViews& views, Rocks& rocks, Targets& targets, NoticeBar& notice, Preferences& preferences);

    /// Through the ends of the chosen measurement; none is chosen: of the last one.
    void throughMeasurement();
    /// Along the selected rock.
    void throughRock();
    /// Null before the first section.
    [[nodiscard]] SectionCard* card() const { return card_; }
    /// False: it is not open.
    bool close();
    void exportTo(const QString& path);

signals:
    /// Its card is about to be shown.
    void opening();

private:
    struct Question {
        std::shared_ptr<const Picture> picture;
        inspect::SectionPlane plane;
        std::shared_ptr<const rocks::Study> rocks; ///< null: rocks are not shown
        Eigen::AlignedBox2d aboutM;                ///< the cells that the section was asked for, across and up
        SectionRocks drawn;                        ///< how
        std::vector<Eigen::Vector2d> endsM;        ///< of the measurement, across and up; empty: through a rock
        QString length;                            ///< of the measurement, as in the views
        std::vector<std::uint32_t> cells;          ///< what the section is through
    };
    [[nodiscard]] static QString askRock();
    /// `rock`: label of the rock that these cells are of; 0: they are the ends of a measurement, and this is its length in words.
    void ask(const Result<inspect::SectionPlane>& plane, const std::vector<std::uint32_t>& cells, std::uint32_t rock,
             const QString& length = {});
    void showSection(const Question& question, const std::shared_ptr<const inspect::Section>& section);
    /// `cut`: the cells that the section is through.
    void placeCard(const std::vector<std::uint32_t>& cut);
    void showLength(const inspect::SectionVertex& from, const inspect::SectionVertex& to);
    void askExport();
    [[nodiscard]] std::shared_ptr<const rocks::Study> study() const;

    Engine& engine_;
    LinkedViews& views_;
    Rocks& rocks_;
    Targets& targets_;
    NoticeBar& notice_;
    Preferences& preferences_;
    SectionCard* card_ = nullptr; // child of the window
    std::shared_ptr<const Picture> picture_;
    Derived<Question, inspect::Section> sections_; // last
};

} // namespace edgescan::ui
