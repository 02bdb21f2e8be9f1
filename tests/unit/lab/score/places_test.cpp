// Where detections are, as distances and as offsets across the edge.
#include "app/lab/score/places.h"

#include <gtest/gtest.h>

namespace edgescan::lab {
namespace {

constexpr int kLines = 30, kBeams = 40, kEdge = 20;

// A plate 3 m away ends at one beam, or at one line; behind it is a wall 5 m away.
sim::TruthSet plate(bool alongLines) {
    sim::TruthSet truth{{Grid<std::uint8_t>(kLines, kBeams), Grid<std::uint8_t>(kLines, kBeams)}, {}, Grid<std::uint16_t>(kLines, kBeams)};
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) {
            const int n = alongLines ? j : i;
            truth.cleanMm.at(i, j) = n <= kEdge ? 3000 : 5000;
            if (n == kEdge) truth.edges.edgeClass.at(i, j) = static_cast<std::uint8_t>(sim::EdgeClass::Occluding);
        }
    }
    return truth;
}

Grid<std::uint8_t> lineAt(bool alongLines, int n) {
    Grid<std::uint8_t> mask(kLines, kBeams);
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) mask.at(i, j) = (alongLines ? j : i) == n ? 255 : 0;
    }
    return mask;
}

TEST(EdgePlaces, DistanceAndSideOfTheNearestDetection) {
    for (const bool alongLines : {false, true}) {
        const sim::TruthSet truth = plate(alongLines);
        for (int off = -4; off <= 4; ++off) {
            const PlacesByClass places = edgePlaces(lineAt(alongLines, kEdge + off), truth);
            const EdgePlaces& place = places.at(static_cast<std::size_t>(sim::EdgeClass::Occluding));
            EXPECT_EQ(place.truth, static_cast<std::size_t>(alongLines ? kLines : kBeams));
            for (std::size_t n = 0; n < kPlaceDistances.size(); ++n)
                EXPECT_EQ(place.share(n), std::abs(off) <= kPlaceDistances[n] ? 1.0 : 0.0) << off << " " << n;
            if (std::abs(off) <= kPlaceDistances.back()) {
                EXPECT_NEAR(place.offset(), off, 1e-9) << alongLines;
            } else {
                EXPECT_EQ(place.measured, 0U);
            }
        }
    }
}

TEST(EdgePlaces, CellsThatAreNotScoredAndScansAddUp) {
    sim::TruthSet truth = plate(true);
    for (int i = 0; i < 10; ++i) truth.edges.ignore.at(i, kEdge) = 255;
    const EdgePlaces one = allPlaces(edgePlaces(lineAt(true, kEdge + 1), truth)), none = allPlaces(edgePlaces(lineAt(true, 0), truth));
    EXPECT_EQ(one.truth, static_cast<std::size_t>(kLines - 10));
    EdgePlaces both = one;
    both += none;
    EXPECT_EQ(both.truth, 2 * one.truth);
    EXPECT_EQ(both.share(0), 0.5);
    EXPECT_NEAR(both.offset(), 1.0, 1e-9) << "only of those that were found";
    truth.cleanMm = {};
    EXPECT_EQ(allPlaces(edgePlaces(lineAt(true, kEdge), truth)).measured, 0U);
    EXPECT_EQ(EdgePlaces{}.share(0), 1.0);
}

} // namespace
} // namespace edgescan::lab
