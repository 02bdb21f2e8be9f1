// Opens a scan with everything that was asked for on opening it.
#include "core/files/open_save/open_as_asked.h"

#include "core/scan/angle_correction/straighten_scan.h"

namespace edgescan::files {

Result<Scan> openAsAsked(const std::filesystem::path& path, const ReadingOptions& options) {
    auto scan = openScan(path, options);
    if (!scan) return scan;
    return withinMemory(path, [&]() -> Result<Scan> {
        if (options.straighten) {
            Scan straight = straightened(std::move(*scan));
            straight.openedWith = readingOptionsText(options);
            return straight;
        }
        if (auto warning = displacementWarning(*scan)) scan->warnings.push_back(std::move(*warning));
        return std::move(scan); // it is not this function's own: else all cells were copied
    });
}

} // namespace edgescan::files
