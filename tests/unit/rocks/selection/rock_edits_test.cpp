// Edits stay valid after changes of settings, and a faulty file of edits gives an error sentence.
#include "core/rocks/attributes/study.h"
#include "core/rocks/attributes/why_border.h"
#include "core/rocks/selection/preset.h"
#include "core/rocks/selection/region_changes.h"
#include "core/rocks/selection/region_of_interest.h"
#include "core/rocks/selection/strokes.h"
#include "tests/support/rock_scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace edgescan::rocks {
namespace {

const Inputs& sceneInputs() {
    static const Inputs inputs =
        rockInputs(*edges::detectEdges(test::rockScene("hangup", 815, 300, 343).scan, edges::Settings{}, edges::KeepFor::Rocks));
    return inputs;
}
const Study& plain() {
    static const Study study = studyRocks(sceneInputs(), {});
    return study;
}
std::uint32_t regionAt(const Study& study, std::uint32_t k) { return study.map.regionOfSegment[study.segmentation->segment[k]]; }
RockSettings levelled(double level) {
    RockSettings settings;
    settings.level = level;
    return settings;
}

// Two rocks that touch each other, each given by one of its cells.
std::pair<std::uint32_t, std::uint32_t> neighbours() {
    for (const Rock& rock : plain().rocks) {
        if (!rock.contacts.empty()) return {rock.cell, plain().rocks[rock.contacts.front() - 1].cell};
    }
    return {0, 0};
}

TEST(RockStudy, RowsAreTheSameWithWhatWasMeasuredBefore) {
    std::size_t kept = 0;
    const Study* before = &plain();
    std::vector<Study> studies(9);
    for (int n = 0; n < 9; ++n) {
        const double level = n - 4.0;
        studies[static_cast<std::size_t>(n)] = studyRocks(sceneInputs(), levelled(level), {}, before);
        const Study& study = studies[static_cast<std::size_t>(n)];
        const Study fresh = studyRocks(sceneInputs(), levelled(level));
        ASSERT_EQ(study.rocks.size(), fresh.rocks.size()) << level;
        EXPECT_TRUE(study.rocks == fresh.rocks) << level;
        for (const Rock& rock : study.rocks) {
            for (const Rock& old : before->rocks) kept += rock.cells == old.cells && rock.cell == old.cell ? 1 : 0;
        }
        before = &study;
    }
    EXPECT_GT(kept, 10U) << "nothing was there before";
}

TEST(RockEdits, WhatIsJoinedStaysOneAtEveryLevel) {
    const auto [p, q] = neighbours();
    ASSERT_NE(regionAt(plain(), p), regionAt(plain(), q));
    const std::vector<Edit> edits{{EditKind::Join, {p, q}}};
    for (const double level : {-4.0, 0.0, 3.0}) {
        const Study study = studyRocks(sceneInputs(), levelled(level), edits, &plain());
        EXPECT_EQ(regionAt(study, p), regionAt(study, q));
        EXPECT_TRUE(whyTwoRocks(study, p, q).alwaysOne);
    }
}

TEST(RockEdits, WhatIsPartedStaysTwoAtEveryLevelAndAfterTurningTheMethod) {
    const auto [p, q] = neighbours();
    const std::vector<Edit> edits{{EditKind::Part, {p, q}}};
    ASSERT_EQ(regionAt(studyRocks(sceneInputs(), levelled(4), {{EditKind::Join, {p, q}}}), p),
              regionAt(studyRocks(sceneInputs(), levelled(4), {{EditKind::Join, {p, q}}}), q));
    edges::Settings turned;
    turned.jumpMm = 60;
    const Inputs other = rockInputs(*edges::detectEdges(sceneInputs().scan, turned, edges::KeepFor::Rocks));
    for (const double level : {-4.0, 0.0, 4.0}) {
        EXPECT_NE(regionAt(studyRocks(sceneInputs(), levelled(level), edits), p),
                  regionAt(studyRocks(sceneInputs(), levelled(level), edits), q));
        const Study study = studyRocks(other, levelled(level), edits);
        if (study.segmentation->segment[p] != study.segmentation->segment[q]) {
            EXPECT_NE(regionAt(study, p), regionAt(study, q));
        }
    }
}

TEST(RockEdits, AClickSplitsARockInTwoAndTheWheelGoesUpThroughItsAncestors) {
    int split = 0;
    for (const Rock& rock : plain().rocks) {
        const WheelPieces family = wheelPiecesAt(*plain().segmentation, *plain().tree, 0, rock.cell, {});
        const auto& pieces = family.nested.pieces;
        for (std::size_t n = 1; n < pieces.size(); ++n) EXPECT_TRUE(std::ranges::includes(pieces[n].segments, pieces[n - 1].segments));
        ASSERT_LT(family.nested.region, pieces.size());
        EXPECT_TRUE(pieces[family.nested.region].edit.cells.empty());
        EXPECT_EQ(pieces[family.nested.region].cells, rock.cells);
        const auto edit = splitAt(*plain().segmentation, *plain().tree, 0, rock.cell);
        if (!edit) continue;
        ASSERT_EQ(edit->kind, EditKind::Part);
        const Study study = studyRocks(sceneInputs(), {}, {*edit}, &plain());
        EXPECT_EQ(study.segmentation, plain().segmentation);
        EXPECT_EQ(regionAt(plain(), edit->cells[0]), regionAt(plain(), edit->cells[1]));
        EXPECT_NE(regionAt(study, edit->cells[0]), regionAt(study, edit->cells[1]));
        if (++split == 5) break;
    }
    EXPECT_EQ(split, 5);
}

TEST(RockEdits, AStrokeCutsAPieceInTwo) {
    // Through the middle of the largest rock, along the beams.
    const Rock& rock = plain().rocks.front();
    const auto beams = static_cast<std::uint32_t>(sceneInputs().scan->beams());
    const Grid<std::uint32_t> labels = rockLabels(*plain().segmentation, plain().map);
    const std::uint32_t line = rock.cell / beams;
    std::uint32_t least = beams, most = 0;
    for (std::uint32_t j = 0; j < beams; ++j) {
        if (labels.at(static_cast<int>(line), static_cast<int>(j)) != rock.label) continue;
        least = std::min(least, j);
        most = std::max(most, j);
    }
    ASSERT_LT(least + 10, most);
    const std::vector<Edit> edits{{EditKind::Cut, {line * beams + least - 2, line * beams + most + 2}}};
    const std::uint32_t above = rock.cell - 4 * beams;
    const std::uint32_t below = rock.cell + 4 * beams;
    ASSERT_EQ(regionAt(plain(), above), regionAt(plain(), below));
    for (const double level : {0.0, 4.0}) {
        const Study study = studyRocks(sceneInputs(), levelled(level), edits);
        EXPECT_NE(regionAt(study, above), regionAt(study, below)) << level;
    }
    // After undo, everything is as before.
    const Study cut = studyRocks(sceneInputs(), {}, edits);
    EXPECT_EQ(rockLabels(*studyRocks(sceneInputs(), {}, {}, &cut).segmentation, studyRocks(sceneInputs(), {}, {}, &cut).map), labels);
}

TEST(RockEdits, TheSameEditsGiveTheSameLabelsWhateverWasThereBefore) {
    const auto [p, q] = neighbours();
    const std::vector<Edit> edits{{EditKind::Join, {p, q}}, {EditKind::Cut, {p, q}}, {EditKind::NotRock, {plain().rocks[2].cell}}};
    const Study fresh = studyRocks(sceneInputs(), levelled(1), edits);
    Study step = studyRocks(sceneInputs(), levelled(-2));
    for (std::size_t n = 1; n <= edits.size(); ++n)
        step = studyRocks(sceneInputs(), levelled(n == edits.size() ? 1 : 0),
                          {edits.begin(), edits.begin() + static_cast<std::ptrdiff_t>(n)}, &step);
    EXPECT_EQ(rockLabels(*fresh.segmentation, fresh.map), rockLabels(*step.segmentation, step.map));
}

TEST(RockEdits, WhatIsCalledARockIsOne) {
    const Study not_ = studyRocks(sceneInputs(), {}, {{EditKind::NotRock, {plain().rocks[0].cell}}}, &plain());
    EXPECT_EQ(not_.rocks.size() + 1, plain().rocks.size());
    const std::uint32_t cell = plain().rocks[0].cell;
    EXPECT_NE(whyTwoRocks(not_, cell, cell).verdict.find("which is not a rock"), std::string::npos);
    const Study again =
        studyRocks(sceneInputs(), {}, {{EditKind::NotRock, {plain().rocks[0].cell}}, {EditKind::Rock, {plain().rocks[0].cell}}}, &not_);
    ASSERT_EQ(again.rocks.size(), plain().rocks.size());
    EXPECT_TRUE(again.rocks[0].byHand);
}

TEST(RockWhy, TheLevelThatItNamesJoinsThem) {
    const auto [p, q] = neighbours();
    const BorderWhy why = whyTwoRocks(plain(), p, q);
    EXPECT_FALSE(why.sameRegion());
    ASSERT_TRUE(why.border);
    EXPECT_EQ(why.border->a, why.regions[0]);
    EXPECT_NEAR(why.border->meanZ(),
                7 * why.border->mean(why.border->sumE1) + 9 * why.border->mean(why.border->sumE2) +
                    0.5 * why.border->mean(why.border->sumValley) + 1.5 * why.border->mean(why.border->sumWide) - 9,
                1e-3);
    ASSERT_TRUE(why.joinedFrom);
    const auto groups = [&](double level) { return groupsAt(*plain().tree, plain().segmentation->count(), level); };
    const std::uint32_t a = plain().segmentation->segment[p];
    const std::uint32_t b = plain().segmentation->segment[q];
    EXPECT_EQ(groups(*why.joinedFrom)[a], groups(*why.joinedFrom)[b]);
    EXPECT_NE(groups(*why.joinedFrom - 1e-6)[a], groups(*why.joinedFrom - 1e-6)[b]);
    EXPECT_NE(why.verdict.find("one from level"), std::string::npos) << why.verdict;
    EXPECT_TRUE(whyTwoRocks(plain(), p, p).alwaysOne);
}

TEST(RockEdits, SurviveJsonAndAreRefusedWithASentence) {
    const std::vector<Edit> edits{
        {EditKind::Join, {0, 7, 12}}, {EditKind::Part, {3, 4}}, {EditKind::Cut, {1, 2}}, {EditKind::Rock, {19}}, {EditKind::NotRock, {0}}};
    const std::string text = rockEditsToJson(edits, 4, 5).dump();
    const auto back = rockPresetFromText(text, 4, 5, "", "edits.json");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->edits, edits);
    EXPECT_FALSE(back->settings);
    EXPECT_FALSE(rockPresetFromText(text, 5, 4, "", "edits.json"));
    const auto wrong = [](const std::string& edit) {
        const auto read = rockPresetFromText(R"({"format": "edgescan-rock-edits/1", "lines": 4, "beams": 5, "edits": [)" + edit + "]}", 4,
                                             5, "", "edits.json");
        return !read && read.error().sentence().find("edits.json") != std::string::npos;
    };
    for (const char* edit :
         {R"({"kind": "merge", "cells": [[0, 1], [0, 2]]})", R"({"kind": "join", "cells": [[0, 1]]})",
          R"({"kind": "rock", "cells": [[4, 0]]})", R"({"kind": "rock", "cells": [[0, 5]]})", R"({"kind": "rock", "cells": [[-1, 0]]})",
          R"({"kind": "rock", "cells": [[0.5, 0]]})", R"({"kind": "rock", "cells": [[0, 0]], "more": 1})",
          R"({"kind": "part", "cells": [[0, 0], [0, 1], [0, 2]]})", R"({"kind": 7, "cells": []})", "3", "[]"})
        EXPECT_TRUE(wrong(edit)) << edit;
    for (const char* whole : {"", "[]", "{}", R"({"format": "edgescan-rock-edits/2", "lines": 4, "beams": 5, "edits": []})",
                              R"({"format": "edgescan-rock-edits/1", "lines": 4, "beams": 5, "edits": {}})"})
        EXPECT_FALSE(rockPresetFromText(whole, 4, 5, "", "edits.json")) << whole;
}

