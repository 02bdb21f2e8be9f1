// The angles of ranges that come without any: tables of text and pictures.
#pragma once

#include "core/points/source.h"

namespace edgescan {

struct AssumedAngles {
    PolarGeometry polar;
    std::string warning; ///< empty when the user gave all of them
};

/// Angles from the options; where they give none those of an LMS511, if there are as many beams as it has (1141). `what` names what
/// holds the ranges ("table", "picture"). Error: the options that are needed.
Result<AssumedAngles> assumedAngles(std::size_t lines, std::size_t beams, const char* what, const Source& source);

/// Error when a sweep of so many lines and columns has no angles, before anything is read.
Result<Done> checkAnglesKnown(std::size_t beams, const char* what, const Source& source);

} // namespace edgescan
