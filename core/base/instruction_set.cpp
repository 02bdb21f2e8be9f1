// Chooses the instruction set of all loops.
#include "core/base/instruction_set.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace edgescan {
namespace {

constexpr const char* kVariable = "EDGESCAN_LOOPS";

InstructionSet widestHere() { return *std::find_if(kInstructionSets.rbegin(), kInstructionSets.rend(), isHere); }

std::string namesHere() {
    std::string names;
    for (const InstructionSet set : kInstructionSets) {
        if (isHere(set)) names += (names.empty() ? "" : ", ") + std::string(nameOf(set));
    }
    return names;
}

} // namespace

const char* nameOf(InstructionSet set) {
    constexpr std::array<const char*, kInstructionSets.size()> kNames{"plain", "sse4.2", "avx2", "avx512"};
    return kNames[static_cast<std::size_t>(set)];
}

bool isHere(InstructionSet set) {
#if defined(__x86_64__) && defined(__GNUC__)
    switch (set) {
    case InstructionSet::Plain:
        return true;
    case InstructionSet::Sse42:
        return __builtin_cpu_supports("sse4.2") != 0;
    case InstructionSet::Avx2:
        return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi") != 0;
    case InstructionSet::Avx512:
        return isHere(InstructionSet::Avx2) && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
               __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
    }
    return false;
#else
    return set == InstructionSet::Plain;
#endif
}

Result<InstructionSet> wantedInstructionSet() {
    const char* const wanted = std::getenv(kVariable);
    if (wanted == nullptr || *wanted == '\0') return widestHere();
    for (const InstructionSet set : kInstructionSets) {
        if (std::string_view(wanted) != nameOf(set)) continue;
        if (isHere(set)) return set;
        return Error{std::string("this processor has no ") + wanted, kVariable, "set it to one of " + namesHere() + ", or remove it"};
    }
    return Error{"this is not the name of an instruction set: " + std::string(wanted), kVariable,
                 "set it to one of " + namesHere() + ", or remove it"};
}

InstructionSet instructionSet() {
    static const InstructionSet chosen = [] {
        const auto wanted = wantedInstructionSet();
        return wanted ? *wanted : widestHere();
    }();
    return chosen;
}

} // namespace edgescan