TEST(RockEdits, AStrokeOverACrackJoinsWhatItCrosses) {
    const auto [p, q] = neighbours();
    const auto edit = joinAlong(*plain().segmentation, plain().map, {p, q});
    ASSERT_TRUE(edit);
    EXPECT_EQ(edit->kind, EditKind::Join);
    const std::vector<std::uint32_t> cells = strokeCells({p, q}, plain().segmentation->segment.lines, plain().segmentation->segment.beams);
    std::vector<std::uint32_t> crossed;
    for (const std::uint32_t k : cells) {
        if (regionAt(plain(), k) != 0) crossed.push_back(regionAt(plain(), k));
    }
    std::ranges::sort(crossed);
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
    EXPECT_GE(edit->cells.size(), crossed.size());
    EXPECT_GE(crossed.size(), 2U);
    const Study study = studyRocks(sceneInputs(), levelled(-4), {*edit}, &plain());
    for (const std::uint32_t k : edit->cells) EXPECT_EQ(regionAt(study, k), regionAt(study, p));
    EXPECT_FALSE(joinAlong(*plain().segmentation, plain().map, {p, p + 1}));
    EXPECT_FALSE(joinAlong(*plain().segmentation, plain().map, {}));
    EXPECT_TRUE(cutAlong(*plain().segmentation, plain().map, {}).empty());
}

