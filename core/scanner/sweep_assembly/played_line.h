// A line of a recording or a bag that is played.
#pragma once

#include "core/scanner/sweep_assembly/sweep_assembler.h"

namespace edgescan::scanner {

struct PlayedLine {
    int line = 0;            ///< over the whole recording, from 0
    std::int64_t timeNs = 0; ///< when it was received
    std::int64_t nextNs = 0; ///< the same of the next line; 0: it is the last one
    SweepProgress progress;  ///< with this line
};

} // namespace edgescan::scanner
