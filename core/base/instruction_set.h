// The processor's instruction sets for which the loops of the core are compiled (core/base/simd.h), and the one that they use.
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>

namespace edgescan {

/// The widest last. `Plain` is what every processor of this kind has.
enum class InstructionSet : std::uint8_t { Plain, Sse42, Avx2, Avx512 };
inline constexpr std::array kInstructionSets{InstructionSet::Plain, InstructionSet::Sse42, InstructionSet::Avx2, InstructionSet::Avx512};

/// "plain", "sse4.2", "avx2", "avx512", as in EDGESCAN_LOOPS.
[[nodiscard]] const char* nameOf(InstructionSet set);

/// Whether the loops are compiled for the set and this processor has it.
[[nodiscard]] bool isHere(InstructionSet set);

/// The set of the environment variable EDGESCAN_LOOPS, for tests and benchmarks; without it, the widest that this processor has. Refuses an
/// unknown name and a set that this processor lacks.
[[nodiscard]] Result<InstructionSet> wantedInstructionSet();

/// The set that all loops of this process use: wantedInstructionSet() of the first call. Programs end at start if that was refused; where
/// no program checks it, the widest set is used.
[[nodiscard]] InstructionSet instructionSet();

} // namespace edgescan