TEST(RockEdits, TheWheelReachesSmallerAndLargerPieces) {
    int smaller = 0, larger = 0;
    for (const Rock& rock : plain().rocks) {
        const WheelPieces family = wheelPiecesAt(*plain().segmentation, *plain().tree, 0, rock.cell, {});
        for (std::size_t n = 0; n < family.nested.pieces.size(); ++n) {
            const NestedPiece& piece = family.nested.pieces[n];
            if (n == family.nested.region) continue;
            const bool isLarger = n > family.nested.region;
            EXPECT_EQ(piece.edit.kind, isLarger ? EditKind::Join : EditKind::Part);
            if ((isLarger ? larger : smaller) >= 6) continue;
            ++(isLarger ? larger : smaller);
            const Study study = studyRocks(sceneInputs(), {}, {piece.edit}, &plain());
            const Region& made = study.map.regions[regionAt(study, rock.cell)];
            if (isLarger)
                EXPECT_GT(made.sums.cells, rock.cells);
            else
                EXPECT_LT(made.sums.cells, rock.cells);
        }
        const auto split = splitAt(*plain().segmentation, *plain().tree, 0, rock.cell);
        EXPECT_EQ(split.has_value(), family.split != family.nested.region);
        if (split) {
            EXPECT_EQ(*split, family.nested.pieces[family.split].edit);
        }
    }
    EXPECT_EQ(smaller, 6);
    EXPECT_EQ(larger, 6);
}

