// The settings and edits of rocks in a sidecar file of the scan, so that they are restored when the scan is opened again.
#pragma once

#include "core/rocks/selection/preset.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::ui {

/// GUI thread only; files are read and written on separate threads.
class RockSidecar : public QObject {
    Q_OBJECT
public:
    explicit RockSidecar(QObject* parent = nullptr);
    ~RockSidecar() override;

    /// Switches to the sidecar of this scan; pending writes for the previous scan are finished. Null, or a growing scan: no sidecar.
    void follow(std::shared_ptr<const Scan> scan);
    /// True until follow() has its answer.
    [[nodiscard]] bool reading() const { return reading_; }
    /// Schedules a write; without edits and region the file is deleted.
    void keep(const rocks::RockSettings& settings, const std::vector<rocks::Edit>& edits);
    /// Path of the sidecar; empty: none.
    [[nodiscard]] const std::string& path() const { return path_; }

    /// Edits wait that could not be written.
    [[nodiscard]] bool failing() const { return failing_; }

signals:
    /// After follow(), if there was a file.
    void found(const edgescan::rocks::Preset& preset);
    /// After follow() and a possible found().
    void readEnded();
    /// Another window had changed the file: `theirs`, which has all changes, was written in place of `mine`.
    void merged(const edgescan::rocks::Preset& mine, const edgescan::rocks::Preset& theirs);
    /// A sentence: the sidecar cannot be read or written.
    void failed(const QString& sentence);

private:
    struct Writing {
        std::uint64_t number = 0; ///< later ones are larger
        std::string path;
        std::shared_ptr<const Scan> scan;
        rocks::Preset preset; ///< without edits and region: the file is deleted
    };
    class Disk; ///< writes the newest content, whichever thread comes first
    void writeNow();
    void writeInBackground();

    std::shared_ptr<const Scan> scan_;
    std::string path_;
    bool ours_ = false; // the file was written by this object, or read by it
    bool reading_ = false;
    std::uint64_t number_ = 0; // of follow()
    std::optional<Writing> waiting_;
    bool writing_ = false;
    bool failing_ = false; // the last writing failed
    std::uint64_t writings_ = 0;
    std::shared_ptr<Disk> disk_;
    QTimer soon_;
};

} // namespace edgescan::ui
