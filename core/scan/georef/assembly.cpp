// Converts the assembly errors to the terms of a calibration file.
#include "core/scan/georef/assembly.h"

#include "core/scan/georef/chain.h"

namespace edgescan {
namespace {

using Eigen::Vector3d;

Vector3d mountRpyDeg(Axis axis, const AssemblyErrors& errors) {
    return axis == Axis::Spin ? Vector3d(errors.tiltDeg(), errors.indexDeg(), 0) : Vector3d(0, errors.indexDeg(), errors.tiltDeg());
}

Vector3d mountM(Axis axis, const AssemblyErrors& errors) {
    const double t1 = errors.t1Mm() / 1000.0;
    const double t2 = errors.t2Mm() / 1000.0;
    return axis == Axis::Spin ? Vector3d(t1, t2, 0) : Vector3d(0, t1, t2);
}

} // namespace

RigidTransform sensorInMover(Axis axis, const AssemblyErrors& errors) {
    return moverFromSensor(mountRpyDeg(axis, errors), mountM(axis, errors));
}

Calibration withAssembly(Calibration calibration, Axis axis, const AssemblyErrors& errors) {
    calibration.mountRpyDeg = mountRpyDeg(axis, errors);
    calibration.mountM = mountM(axis, errors);
    calibration.degPerStep *= errors.turnFactor();
    calibration.axis = axis == Axis::Spin ? Vector3d::UnitZ() : Vector3d::UnitX();
    return calibration;
}

} // namespace edgescan