// Rocks that do not touch, joined by hand: a split gives each back as it was, and the others stay joined.
TEST(RockEdits, AJoinedRockIsSplitIntoWhatWasJoined) {
    const std::vector<Rock>& rocks = plain().rocks;
    std::vector<std::uint32_t> apart;
    for (const Rock& rock : rocks) {
        const auto touches = [&](std::uint32_t k) {
            const std::uint32_t other = regionAt(plain(), k);
            return std::ranges::any_of(plain().map.borders, [&](const RegionBorder& border) {
                return border.a == std::min(other, rock.label) && border.b == std::max(other, rock.label);
            });
        };
        if (std::ranges::none_of(apart, touches)) apart.push_back(rock.cell);
        if (apart.size() == 3) break;
    }
    ASSERT_EQ(apart.size(), 3U);
    const std::vector<Edit> edits{{EditKind::Join, {apart[0], apart[1]}}, {EditKind::Join, {apart[1], apart[2]}}};
    const Study joined = studyRocks(sceneInputs(), {}, edits, &plain());
    ASSERT_EQ(regionAt(joined, apart[0]), regionAt(joined, apart[2]));
    const WheelPieces family = wheelPiecesAt(*joined.segmentation, *joined.tree, 0, apart[0], edits);
    ASSERT_TRUE(family.unjoined);
    EXPECT_LT(family.split, family.nested.region);
    EXPECT_EQ(*family.unjoined, (std::vector<Edit>{edits[1]}));
    const Study split = studyRocks(sceneInputs(), {}, *family.unjoined, &joined);
    EXPECT_EQ(split.map.regions[regionAt(split, apart[0])].sums.cells, plain().map.regions[regionAt(plain(), apart[0])].sums.cells);
    EXPECT_EQ(split.map.regions[regionAt(split, apart[0])].sums.cells, family.nested.pieces[family.split].cells);
    EXPECT_EQ(regionAt(split, apart[1]), regionAt(split, apart[2]));
    EXPECT_FALSE(wheelPiecesAt(*split.segmentation, *split.tree, 0, apart[0], *family.unjoined).unjoined);
}

