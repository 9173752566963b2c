#include "models/utf8.h"

namespace glint {
namespace {

/// Bytes of a character and the bounds of its second byte; the later ones are 80 to BF. Length 0: no lead
/// byte.
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

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const Lead lead = lead_of(byte_at(text, 0));
    if (lead.length < 2 || text.size() < lead.length) return lead.length == 1 ? 1 : 0;
    if (byte_at(text, 1) < lead.second_min || byte_at(text, 1) > lead.second_max) return 0;
    for (std::size_t i = 2; i < lead.length; ++i)
        if ((byte_at(text, i) & 0xC0) != 0x80) return 0;
    return lead.length;
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

}  // namespace glint
