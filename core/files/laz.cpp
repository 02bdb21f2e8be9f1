// LAZ points.
#include "core/files/laz.h"

namespace edgescan {

Result<std::vector<Eigen::Vector3d>> readLazPoints(const Source& source) {
    return source.refused("this LAS file is compressed (LAZ), and this build of the program was made without LASzip",
                          "save it uncompressed as .las");
}

} // namespace edgescan
