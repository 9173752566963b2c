#include "models/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

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

}  // namespace glint
