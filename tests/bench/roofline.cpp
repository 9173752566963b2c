// The machine's peak rates, for comparison with the renderer: multiplications and additions per second, and
// bytes per second from memory.
//
//   glint_roofline

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <numeric>
#include <vector>

namespace {

using Floats = float __attribute__((vector_size(64)));

/// The shortest of many short measurements, which excludes interference from other processes.
template <class Work> double seconds_of(const Work& work) {
    double best = 1e9;
    for (int repetition = 0; repetition < 400; ++repetition) {
        const auto start = std::chrono::steady_clock::now();
        work(repetition);
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

constexpr int rounds = 50'000, chains = 12;

/// Independent chains of multiplications and additions, never fused, as in the lighting equation.
[[gnu::target_clones("avx512f", "avx2", "default")]] void multiply_and_add(Floats* out, Floats factor) {
    Floats chain[chains];
    for (int c = 0; c < chains; ++c) chain[c] = out[c];
    for (int i = 0; i < rounds; ++i)
        for (int c = 0; c < chains; ++c) chain[c] = chain[c] * factor + factor;
    for (int c = 0; c < chains; ++c) out[c] = chain[c];
}

volatile float sink;

void arithmetic() {
    Floats chain[chains] = {};
    multiply_and_add(chain, Floats{} + 0.999f);
    float sum = 0;
    for (const Floats& c : chain) sum += c[0];
    sink = sum;
}

constexpr std::size_t piece = std::size_t{1} << 19,
                      pieces = 256;  // 4 MiB each; 1 GiB in total, more than any cache

}  // namespace

int main() {
    const double flops = 2.0 * rounds * chains * 16 / seconds_of([](int) { arithmetic(); });
    const std::vector<unsigned long long> memory(piece * pieces, 1);
    const double seconds = seconds_of([&memory](int repetition) {
        const auto first = memory.begin() +
                           static_cast<std::ptrdiff_t>(static_cast<std::size_t>(repetition) % pieces * piece);
        sink = static_cast<float>(std::accumulate(first, first + static_cast<std::ptrdiff_t>(piece), 0ULL));
    });
    fmt::print("one core: {:.0f} GFlop/s of separate products and sums, {:.1f} GB/s read from memory\n",
               flops * 1e-9, 8.0 * static_cast<double>(piece) / seconds * 1e-9);
}
