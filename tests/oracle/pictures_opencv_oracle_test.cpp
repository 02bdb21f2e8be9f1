// OpenCV reads the pictures that EdgeScan writes, and EdgeScan reads those of OpenCV.
#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/provenance.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/range_image.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

using namespace edgescan;
using namespace edgescan::test;

namespace {

std::shared_ptr<const edges::Detection> detectionOf(unsigned seed) {
    Scan scan = makeScan({.lines = 37, .beams = 53, .noReturns = 0.2, .seed = seed});
    return edges::detectEdges(std::make_shared<const Scan>(std::move(scan)), edges::Settings{});
}

/// The angles, which a picture does not contain.
ReadingOptions angles() {
    ReadingOptions options;
    options.beamStartDeg = 0;
    options.beamStepDeg = 0.5;
    options.lineStartDeg = 30;
    options.lineStepDeg = -0.5;
    options.axis = Axis::Sweep;
    return options;
}

} // namespace

TEST(OpenCvOracle, ReadsOurMaskGrayAndRanges) {
    const Folder folder;
    const auto detection = detectionOf(3);
    ASSERT_GT(detection->edges->size(), 0U);
    ASSERT_TRUE(exports::exportWithProvenance(exports::ExportContent::EdgeImage, *detection, folder / "mask.png"));
    ASSERT_TRUE(exports::exportWithProvenance(exports::ExportContent::GrayImage, *detection, folder / "gray.png"));
    ASSERT_TRUE(exports::exportWithProvenance(exports::ExportContent::RangeImage, *detection, folder / "range.png"));
    const cv::Mat mask = cv::imread((folder / "mask.png").string(), cv::IMREAD_UNCHANGED);
    const cv::Mat gray = cv::imread((folder / "gray.png").string(), cv::IMREAD_UNCHANGED);
    const cv::Mat range = cv::imread((folder / "range.png").string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(mask.type(), CV_8UC1);
    ASSERT_EQ(gray.type(), CV_8UC1);
    ASSERT_EQ(range.type(), CV_16UC1);
    for (const cv::Mat& picture : {mask, gray, range}) {
        ASSERT_EQ(picture.rows, 37);
        ASSERT_EQ(picture.cols, 53);
    }
    const auto expected = rangePicture(*detection->scan);
    for (int line = 0; line < 37; ++line) {
        for (int beam = 0; beam < 53; ++beam) {
            EXPECT_EQ(mask.at<std::uint8_t>(line, beam), detection->mask->at(line, beam));
            EXPECT_EQ(gray.at<std::uint8_t>(line, beam), detection->gray->levels.at(line, beam));
            EXPECT_EQ(range.at<std::uint16_t>(line, beam), expected.at(line, beam));
        }
    }
}

TEST(OpenCvOracle, WeReadItsRangePicturesAndMasks) {
    const Folder folder;
    const auto detection = detectionOf(5);
    const Scan& scan = *detection->scan;
    cv::Mat whole(scan.lines(), scan.beams(), CV_16U), broken(scan.lines(), scan.beams(), CV_32F);
    for (int line = 0; line < scan.lines(); ++line) {
        for (int beam = 0; beam < scan.beams(); ++beam) {
            const float mm = scan.state.at(line, beam) == CellState::Valid ? scan.rangeMm.at(line, beam) : 0.0F;
            whole.at<std::uint16_t>(line, beam) = static_cast<std::uint16_t>(mm);
            broken.at<float>(line, beam) = mm > 0 ? mm + 0.25F : mm;
        }
    }
    for (const auto& [name, picture, more] :
         {std::tuple("cv.png", &whole, 0.0F), std::tuple("cv.tiff", &whole, 0.0F), std::tuple("float.tiff", &broken, 0.25F)}) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(cv::imwrite((folder / name).string(), *picture));
        const auto opened = files::openScan(folder / name, angles());
        ASSERT_TRUE(opened) << opened.error().sentence();
        EXPECT_EQ(opened->state, scan.state);
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] != CellState::Valid) continue;
            EXPECT_EQ(opened->rangeMm[k], scan.rangeMm[k] + more);
        }
    }
    const cv::Mat mask(detection->mask->lines, detection->mask->beams, CV_8U, const_cast<std::uint8_t*>(detection->mask->cells.data()));
    ASSERT_TRUE(cv::imwrite((folder / "mask.png").string(), mask));
    EXPECT_EQ(*containers::readPng8(folder / "mask.png"), *detection->mask);
}

TEST(OpenCvOracle, ReadsOurColours) {
    const Folder folder;
    Grid<Rgb> picture(5, 7);
    for (std::size_t k = 0; k < picture.size(); ++k)
        picture[k] = {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(255 - k), static_cast<std::uint8_t>(7 * k)};
    ASSERT_TRUE(containers::savePngRgb(picture, folder / "colours.png"));
    const cv::Mat read = cv::imread((folder / "colours.png").string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.type(), CV_8UC3);
    ASSERT_EQ(read.rows, 5);
    ASSERT_EQ(read.cols, 7);
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 7; ++j) {
            const auto& pixel = read.at<cv::Vec3b>(i, j); // blue first
            EXPECT_EQ(picture.at(i, j), (Rgb{pixel[2], pixel[1], pixel[0]}));
        }
    }
    EXPECT_FALSE(containers::savePngRgb({}, folder / "empty.png"));
}
