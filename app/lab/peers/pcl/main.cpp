// edgescan-peers BYTES SECONDS: runs one detector of PCL on one scan, for runPeer(). Request on standard input, answer on standard output.
// BYTES limits its memory, SECONDS its CPU time (0 = no limit).
#include "app/lab/peers/pcl/points.h"
#include "app/lab/peers/peer_messages.h"

#include <pcl/console/print.h>

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>

namespace edgescan::lab {
namespace {

void limit(int what, const char* most) {
    const rlim_t value = std::strtoull(most, nullptr, 10);
    if (value == 0) return;
    const rlimit both{value, value};
    setrlimit(static_cast<__rlimit_resource>(what), &both);
}

// OrganizedEdgeFromNormals averages normals over windows of 10 cells and computes "height - 10" in an unsigned type.
int fewestCells(PclMethod peer) { return peer == PclMethod::OrganizedEdge || peer == PclMethod::OrganizedEdgeUnrolled ? kNormalWindow : 8; }

// If there is no answer, runPeer() reports that the memory was not enough. PCL's threads and Eigen end the process in different places.
[[noreturn]] void outOfMemory() { _exit(EXIT_FAILURE); }

void ended() {
    try {
        if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        outOfMemory();
    } catch (...) {
        std::abort();
    }
    std::abort();
}

Result<PclEdges> answer(const PclRequest& request) {
    const PclScan& scan = request.scan;
    const auto points = std::ranges::count_if(scan.pointsM.cells, [](const Eigen::Vector3f& p) { return p.allFinite(); });
    const int fewest = fewestCells(request.peer);
    if (points < 100 || scan.pointsM.lines < fewest || scan.pointsM.beams < fewest) {
        const std::string side = std::to_string(fewest);
        return Error{"PCL needs a grid of " + side + " x " + side + " cells and 100 points at least", pclMethodName(request.peer),
                     "choose a larger scan"};
    }
    try {
        switch (request.peer) {
        case PclMethod::BoundaryNeighbours:
            return boundaryEstimation(scan, request.limits, false);
        case PclMethod::BoundaryRadius:
            return boundaryEstimation(scan, request.limits, true);
        case PclMethod::RangeImageBorder:
            return rangeImageBorders(scan);
        case PclMethod::OrganizedEdge:
            return organizedEdges(scan, false);
        case PclMethod::OrganizedEdgeUnrolled:
            return organizedEdges(scan, true);
        case PclMethod::RegionGrowing:
            return grownRegions(scan);
        case PclMethod::ConvexPatches:
            return convexPatches(scan);
        }
    } catch (const std::bad_alloc&) {
        outOfMemory();
    } catch (const std::exception& error) {
        return Error{std::string("PCL gave up (") + error.what() + ")", pclMethodName(request.peer), "leave this peer out"};
    }
    return Error{"there is no such peer", std::to_string(static_cast<int>(request.peer)), "build the project again"};
}

} // namespace
} // namespace edgescan::lab

int main(int count, char** arguments) {
    using namespace edgescan::lab;
    if (count != 3) return EXIT_FAILURE;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_AS, arguments[1]);
    limit(RLIMIT_CPU, arguments[2]);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    std::set_new_handler(outOfMemory);
    std::set_terminate(ended);
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // PCL would warn that a sweep is not a camera image
    const std::optional<PclRequest> request = readRequest(readAll(STDIN_FILENO));
    if (!request) return EXIT_FAILURE;
    return writeAll(STDOUT_FILENO, answerBytes(answer(*request))) ? EXIT_SUCCESS : EXIT_FAILURE;
}
