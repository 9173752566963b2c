#include "models/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace glint {

// The reader converts via double. For a few floats (such as 7.0385307e-26) this rounds the float's shortest
// decimals to a neighbouring float, so they get more digits.
std::string number_text(float x) {
    if (x == 0 && std::signbit(x)) return "-0.0";  // "-0" is read as an integer, which has no sign
    std::string text = fmt::format("{}", x);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return static_cast<float>(read) == x ? text : fmt::format("{}", static_cast<double>(x));
}

namespace {

using std::numbers::pi;

/// Taylor series for |a| <= pi/4: the first omitted term is below 2e-16.
CosSin small_angle(double a) {
    const double q = a * a;
    double c = 0, s = 0;
    for (int k = 18; k >= 2; k -= 2) {
        c = (1 - c) * q / ((k - 1) * k);
        s = (1 - s) * q / (k * (k + 1));
    }
    return {1 - c, a * (1 - s)};
}

/// Rotates an angle by `quarters` quarter turns.
CosSin turned(CosSin a, std::int64_t quarters) {
    for (std::int64_t i = quarters & 3; i > 0; --i) a = {-a.s, a.c};
    return a;
}

}  // namespace

CosSin on_circle(std::int64_t k, std::int64_t n) {
    k = (k % n + n) % n;
    const std::int64_t eighth = 8 * k / n, rest = 8 * k - eighth * n;  // angle = (eighth + rest / n) pi / 4
    const bool odd = eighth % 2 != 0;
    const double part = static_cast<double>(odd ? n - rest : rest) / static_cast<double>(n);
    const CosSin a = small_angle(part * (pi / 4));
    return turned(odd ? CosSin{a.s, a.c} : a, eighth / 2);
}

CosSin cos_sin(double angle) {
    const double quarter = std::floor(angle / (pi / 2) + 0.5);
    return turned(small_angle(angle - quarter * (pi / 2)), static_cast<std::int64_t>(quarter));
}

double angle_of(double x, double y) {
    const double across = std::abs(x);
    if (!(across + y > 0)) return 0;
    const bool steep = y > across;
    double t = steep ? across / y : y / across;  // tangent of an angle up to pi/4
    double base = 0;
    if (t > 0.41421356237309503) {  // tan(pi/8): atan t = pi/4 + atan((t - 1)/(t + 1))
        t = (t - 1) / (t + 1);
        base = pi / 4;
    }
    const double q = t * t;
    double series = 0;  // t - t^3/3 + t^5/5 ..., |t| <= 0.4143: the first omitted term is below 5e-10
    for (int k = 19; k >= 1; k -= 2) series = 1.0 / k - q * series;
    double angle = base + t * series;
    if (steep) angle = pi / 2 - angle;
    return x < 0 ? pi - angle : angle;
}

}  // namespace glint