// The pieces of both are in one rock, whichever of their cells were clicked; a split gives both back. Few other rocks change.
TEST(RockEdits, AJoinTakesTwoRocksWithAllTheirPieces) {
    int several = 0, same = 0, pairs = 0;
    for (const double level : {0.0, 1.5}) {
        const Study before = studyRocks(sceneInputs(), levelled(level), {}, &plain());
        for (std::uint32_t a = 1; a < before.map.rocks; ++a) {
            const std::uint32_t b = a % 3 == 0 ? before.map.rocks : a + 1;
            const std::vector<std::uint32_t> clicked{before.rocks[a - 1].cell, before.rocks[b - 1].cell};
            const auto join = joinOf(*before.segmentation, before.map, clicked);
            ASSERT_TRUE(join);
            several += join->cells.size() > 2 ? 1 : 0;
            const Study after = studyRocks(sceneInputs(), levelled(level), {*join}, &before);
            const std::uint32_t joined = regionAt(after, clicked[0]);
            EXPECT_LE(joined, after.map.rocks) << "a rock";
            std::uint32_t outside = 0;
            for (std::uint32_t n = 1; n < before.map.regionOfSegment.size(); ++n) {
                if (before.segmentation->sums[n].cells == 0) continue;
                const std::uint32_t was = before.map.regionOfSegment[n];
                outside += (was == a || was == b) && after.map.regionOfSegment[n] != joined ? 1 : 0;
            }
            EXPECT_EQ(outside, 0U) << a << " and " << b << " at " << level;
            ++pairs;
            same += after.rocks.size() + 1 == before.rocks.size() ? 1 : 0;
            const WheelPieces family = wheelPiecesAt(*after.segmentation, *after.tree, level, clicked[0], after.edits);
            ASSERT_TRUE(family.unjoined);
            EXPECT_TRUE(family.unjoined->empty());
        }
    }
    EXPECT_GT(several, 10);
    EXPECT_EQ(same, pairs);
}

// A piece of a rock that was joined by hand: a split makes exactly this piece a rock, and all else of the joined one remains one rock,
// whichever cells the join named.
TEST(RockEdits, APieceOfAJoinedRockIsSplitOffWhole) {
    int splits = 0;
    for (std::uint32_t a = 1; a < plain().map.rocks; ++a) {
        const std::uint32_t b = a % 2 == 0 ? plain().map.rocks : a + 1;
        const std::vector<std::uint32_t> clicked{plain().rocks[a - 1].cell, plain().rocks[b - 1].cell};
        for (const Edit& join : {*joinOf(*plain().segmentation, plain().map, clicked), Edit{EditKind::Join, clicked}}) {
            const Study joined = studyRocks(sceneInputs(), {}, {join}, &plain());
            for (const std::uint32_t k : clicked) {
                const WheelPieces wheel = wheelPiecesAt(*joined.segmentation, *joined.tree, 0, k, joined.edits);
                ASSERT_TRUE(wheel.unjoined);
                for (std::size_t n = 0; n < wheel.split; ++n) {
                    const auto edits = editsOfSplit(*joined.segmentation, wheel, n);
                    ASSERT_TRUE(edits);
                    const Study after = studyRocks(sceneInputs(), {}, *edits, &joined);
                    const std::vector<std::uint32_t>& own = wheel.nested.pieces[n].segments;
                    const std::vector<std::uint32_t>& all = wheel.nested.pieces[wheel.nested.region].segments;
                    std::set<std::uint32_t> made, rest, outside;
                    for (std::uint32_t s = 1; s < after.map.regionOfSegment.size(); ++s) {
                        if (after.segmentation->sums[s].cells == 0) continue;
                        const bool isOwn = std::ranges::binary_search(own, s);
                        (isOwn ? made : std::ranges::binary_search(all, s) ? rest : outside).insert(after.map.regionOfSegment[s]);
                    }
                    EXPECT_EQ(made.size(), 1U) << a << " and " << b << ", piece " << n;
                    EXPECT_EQ(rest.size(), 1U) << a << " and " << b << ", piece " << n;
                    // Apart from the rest, it may be a part of the wall, a region behind the rocks.
                    EXPECT_TRUE(!outside.contains(*made.begin()) || *made.begin() > after.map.rocks);
                    EXPECT_NE(*made.begin(), *rest.begin());
                    ++splits;
                }
            }
        }
    }
    EXPECT_GT(splits, 10);
}

