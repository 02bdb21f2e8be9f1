// Scans for the peers, and loading the module with PCL inside.
#include "core/compare/peers.h"

#include "core/scan/cartesian.h"
#include "core/scan/inverse_range.h"

#include <dlfcn.h>

#include <filesystem>
#include <limits>

namespace edgescan {
namespace {

constexpr const char* kFile = "edgescan_peers.so";
constexpr const char* kEntry = "edgescanPeers";

} // namespace

const char* peerName(Peer peer) {
    static constexpr const char* kNames[]{"PCL BoundaryEstimation k=30", "PCL BoundaryEstimation radius", "PCL RangeImageBorderExtractor",
                                          "PCL OrganizedEdgeFromNormals", "PCL OrganizedEdge, un-rolled"};
    return kNames[static_cast<std::size_t>(peer)];
}

PeerScan peerScan(const Scan& scan) {
    const Eigen::Vector3f nowhere = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    const CartesianTables tables(scan);
    const AngularSteps steps = angularSteps(scan);
    PeerScan result{Grid<Eigen::Vector3f>(scan.lines(), scan.beams(), nowhere), Grid<Eigen::Vector3f>(scan.lines(), scan.beams(), nowhere),
                    Grid<Eigen::Vector3f>(scan.lines(), scan.beams(), nowhere)};
    std::vector<float> across(static_cast<std::size_t>(scan.beams()));
    for (std::size_t j = 1; j < across.size(); ++j) across[j] = across[j - 1] + steps.beam[j];
    const float middle = across.empty() ? 0.0F : across[across.size() / 2];
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            const std::size_t k = scan.rangeMm.index(i, j);
            result.directions[k] = tables.direction(i, j).cast<float>();
            if (scan.state[k] != CellState::Valid) continue;
            result.pointsM[k] = (tables.point(k) - tables.sensor()).cast<float>();
            const float range = scan.rangeMm[k] * 0.001F;
            const float down = static_cast<float>(i - scan.lines() / 2) * steps.lineAt(i, j);
            result.unrolledM[k] = {(across[static_cast<std::size_t>(j)] - middle) * range, down * range, range};
        }
    }
    return result;
}

Result<const PeerModule*> loadPeers() {
    static const PeerModule* loaded = nullptr;
    if (loaded != nullptr) return loaded;
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
    for (const auto& path : {folder / kFile, folder / ".." / "lib" / "edgescan" / kFile}) {
        if (!std::filesystem::exists(path, failed)) continue;
        void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL); // stays for the life of the program
        if (module == nullptr)
            return Error{std::string("the PCL module cannot be loaded (") + dlerror() + ")", path.string(), "install PCL"};
        const auto entry = reinterpret_cast<const PeerModule* (*)()>(dlsym(module, kEntry));
        if (entry == nullptr) return Error{"this is not the PCL module of this program", path.string(), "build the project again"};
        return loaded = entry();
    }
    return Error{"there is no PCL module, so the PCL peers are left out", (folder / kFile).string(), "install libpcl-dev and build again"};
}

} // namespace edgescan
