// UTF-8 against RFC 3629's own definition: a character's bytes contain its number, in as few bytes as
// possible.
#include "models/utf8.h"

#include <string>
#include <string_view>

#include "tests/support/catch.h"

using namespace glint;

namespace {

/// Encodes a character's number; its bits are distributed as in the table in RFC 3629, section 3.
std::string encoded(unsigned number) {
    const auto later = [number](int shift) { return static_cast<char>(0x80 | ((number >> shift) & 0x3F)); };
    if (number < 0x80) return {static_cast<char>(number)};
    if (number < 0x800) return {static_cast<char>(0xC0 | (number >> 6)), later(0)};
    if (number < 0x10000) return {static_cast<char>(0xE0 | (number >> 12)), later(6), later(0)};
    return {static_cast<char>(0xF0 | (number >> 18)), later(12), later(6), later(0)};
}

}  // namespace

TEST_CASE("numbers up to 10FFFF, except surrogates, are characters of UTF-8", "[utf8]") {
    int wrong = 0;
    for (unsigned number = 0; number < 0x200000; ++number) {
        const std::string bytes = encoded(number);
        const bool is_character = number <= 0x10FFFF && (number < 0xD800 || number > 0xDFFF);
        wrong += utf8_length(bytes + "x") != (is_character ? bytes.size() : 0);
    }
    CHECK(wrong == 0);
}

TEST_CASE("overlong and stray bytes are not characters of UTF-8", "[utf8]") {
    for (const std::string bytes :
         {"\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE0\x9F\xBF", "\xF0\x80\x80\x80", "\xF0\x8F\xBF\xBF",
          "\x80", "\xBF", "\xF8\x88\x80\x80\x80", "\xFE", "\xFF", "\xC3", "\xE2\x82", "\xF0\x9F\x98", "\xC3(",
          "\xE2(\xAC", "\xE2\x82("}) {
        CAPTURE(bytes);
        CHECK(utf8_length(bytes) == 0);
    }
    CHECK(utf8_length("") == 0);
    for (const std::string_view whole : {"\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
        CHECK(utf8_length(whole.substr(0, whole.size() - 1)) == 0);  // bytes beyond the text are not read
}
