// What was taken for granted when a scan was opened, what speaks against it, and how else it can be read.
#pragma once

#include "core/files/addons/addon.h"
#include "core/files/plausibility/sentence.h"
#include "core/scan/grid/reading_options.h"

#include <string_view>
#include <vector>

namespace edgescan::files {

/// The scan read in another way.
struct OtherReading {
    Sentence words; ///< "sweep instead of spin: 41 of 96 pieces would be flat instead of 6"
    ReadingOptions options;
};

/// One thing that a reader has to know.
struct OpeningPoint {
    enum class Source {
        Stated,  ///< by the file
        Typed,   ///< by the person who opened it
        Guessed, ///< found out from the numbers
        Assumed, ///< taken as usual: the file does not say it
    };
    const char* what; ///< "Unit", "Mounting", ...
    Source source = Source::Stated;
    Sentence taken{};                   ///< what it was taken as, in words
    Sentence against{};                 ///< what the scan says against it, one sentence; empty: nothing
    std::vector<OtherReading> others{}; ///< the likelier first; may be empty
};

/// Unit, mounting, angles, order of the lines, grid, and lines out of place, in this order, where they can be otherwise. `options` are
/// those that the scan was opened with. A file that has to be opened for it is not touched: everything comes from the scan. Well below a
/// second.
[[nodiscard]] std::vector<OpeningPoint> openingCheck(const Scan& scan, const ReadingOptions& options);

/// Topic, sweep, and the source of the angles of the lines, where `scan` comes from the bag with this list.
[[nodiscard]] std::vector<OpeningPoint> bagCheck(const BagListing& listing, const Scan& scan, const ReadingOptions& options);

/// The point about beams and lines out of place.
inline constexpr std::string_view kDisplacedPoint = "Beams and lines";

/// Something speaks against one of them.
[[nodiscard]] bool looksWrong(const std::vector<OpeningPoint>& points);
/// One of them was found out or assumed rather than said.
[[nodiscard]] bool looksGuessed(const std::vector<OpeningPoint>& points);

} // namespace edgescan::files
