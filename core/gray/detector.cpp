// Every detector of the thesis's chapter 3, by its method.
#include "core/gray/detector.h"

#include "core/gray/gradient_masks.h"
#include "core/gray/zero_crossings.h"

#include <cmath>

namespace edgescan {

Grid<float> detectorResponse(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings) {
    switch (method) {
    case Method::Roberts:
        return robertsResponse(levels, missing, settings.norm);
    case Method::Sobel:
        return sobelResponse(levels, missing, settings.norm);
    case Method::Prewitt:
        return prewittResponse(levels, missing, settings.norm);
    case Method::Kirsch:
        return kirschResponse(levels, missing);
    case Method::Robinson:
        return robinsonResponse(levels, missing);
    case Method::MarrHildreth: {
        const double sigma = std::isnan(settings.sigma) ? kMarrHildrethSigma : settings.sigma;
        return zeroCrossingSlope(laplacianOfGaussian(levels, missing, sigma), missing);
    }
    case Method::Log:
        return zeroCrossingSlope(laplacian(levels, missing, settings.logMask), missing);
    default:
        return {levels.lines, levels.beams};
    }
}

Grid<std::uint8_t> beyondThreshold(const Grid<float>& response, double threshold) {
    Grid<std::uint8_t> mask(response.lines, response.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = static_cast<double>(response[k]) > threshold ? 255 : 0;
    return mask;
}

Grid<std::uint8_t> detectorMask(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing,
                                const Settings& settings) {
    return beyondThreshold(detectorResponse(method, levels, missing, settings), settings.lower);
}

} // namespace edgescan