TEST(RockEdits, WhatAnEditChangedIsKnown) {
    const auto changes = [](const Study& before, const Study& after) {
        return regionChanges(*before.segmentation, before.map, *after.segmentation, after.map);
    };
    EXPECT_FALSE(changes(plain(), plain()).any);
    const std::uint32_t first = plain().rocks.front().cell, last = plain().rocks.back().cell;
    const Study joined = studyRocks(sceneInputs(), {}, {{EditKind::Join, {first, last}}}, &plain());
    EXPECT_TRUE(changes(plain(), joined).any);
    // A joined rock joined again is the same rock.
    const Study again = studyRocks(sceneInputs(), {}, {{EditKind::Join, {first, last}}, {EditKind::Join, {last, first}}}, &joined);
    EXPECT_FALSE(changes(joined, again).any);
    const Study without = studyRocks(sceneInputs(), {}, {{EditKind::NotRock, {first}}}, &plain());
    EXPECT_TRUE(changes(plain(), without).lost.empty()) << "it was called so";
    // Cells are compared where the segments are others.
    const Study cut = studyRocks(sceneInputs(), {}, {{EditKind::Cut, {first, first + 40}}});
    EXPECT_NE(cut.segmentation, plain().segmentation);
    EXPECT_FALSE(changes(cut, cut).any);
}

// A report of the morning names the same rocks in the evening: after any edits, a rock with the same cells has the same number.
TEST(RockEdits, RocksKeepTheirNumbers) {
    std::mt19937 random(11);
    const auto cellsOf = [](const Study& study) {
        const Grid<std::uint32_t> labels = rockLabels(*study.segmentation, study.map);
        std::map<std::vector<std::uint32_t>, std::uint32_t> numbers; // by the cells
        std::map<std::uint32_t, std::vector<std::uint32_t>> cells;
        for (std::uint32_t k = 0; k < labels.size(); ++k) {
            if (labels[k] != 0) cells[labels[k]].push_back(k);
        }
        EXPECT_EQ(cells.size(), study.rocks.size());
        for (const Rock& rock : study.rocks) {
            EXPECT_TRUE(cells.contains(rock.label));
            numbers[cells[rock.label]] = rock.label;
        }
        return numbers;
    };
    std::vector<Edit> edits;
    Study before = plain();
    std::uint32_t highest = plain().map.rocks;
    int kept = 0, made = 0;
    for (int n = 0; n < 30; ++n) {
        const auto any = [&] { return before.rocks[random() % before.rocks.size()].cell; };
        const std::uint32_t cell = any();
        if (n % 5 == 4) {
            edits.push_back({EditKind::Join, {cell, any()}});
        } else if (n % 5 == 1) {
            edits.push_back({EditKind::Cut, {cell > 40 ? cell - 40 : cell, cell + 40}});
        } else if (n % 5 != 3) {
            const auto split = splitAt(*before.segmentation, *before.tree, 0, cell);
            if (!split) continue;
            edits.push_back(*split);
        } else {
            edits.push_back({EditKind::NotRock, {cell}});
        }
        Study after = studyRocks(sceneInputs(), {}, edits, &before);
        const auto now = cellsOf(after), then = cellsOf(before);
        for (const auto& [cells, number] : then) {
            const auto same = now.find(cells);
            if (same == now.end()) continue;
            EXPECT_EQ(same->second, number) << "edit " << n;
            ++kept;
        }
        for (const auto& [cells, number] : now) {
            if (number <= highest) continue;
            highest = number;
            ++made;
        }
        EXPECT_EQ(cellsOf(studyRocks(sceneInputs(), {}, edits)), now) << "without the study before";
        before = std::move(after);
    }
    EXPECT_GT(kept, 200);
    EXPECT_GT(made, 0);
    EXPECT_LT(before.rocks.size(), before.map.rocks);
}

