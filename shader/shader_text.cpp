#include "shader/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>

#include "models/io/file.h"

namespace glint {
namespace {

constexpr const char* missing_lit = "there is no function that can be called as lit(vec3 p, vec3 n)";

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Removes the leading characters that `is` accepts; returns whether there were any.
bool skip(std::string_view& text, bool (*is)(char)) {
    const auto end = std::find_if_not(text.begin(), text.end(), is);
    const auto count = static_cast<std::size_t>(end - text.begin());
    text.remove_prefix(count);
    return count > 0;
}

/// Returns the position after the comment that begins at `at`, or `at` if none does.
std::size_t after_comment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
    if (text.substr(at, 2) != "/*") return at;
    const std::size_t end = text.find("*/", at + 2);
    return end == text.npos ? text.size() : end + 2;
}

/// Calls visit(position) for each character from `at` on that is not in a comment, until visit() returns
/// false.
template <class Visit> void visit_code(std::string_view text, std::size_t at, const Visit& visit) {
    while (at < text.size()) {
        const std::size_t after = after_comment(text, at);
        if (after == at && !visit(at)) return;
        at = std::max(after, at + 1);
    }
}

/// The position of a loop's condition. There is none if the loop's parentheses are not closed.
struct Condition {
    std::size_t begin, end;
};
std::optional<Condition> condition_of(std::string_view text, std::size_t after_word, bool is_for) {
    std::optional<Condition> found;
    std::size_t begin = text.npos;
    int depth = 0;
    visit_code(text, after_word, [&](std::size_t at) {
        const char c = text[at];
        if (depth == 0 && c != '(') return is_space(c);
        if (c == '(' && depth++ == 0 && !is_for) begin = at + 1;
        if (c == ')') --depth;
        const bool is_separator = is_for && depth == 1 && c == ';';
        if (begin != text.npos && (is_separator || depth == 0)) found = {begin, at};
        if (is_separator && begin == text.npos) begin = at + 1;
        return !found && depth > 0;
    });
    return found;
}

/// "bool ok = f()" declares a variable and cannot be part of an expression.
bool is_declaration(std::string_view code) {
    skip(code, is_space);
    if (!skip(code, is_of_word) || !skip(code, is_space) || !skip(code, is_of_word)) return false;
    skip(code, is_space);
    return code.starts_with('=') && !code.starts_with("==");
}

/// Replaces `#version ...` with spaces.
void remove_version(std::string& text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line(text.data() + begin, end - begin);
        skip(line, is_space);
        if (line.starts_with('#')) {
            line.remove_prefix(1);
            skip(line, is_space);
            if (line.starts_with("version"))
                std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin),
                          text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        }
        begin = end + 1;
    }
}

using Insertions = std::vector<std::pair<std::size_t, std::string_view>>;

/// Returns the insertions that count the iterations of all loops.
Insertions loop_counters(std::string_view text) {
    Insertions all;
    visit_code(text, 0, [&](std::size_t at) {
        if (!is_of_word(text[at]) || (at > 0 && is_of_word(text[at - 1]))) return true;
        for (const std::string_view word : {std::string_view("for"), std::string_view("while")}) {
            const std::size_t after = at + word.size();
            if (text.substr(at, word.size()) != word || (after < text.size() && is_of_word(text[after])))
                continue;
            const auto condition = condition_of(text, after, word == "for");
            if (!condition) continue;
            const std::string_view code = text.substr(condition->begin, condition->end - condition->begin);
            const bool is_empty = code.find_first_not_of(" \t\r\n") == code.npos;
            if (is_declaration(code)) continue;
            all.emplace_back(condition->begin, is_empty ? "loop_runs()" : "loop_runs() && (");
            if (!is_empty) all.emplace_back(condition->end, ")");
        }
        return true;
    });
    return all;
}

