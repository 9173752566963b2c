
#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "models/io/utf8.h"
#include "models/json/json_reader.h"

namespace glint {
namespace {

constexpr std::string_view white_space = " \t\r\n";

struct Fault {
    std::size_t place;  // of the first character that does not fit
    std::string_view expected;
    bool string_fits;  // a string may stand here
};

/// The first character at or after `place` that is not white space.
std::size_t skip_space(std::string_view text, std::size_t place) {
    return std::min(text.find_first_not_of(white_space, place), text.size());
}

/// After a key a colon is expected, after a value in a container a comma. The fault is what stands there
/// instead, or what follows it.
Fault fault_of(const JsonStop& stop) {
    const std::size_t next = skip_space(stop.text, stop.understood);
    const char c = next < stop.text.size() ? stop.text[next] : '\0';
    const bool in_object = stop.container == JsonContainer::Object;
    switch (stop.last) {
    case JsonEvent::Nothing:
        return {next, "an object, such as {\"glint\": 1}", true};
    case JsonEvent::OpenedObject:
        return {next, "a key in quotes or \"}\"", true};
    case JsonEvent::OpenedArray:
        return {next, "a value or \"]\"", true};
    case JsonEvent::Key:
        if (c != ':') return {next, "\":\" after the key", false};
        return {skip_space(stop.text, next + 1), "a value", true};
    case JsonEvent::Value:
        if (stop.container == JsonContainer::None) return {next, "the end of the text", false};
        if (c != ',') return {next, in_object ? "\",\" or \"}\"" : "\",\" or \"]\"", false};
        return {skip_space(stop.text, next + 1), in_object ? "a key in quotes" : "a value", true};
    }
    return {};  // not reached
}

/// The whole word or number that starts here, or the one character.
std::string_view word_at(std::string_view text) {
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' ||
               c == '-';
    };
    const auto length = std::find_if_not(text.begin(), text.end(), in_word) - text.begin();
    return length > 0 ? text.substr(0, static_cast<std::size_t>(length)) : text.substr(0, utf8_length(text));
}

/// Whether the string that starts here has its closing quote.
bool is_closed(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); i += text[i] == '\\' ? 2 : 1)
        if (text[i] == '"') return true;
    return false;
}

/// `rest`: the text from the string on.
Problem broken_string(const JsonStop& stop, std::string_view rest) {
    if (stop.reached >= stop.text.size() && !is_closed(rest))
        return {"", "", "a string that does not end", "\" after it"};
    if (static_cast<unsigned char>(stop.text[stop.reached - 1]) < 0x20)
        return {"", "", "a control character in a string",
                "it written as \\n, \\t or \\u and four hex digits"};
    return {"", "", "an escape that JSON does not know",
            "\\\", \\\\, \\/, \\b, \\f, \\n, \\r, \\t, or \\u and four hex digits, surrogates in pairs"};
}

}  // namespace

int line_of(std::string_view text, std::size_t place) {
    const std::string_view before = text.substr(0, place);
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

Problem syntax_problem(const JsonStop& stop) {
    const Fault fault = fault_of(stop);
    const std::string_view rest = stop.text.substr(fault.place);
    const std::string expected(fault.expected);
    const auto problem = [&]() -> Problem {
        if (rest.empty() && stop.last == JsonEvent::Nothing) return {"", "", "there is no text", expected};
        if (rest.empty()) return {"", "", "the text ends too early", expected};
        if (rest.starts_with('/'))
            return {"", "", "a comment or a stray slash", "JSON, which has no comments"};
        if (!rest.starts_with('"')) return {"", "", "unexpected " + in_quotes(word_at(rest)), expected};
        if (fault.string_fits) return broken_string(stop, rest);
        return {"", "", "unexpected " + in_quotes(rest.substr(1, rest.find('"', 1) - 1)), expected};
    }();
    const std::size_t last = stop.text.find_last_not_of(white_space);  // for a text that ends too early
    const int line = line_of(stop.text, last == std::string_view::npos ? 0 : std::min(fault.place, last));
    return {"", "", problem.what, problem.expected, line};
}

}  // namespace glint
