// Which of the instruction sets that Highway compiles for this processor has.
//
// These are the three functions of hwy/targets.h that its dispatch calls. libhwy has them too, but
// times the processor's clock when it is loaded: 4.3 ms of every process, where baking a strip
// takes as much again. Linked as needed, it is then left out.
#include <hwy/targets.h>

#include <atomic>

namespace hwy {
namespace {

std::int64_t of_this_processor() {
    std::int64_t out = HWY_ENABLED_BASELINE;
#if HWY_ARCH_X86
    // Processors with these have all else that Highway's AVX2 and AVX3 take for granted.
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi2");
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512cd");
    out |= __builtin_cpu_supports("sse4.2") ? HWY_SSE4 : 0;
    out |= avx2 ? HWY_AVX2 : 0;
    out |= avx2 && avx512 ? HWY_AVX3 : 0;
#endif
    return out;
}

std::atomic<std::int64_t> chosen_by_a_test{0};

} // namespace

std::int64_t SupportedTargets() {
    static const std::int64_t supported = of_this_processor();
    const std::int64_t chosen = chosen_by_a_test.load(std::memory_order_relaxed);
    return chosen != 0 ? chosen : supported;
}

void SetSupportedTargetsForTest(std::int64_t targets) {
    chosen_by_a_test = targets;
    GetChosenTarget().DeInit();
}

ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

} // namespace hwy
