// The settings and edits of rocks in a file beside the scan, so that they are there when it is opened again.
#pragma once

#include "core/rocks/selection/preset.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::ui {

/// GUI thread only; files are read and written on threads of their own.
class RocksBeside : public QObject {
    Q_OBJECT
public:
    explicit RocksBeside(QObject* parent = nullptr);
    ~RocksBeside() override;

    /// From now on it is about this scan; what is still to be written of the one before is written. Null, or a scan that grows: about none.
    void follow(std::shared_ptr<const Scan> scan);
    /// follow() has not answered yet.
    [[nodiscard]] bool reading() const { return reading_; }
    /// To be written soon; without edits and region the file goes away.
    void keep(const RockSettings& settings, const std::vector<RockEdit>& edits);
    /// Where they are kept; empty: nowhere.
    [[nodiscard]] const std::string& path() const { return path_; }

signals:
    /// After follow(), where there was a file.
    void found(const edgescan::RockPreset& preset);
    /// After follow(): found() was before, or there is nothing.
    void readEnded();
    /// A sentence: what is beside the scan cannot be read or written.
    void failed(const QString& sentence);

private:
    struct Writing {
        std::uint64_t number = 0; ///< later ones are larger
        std::string path, text;   ///< empty text: the file goes away
    };
    class Disk; ///< writes what is newest, whichever thread comes first
    void writeNow();
    void writeInBackground();

    std::shared_ptr<const Scan> scan_;
    std::string path_;
    bool ours_ = false; // what stands there was written here, or read
    bool reading_ = false;
    std::uint64_t number_ = 0; // of follow()
    std::optional<Writing> waiting_;
    bool writing_ = false;
    std::uint64_t writings_ = 0;
    std::shared_ptr<Disk> disk_;
    QTimer soon_;
};

} // namespace edgescan::ui
