// The values of a pose and of a mounting as the texts of a form. The files are their only authority: each text is checked by reading a file
// that holds it.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// One row of a form, and the key under which its value is stored.
struct PlaceField {
    enum class Kind : std::uint8_t { Number, ThreeNumbers, NineNumbers, Word, Text };

    const char* group; ///< object of the file; empty: the file itself
    const char* key;
    const char* label;
    Kind kind;
    const char* usual;                   ///< value of an empty text; null: a value is needed
    std::vector<std::string> words = {}; ///< the allowed values of a Word
};

/// Of a pose file with one reading of each sensor.
[[nodiscard]] std::span<const PlaceField> poseFields();
/// Of a calibration file.
[[nodiscard]] std::span<const PlaceField> mountingFields();

/// One text per field.
using PlaceTexts = std::vector<std::string>;

/// The texts of a file's values; empty where the file has none. Of several readings the first one. Error: damaged text.
Result<PlaceTexts> placeTexts(std::span<const PlaceField> fields, std::string_view json, const std::string& where);

/// The calibration that is part of a pose file, as text; empty if the file holds none.
[[nodiscard]] std::string calibrationInPose(std::string_view json);

/// A mounting without errors for a scan of this axis. Its tilt is read as pitch and roll. It looks up, as every scan without a pose is
/// shown: a level pose does not turn the cloud over.
[[nodiscard]] PlaceTexts nominalMounting(Axis axis);

/// Typed texts, and the file that they began with (may be empty): its other keys stay.
struct TypedFile {
    PlaceTexts texts;
    std::string base = {};
};

struct TypedPlace {
    std::string file;                   ///< a whole pose file that holds its calibration; empty if a text is wrong
    PlaceTexts poseFaults, mountFaults; ///< one sentence per field; empty: the text is right
    std::string fault;                  ///< a sentence about several fields
    [[nodiscard]] bool isSound() const { return !file.empty(); }
};
[[nodiscard]] TypedPlace typedPlace(const TypedFile& pose, const TypedFile& mounting);

/// A calibration file of these texts. Error: the first wrong text.
Result<std::string> typedMounting(const TypedFile& mounting);

} // namespace edgescan