// The part that a split leaves below a limit of a rock is named with its rock.
TEST(RockEdits, APartThatIsNoRockIsKnown) {
    int found = 0;
    for (const Rock& rock : plain().rocks) {
        const auto edit = splitAt(*plain().segmentation, *plain().tree, 0, rock.cell);
        if (!edit) continue;
        const Study split = studyRocks(sceneInputs(), {}, {*edit}, &plain());
        const RegionChanges changes = regionChanges(*plain().segmentation, plain().map, *split.segmentation, split.map);
        EXPECT_TRUE(changes.any);
        std::set<std::uint32_t> rockParts, otherParts;
        for (std::uint32_t n = 1; n <= plain().segmentation->count(); ++n) {
            if (plain().map.regionOfSegment[n] != rock.label) continue;
            const std::uint32_t part = split.map.regionOfSegment[n];
            (part <= split.map.rocks ? rockParts : otherParts).insert(part);
        }
        const auto lost = std::ranges::find(changes.lost, rock.label, &RegionChanges::Lost::rock);
        EXPECT_EQ(lost != changes.lost.end(), rockParts.size() < 2 && !otherParts.empty());
        if (lost == changes.lost.end()) continue;
        EXPECT_TRUE(otherParts.contains(lost->region));
        ++found;
    }
    EXPECT_GT(found, 0);
}

TEST(RockPresets, KeepSettingsAndEditsOfTheirOwnScanAlone) {
    Preset preset;
    preset.settings = levelled(1.5);
    preset.settings->region = {{0, 0}, {3, 4}};
    preset.edits = {{EditKind::Join, {0, 7}}};
    preset.sha256 = "abc";
    const std::string text = rockPresetText(preset, 4, 5);
    const auto back = rockPresetFromText(text, 4, 5, "abc", "p.json");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(*back->settings, *preset.settings);
    EXPECT_EQ(back->edits, preset.edits);
    EXPECT_TRUE(rockPresetFromText(text, 4, 5, "", "p.json"));
    const auto other = rockPresetFromText(text, 4, 5, "abd", "p.json");
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().sentence().find("other content"), std::string::npos);
    EXPECT_FALSE(rockPresetFromText(R"({"sha256": 3})", 4, 5, "", "p.json"));
}

TEST(RegionOfInterest, TheMaskEqualsAskingEachCell) {
    const std::vector<std::vector<RegionCorner>> regions{{},
                                                         {{2, 3}, {9, 14}},
                                                         {{9, 14}, {2, 3}},
                                                         {{1, 1}, {12, 4}, {3, 15}},
                                                         {{0, 0}, {10, 10}, {0, 10}, {10, 0}},
                                                         {{-3, 5}, {20, 5}, {8, 30}}};
    for (const auto& region : regions) {
        const Grid<std::uint8_t> mask = insideMask(region, 14, 18);
        for (int i = 0; i < mask.lines; ++i) {
            for (int j = 0; j < mask.beams; ++j) EXPECT_EQ(mask.at(i, j) != 0, isInside(region, i, j)) << i << "," << j;
        }
    }
    // A circle drawn cell by cell keeps its shape with few corners.
    std::vector<RegionCorner> circle;
    for (int n = 0; n < 360; ++n)
        circle.push_back({50 + static_cast<int>(std::lround(40 * std::sin(n * 0.01745))),
                          50 + static_cast<int>(std::lround(40 * std::cos(n * 0.01745)))});
    const std::vector<RegionCorner> corners = regionOfDrawing(circle);
    EXPECT_LT(corners.size(), 60U);
    const Grid<std::uint8_t> mask = insideMask(corners, 101, 101);
    for (int i = 0; i < 101; ++i) {
        for (int j = 0; j < 101; ++j) {
            const double off = std::hypot(i - 50, j - 50);
            if (off < 38) {
                EXPECT_EQ(mask.at(i, j), 1) << i << "," << j;
            }
            if (off > 42) {
                EXPECT_EQ(mask.at(i, j), 0) << i << "," << j;
            }
        }
    }
    EXPECT_TRUE(regionOfDrawing({{1, 1}, {2, 2}}).empty());
}

} // namespace
} // namespace edgescan::rocks
