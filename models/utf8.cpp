#include "models/utf8.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "models/problem.h"

namespace glint {
namespace {

/// The number of bytes of a character and the bounds of its second byte; later bytes are 80 to BF. Length 0:
/// not a lead byte.
struct Lead {
    std::size_t length;
    unsigned char second_min = 0x80, second_max = 0xBF;
};

Lead lead_of(unsigned char byte) {
    if (byte < 0x80) return {1};
    if (byte < 0xC2) return {0};  // a continuation, or an overlong form of ASCII
    if (byte < 0xE0) return {2};
    if (byte == 0xE0) return {3, 0xA0, 0xBF};  // below: overlong
    if (byte == 0xED) return {3, 0x80, 0x9F};  // above: surrogates
    if (byte < 0xF0) return {3};
    if (byte == 0xF0) return {4, 0x90, 0xBF};  // below: overlong
    if (byte < 0xF4) return {4};
    if (byte == 0xF4) return {4, 0x80, 0x8F};  // above: past U+10FFFF
    return {0};
}

unsigned char byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// Rewrites every well-formed character as character(its bytes) and every other byte as stray(byte).
template <class Character, class Stray>
std::string rewritten(std::string_view text, const Character& character, const Stray& stray) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8_length(text.substr(i, 4));
        result += length > 0 ? character(text.substr(i, length)) : stray(text[i]);
        i += length > 0 ? length : 1;
    }
    return result;
}

/// Returns the character for a byte: U+EF80 to U+EFFF, whose UTF-8 form is EE BE 80 to EE BF BF.
std::string escape_of(char byte) {
    const auto low = static_cast<unsigned char>(byte) & 0x7F;
    return {'\xEE', static_cast<char>(0xBE + (low >> 6)), static_cast<char>(0x80 + (low & 0x3F))};
}
bool is_escape(std::string_view character) {
    return character.size() == 3 && byte_at(character, 0) == 0xEE && byte_at(character, 1) >= 0xBE;
}
char byte_of_escape(std::string_view escape) {
    return static_cast<char>(0x80 + ((byte_at(escape, 1) - 0xBE) << 6) + (byte_at(escape, 2) & 0x3F));
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const Lead lead = lead_of(byte_at(text, 0));
    if (lead.length < 2 || text.size() < lead.length) return lead.length == 1 ? 1 : 0;
    if (byte_at(text, 1) < lead.second_min || byte_at(text, 1) > lead.second_max) return 0;
    for (std::size_t i = 2; i < lead.length; ++i)
        if (!continues_character(text[i])) return 0;
    return lead.length;
}

bool is_control(std::string_view character) {
    const char32_t c = code_point(character);
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x2028 && c <= 0x202E) ||
           (c >= 0x2066 && c <= 0x2069);
}

char32_t code_point(std::string_view character) {
    const std::size_t length = character.size();
    char32_t number = byte_at(character, 0) & (length == 1 ? 0x7Fu : 0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) number = number << 6 | (byte_at(character, i) & 0x3Fu);
    return number;
}

std::string_view first_characters(std::string_view text, std::size_t count) {
    std::size_t at = 0;
    for (; count > 0 && at < text.size(); --count)
        at += std::max<std::size_t>(utf8_length(text.substr(at)), 1);
    return text.substr(0, at);
}

std::size_t count_characters(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) text.remove_prefix(first_characters(text, 1).size());
    return count;
}

std::size_t first_invalid_utf8(std::string_view text) {
    std::size_t i = 0;
    while (i < text.size()) {
        const std::size_t length = utf8_length(text.substr(i, 4));
        if (length == 0) return i;
        i += length;
    }
    return i;
}

std::string with_invalid_replaced(std::string_view text) {
    return rewritten(
        text, [](std::string_view c) { return std::string(c); }, [](char) { return std::string("\uFFFD"); });
}

std::string escaped_bytes(std::string_view bytes) {
    const auto character = [](std::string_view c) {
        return is_escape(c) ? escape_of(c[0]) + escape_of(c[1]) + escape_of(c[2]) : std::string(c);
    };
    return rewritten(bytes, character, escape_of);
}

std::string unescaped_bytes(std::string_view text) {
    const auto character = [](std::string_view c) {
        return is_escape(c) ? std::string(1, byte_of_escape(c)) : std::string(c);
    };
    return rewritten(text, character, [](char c) { return std::string(1, c); });
}

namespace {

using Replacements = std::initializer_list<std::pair<char, const char*>>;

/// The text on one line, with these characters replaced.
std::string with_replaced(std::string_view text, Replacements all) {
    std::string out;
    for (const char c : on_one_line(text)) {
        const auto* const found =
            std::find_if(all.begin(), all.end(), [c](const auto& r) { return r.first == c; });
        if (found == all.end())
            out += c;
        else
            out += found->second;
    }
    return out;
}

}  // namespace

std::string html_escaped(std::string_view text) {
    return with_replaced(text, {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}});
}

std::string latex_escaped(std::string_view text) {
    // LaTeX's default font encoding has other characters in place of the first three.
    return with_replaced(text, {{'<', "\\textless{}"},
                                {'>', "\\textgreater{}"},
                                {'|', "\\textbar{}"},
                                {'\\', "\\textbackslash{}"},
                                {'~', "\\textasciitilde{}"},
                                {'^', "\\textasciicircum{}"},
                                {'#', "\\#"},
                                {'$', "\\$"},
                                {'%', "\\%"},
                                {'&', "\\&"},
                                {'_', "\\_"},
                                {'{', "\\{"},
                                {'}', "\\}"}});
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k]))
                                        : 0U;
        };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace glint