/// Replaces the symbols of Mesa's parser with words, as in "unexpected BASIC_TYPE_TOK".
std::string in_words(std::string text) {
    for (const auto& [symbol, word] : {std::pair{"BASIC_TYPE_TOK", "a type"},
                                       {"NEW_IDENTIFIER", "a new name"},
                                       {"IDENTIFIER", "a name"},
                                       {"FLOATCONSTANT", "a number"},
                                       {"INTCONSTANT", "a number"}})
        if (const std::size_t at = text.find(symbol); at != text.npos)
            text.replace(at, std::string_view(symbol).size(), word);
    return text;
}

/// Parses a line of a log: "0:4(2): error: text" (Mesa), "0(4) : error C1008: text" (NVIDIA), "ERROR: 0:4:
/// text" (Intel, ANGLE).
std::optional<ShaderMessage> parsed(const std::string& line) {
    static const std::regex mesa(R"(\d+:(\d{1,7})(?:\(\d+\))?: (?:preprocessor )?(error|warning): (.*))");
    static const std::regex nvidia(R"(\d+\((\d{1,7})\) : (error|warning) \w+: (.*))");
    static const std::regex intel(R"(\d+:(\d{1,7}): (.*))");
    std::smatch m;
    if (std::regex_match(line, m, mesa) || std::regex_match(line, m, nvidia))
        return ShaderMessage{m[2] == "error", std::stoi(m[1]), in_words(m[3])};
    const bool is_error = line.starts_with("ERROR: "), is_warning = line.starts_with("WARNING: ");
    if (!is_error && !is_warning) return {};
    const std::string rest = line.substr(line.find(' ') + 1);
    if (!std::regex_match(rest, m, intel)) return {};
    return ShaderMessage{is_error, std::stoi(m[1]), m[2]};
}

/// Rewords an error from the linker or from the code around the user's file, which the user cannot see.
ShaderMessage about_surroundings(const std::string& text, int lines) {
    static const std::regex lit(R"(\blit\b)");
    if (std::regex_search(text, lit)) return {true, 0, missing_lit};
    if (text.starts_with("syntax error"))
        return {true, lines, "the file ends within a function, a declaration or a comment"};
    return {true, 0, "it conflicts with the code that Glint adds: " + text};
}

}  // namespace

Result<std::string> read_shader(const std::string& path) {
    Result<std::string> read = read_file(path, max_shader_bytes);
    const auto* text = std::get_if<std::string>(&read);
    if (text == nullptr) return read;
    const auto strange = std::find_if(text->begin(), text->end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' && c != '\r' && c != '\f';
    });
    if (strange == text->end()) return read;
    return Problem{path, "", "it is not text", "a GLSL file",
                   line_of(*text, static_cast<std::size_t>(strange - text->begin()))};
}

std::string prepared_shader(std::string_view text) {
    std::string out;
    std::size_t at = 0;
    for (const auto& [place, inserted] : loop_counters(text)) {
        out.append(text.substr(at, place - at)).append(inserted);
        at = place;
    }
    out.append(text.substr(at));
    remove_version(out);
    return out;
}

std::vector<ShaderMessage> shader_messages(const std::string& log, int lines) {
    std::vector<ShaderMessage> all;
    const auto add = [&all](const ShaderMessage& message) {
        // Mesa gives this type to an expression whose error it has already reported.
        if (message.text.find("type error") != message.text.npos) return;
        if (std::find(all.begin(), all.end(), message) == all.end()) all.push_back(message);
    };
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        constexpr std::size_t longest = 500;  // std::regex recurses for each character
        line.resize(std::min(line.size(), longest));
        if (const auto found = parsed(line)) {
            if (found->line < first_line_before)
                add(*found);
            else if (found->is_error)
                add(about_surroundings(found->text, lines));
        } else if (const std::size_t error = line.find("error: "); error != line.npos) {
            add(about_surroundings(line.substr(error + 7), lines));
        }
    }
    return all;
}

Problem problem_from(const ShaderMessage& message, const std::string& file) {
    return {file, "", message.text, message.text == missing_lit ? "vec3 lit(vec3 p, vec3 n)" : "",
            message.line};
}

}  // namespace glint
