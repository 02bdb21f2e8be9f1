// Proposals: each one gives, with the method itself, the result that it announces.
#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/tuning/marked_edges.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace edgescan::edges {
namespace {

bool isEdgeNear(const Grid<std::uint8_t>& mask, std::uint32_t k) {
    const int line = static_cast<int>(k) / mask.beams, beam = static_cast<int>(k) % mask.beams;
    for (int i = line - kMarkReachCells; i <= line + kMarkReachCells; ++i) {
        for (int j = beam - kMarkReachCells; j <= beam + kMarkReachCells; ++j) {
            if (mask.contains(i, j) && mask.at(i, j) != 0) return true;
        }
    }
    return false;
}

std::shared_ptr<const Scan> bell() {
    sim::SimulationSettings settings;
    settings.lines = 150;
    settings.beams = 190;
    return std::make_shared<const Scan>(sim::simulate(settings)->scan);
}

/// A run with the proposed settings gives what the proposal counts.
void expectTrue(const std::shared_ptr<const Scan>& scan, const EdgeProposal& proposal, const EdgeMarks& marks) {
    const auto detection = detectEdges(scan, proposal.settings);
    int kept = 0, leftOut = 0;
    for (const std::uint32_t k : marks.wanted) kept += isEdgeNear(*detection->mask, k) ? 1 : 0;
    for (const std::uint32_t k : marks.unwanted) leftOut += isEdgeNear(*detection->mask, k) ? 0 : 1;
    const std::string text = proposalText(proposal, marks);
    EXPECT_EQ(kept, proposal.wantedMet) << text;
    EXPECT_EQ(leftOut, proposal.unwantedMet) << text;
    EXPECT_EQ(detection->edges->size(), proposal.edges) << text;
    EXPECT_EQ(proposal.meetsAllMarks(), kept + leftOut == static_cast<int>(marks.wanted.size() + marks.unwanted.size())) << text;
}

TEST(MarkedEdges, ProposalsDoWhatTheySay) {
    const auto scan = bell();
    const auto usual = detectEdges(scan, {});
    Settings loose;
    loose.sensitivity = 0.4;
    const auto more = detectEdges(scan, loose);
    // Wanted: edges of the default settings. Unwanted: edges that only a low threshold finds, away from the others.
    EdgeMarks marks;
    for (std::size_t n = 100; n < usual->edges->size() && marks.wanted.size() < 4; n += usual->edges->size() / 5)
        marks.wanted.push_back((*usual->edges)[n]);
    for (const std::uint32_t k : *more->edges) {
        if (marks.unwanted.size() < 3 && !isEdgeNear(*usual->mask, k) && k % 7 == 0) marks.unwanted.push_back(k);
    }
    ASSERT_EQ(marks.wanted.size(), 4U);
    ASSERT_EQ(marks.unwanted.size(), 3U);
    const auto proposals = edgeProposals(scan, loose, marks);
    ASSERT_GE(proposals.size(), 10U);
    for (const EdgeProposal& proposal : proposals) expectTrue(scan, proposal, marks);
    EXPECT_TRUE(proposals.front().meetsAllMarks());
    for (std::size_t n = 1; n < proposals.size(); ++n) {
        EXPECT_GE(proposals[n - 1].meetsAllMarks(), proposals[n].meetsAllMarks());
        if (proposals[n - 1].meetsAllMarks() && proposals[n].meetsAllMarks()) {
            EXPECT_GE(proposals[n - 1].margin, proposals[n].margin);
        }
    }
    const auto ours = std::ranges::find(proposals, Method::EdgeScanPlus, [](const EdgeProposal& p) { return p.settings.method; });
    EXPECT_TRUE(ours->meetsAllMarks());
    EXPECT_GT(ours->settings.sensitivity, loose.sensitivity);
}

TEST(MarkedEdges, WhatNothingSeparatesIsSaid) {
    const auto scan = bell();
    const auto usual = detectEdges(scan, {});
    const std::uint32_t edge = (*usual->edges)[usual->edges->size() / 2];
    const EdgeMarks marks{{edge}, {edge}}; // the same place marked both ways
    const auto proposals = edgeProposals(scan, {}, marks);
    for (const EdgeProposal& proposal : proposals) {
        EXPECT_FALSE(proposal.meetsAllMarks());
        expectTrue(scan, proposal, marks);
    }
    EXPECT_NE(proposalText(proposals.front(), marks).find(" of 2 marks"), std::string::npos);
    EXPECT_TRUE(edgeProposals(scan, {}, {}).empty());
    EXPECT_TRUE(edgeProposals(scan, {}, marks, [] { return false; }).empty());
    for (const EdgeProposal& proposal : edgeProposals(scan, {}, {{edge, 4000000000U}, {}})) expectTrue(scan, proposal, {{edge}, {}});
}

} // namespace
} // namespace edgescan::edges
