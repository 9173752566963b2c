#include "programs/model_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "models/fields/choices.h"
#include "models/mesh/normals.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

/// The effect of a mistake on a formula.
struct Change {
    bool Mistakes::*flag;
    std::string_view right, wrong;
};
constexpr std::array<Change, 8> changes{{
    {&Mistakes::unnormalized_half, "unit(l + v)", "0.5 * (l + v)"},
    {&Mistakes::absolute_cosine, "max(n_l, 0.0)", "abs(n_l)"},  // if both are on, n_l is never negative
    {&Mistakes::no_clamp_of_cosine, "max(n_l, 0.0)", "n_l"},
    {&Mistakes::half_lambert, "max(n_l, 0.0)", "(0.5 + 0.5 * n_l)"},
    {&Mistakes::no_clamp_of_cosine, " power(", " unclamped_power("},
    {&Mistakes::absolute_cosine, "above_zero(n_l)", "above_zero(abs(n_l))"},
    {&Mistakes::reflect_of_difference, "2.0 * n_l * n - l", "2.0 * n_l * (n - l)"},
    {&Mistakes::reflect_sign, "2.0 * n_l * n - l", "l - 2.0 * n_l * n"},
}};

std::string_view name_of_flag(bool Mistakes::*flag) {
    const auto names = mistake_names();
    const auto* row = std::find_if(names.data(), names.data() + names.size(),
                                   [flag](const MistakeName& m) { return m.flag == flag; });
    return row->name;
}

struct Statement {
    bool is_vector = false;
    std::string name, expression;
    std::vector<std::string_view> mistakes;  // applied to the expression
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Calls visit(word, begin) for the names in an expression, but not for numbers.
template <class Visit> void for_words(const std::string& text, const Visit& visit) {
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        if (is_word(text[i]))
            while (end < text.size() && (is_word(text[end]) || text[end] == '.')) ++end;
        if (is_word(text[i]) && std::isdigit(static_cast<unsigned char>(text[i])) == 0)
            visit(text.substr(i, end - i));
        i = end;
    }
}

std::vector<Statement> statements_of(const char* program) {
    std::vector<Statement> all;
    std::string rest = program;
    while (!rest.empty()) {
        std::string line = rest.substr(0, rest.find('\n'));
        rest.erase(0, line.size() + 1);
        Statement s;
        if (line.starts_with("vec3 ")) {
            s.is_vector = true;
            line.erase(0, 5);
        }
        s.name = line.substr(0, line.find(' '));
        s.expression = line.substr(line.find("= ") + 1);  // with its leading space
        all.push_back(s);
    }
    return all;
}

void make_mistakes(Statement& s, const Shading& shading, Reflection model) {
    const bool rough = info_of(model).rough_diffuse;
    for (const Change& change : changes) {
        const std::size_t at = s.expression.find(change.right);
        if (!(shading.mistakes.*change.flag) || at == s.expression.npos) continue;
        // The roughness factor, which multiplies the clamped cosine, is never negative and stays unchanged.
        if (change.flag == &Mistakes::no_clamp_of_cosine && rough) continue;
        s.expression.replace(at, change.right.size(), change.wrong);
        s.mistakes.push_back(name_of_flag(change.flag));
    }
    if (shading.power_table == 0) return;
    if (const std::size_t at = s.expression.find(" power("); at != s.expression.npos)
        s.expression.replace(at, 7, " table_power(");
}

/// Returns the statements on which the requested results depend.
std::vector<Statement> wanted(const std::vector<Statement>& all, Flags names) {
    std::vector<Statement> kept;
    for (auto s = all.rbegin(); s != all.rend(); ++s) {
        if (!names.contains(s->name)) continue;
        for_words(s->expression, [&names](const std::string& word) { names.insert(word); });
        kept.insert(kept.begin(), *s);
    }
    return kept;
}

/// Returns a word of the formula notation as the language spells it.
std::string spelled(const std::string& word, Language language) {
    if (word == "shininess" || word == "roughness" || word == "f0") return "m." + word;
    if (language != Language::Cpp) return word;
    if (word == "n" || word == "v") return "at." + word;
    for (const char* function : {"max", "sqrt", "pow", "abs"})
        if (word == function) return "std::" + word;
    return word;
}

std::string expression_in(const std::string& text, Language language) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        if (is_word(text[i]))
            while (end < text.size() && (is_word(text[end]) || text[end] == '.')) ++end;
        out += spelled(text.substr(i, end - i), language);
        i = end;
    }
    return out;
}

bool is_result(const Statement& s) { return s.name == "diffuse" || s.name == "S"; }

const char* number_type(Language language) { return language == Language::Cpp ? "double" : "float"; }

/// `assigns`: the results are already declared, S as a vector if `as_vector`.
std::string line_of(const Statement& s, Language language, bool assigns, bool as_vector) {
    std::string right = s.name + " =" + expression_in(s.expression, language);
    if (language == Language::Python) return right;
    if (assigns && is_result(s)) {
        const char* const ones = language == Language::Cpp ? " * vec3{1, 1, 1}" : " * vec3(1.0)";
        return right + (as_vector && s.name == "S" && !s.is_vector ? ones : "") + ";";
    }
    const char* constant = language == Language::Cpp && !is_result(s) ? "const " : "";
    return fmt::format("{}{} {};", constant, s.is_vector ? "vec3" : number_type(language), right);
}

/// The statements of one model, with the scene's mistakes.
std::vector<Statement> model_statements(const Shading& shading, Reflection model, bool diffuse_wanted) {
    const bool half = shading.mistakes.half_angle_with_phong_shininess && model == Reflection::Phong;
    if (half) model = Reflection::BlinnPhong;
    std::vector<Statement> statements = statements_of(info_of(model).program);
    for (Statement& s : statements) {
        make_mistakes(s, shading, model);
        if (half && s.name == "S") s.mistakes.emplace_back("half_angle_with_phong_shininess");
    }
    Flags results;
    if (diffuse_wanted) results.insert("diffuse");
    if (shading.terms.specular) results.insert("S");
    return wanted(statements, results);
}

bool has_vector_s(const std::vector<Statement>& statements) {
    return std::ranges::any_of(statements, [](const Statement& s) { return s.name == "S" && s.is_vector; });
}

}  // namespace

std::string identifier_of(Reflection model) {
    std::string name(name_of(model));
    std::ranges::replace(name, '-', '_');
    return name;
}

ModelText model_text(const Shading& shading, const std::vector<Reflection>& models, bool diffuse_wanted,
                     Language language, const std::string& indent) {
    const bool several = models.size() > 1, python = language == Language::Python;
    std::vector<std::vector<Statement>> of_models;
    of_models.reserve(models.size());
    for (const Reflection model : models)
        of_models.push_back(model_statements(shading, model, diffuse_wanted));
    const bool as_vector = several && std::ranges::any_of(of_models, has_vector_s);
    ModelText out;
    if (several && python) out.text += indent + "diffuse, S = 0.0, 0.0\n";
    if (several && !python)
        out.text += fmt::format("{0}{1} diffuse = 0.0;\n{0}{2};\n", indent, number_type(language),
                                !as_vector                  ? number_type(language) + std::string(" S = 0.0")
                                : language == Language::Cpp ? "vec3 S"
                                                            : "vec3 S = vec3(0.0)");
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (of_models[i].empty()) continue;
        const std::string within = indent + (several ? "    " : "");
        if (several)
            out.text +=
                fmt::format(fmt::runtime(python ? "{}if m.model == \"{}\":\n" : "{}if (m.model == {}) {{\n"),
                            indent, identifier_of(models[i]));
        for (const Statement& s : of_models[i]) {
            for (const std::string_view mistake : s.mistakes)
                out.text += within + (python ? "# " : "// ") + mistake_comment(mistake) + "\n";
            out.text += within + line_of(s, language, several, as_vector) + "\n";
            out.uses.insert("uses." + s.name);
            for_words(s.expression, [&out](const std::string& word) { out.uses.insert("uses." + word); });
        }
        if (several && !python) out.text += indent + "}\n";
    }
    if (!out.text.empty()) out.text.pop_back();  // the template supplies the last line end
    return out;
}

namespace {

void add_vectors(std::string& text, const char* name, const std::vector<glm::vec3>& vectors) {
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{} {}\n", name, vectors.size());
    for (const glm::vec3& v : vectors) fmt::format_to(out, "{} {} {}\n", v.x, v.y, v.z);
}

/// Whether corner c has a normal (from the file or analytic).
bool has_own_normal(const Object& object, std::size_t corner) {
    const Mesh& mesh = *object.mesh;
    const NormalSource source = object.normals.source;
    if (source == NormalSource::Facet || source == NormalSource::Vertex) return false;
    if (mesh.given_normals == GivenNormals::None) return false;
    const std::uint32_t given = mesh.given_normal_of(corner);
    return given != no_index && mesh.normals[given] != glm::vec3(0);
}

/// The normals of corner_normals(), or those that an incorrect program reads instead.
std::vector<glm::vec3> normals_as_read(const Object& object, const CornerNormals& right,
                                       const Mistakes& mistakes) {
    std::vector<glm::vec3> normals = right.normals;
    const Mesh& mesh = *object.mesh;
    std::vector<bool> done(normals.size());
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t which = right.corner.empty() ? mesh.corner_position[c] : right.corner[c];
        if (done[which]) continue;
        done[which] = true;
        const bool own = has_own_normal(object, c);
        if (mistakes.cross_reversed && !own) normals[which] = -normals[which];
        // Normals from a file keep their length.
        if (mistakes.unnormalized_normals && own && mesh.given_normals == GivenNormals::File)
            normals[which] *= glm::length(mesh.normals[mesh.given_normal_of(c)]);
    }
    return normals;
}

}  // namespace

std::string mesh_text(const Object& object, const Mistakes& mistakes) {
    const Mesh& mesh = *object.mesh;
    const CornerNormals normals = corner_normals(mesh, object.normals);
    std::string text;
    auto out = std::back_inserter(text);
    add_vectors(text, "positions", mesh.positions);
    add_vectors(text, "normals", normals_as_read(object, normals, mistakes));
    add_vectors(text, "colors", mesh.colors);
    fmt::format_to(out, "faces {}\n", mesh.face_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        fmt::format_to(out, "{}", mesh.first_corner[f + 1] - mesh.first_corner[f]);
        for (std::size_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t position = mesh.corner_position[c];
            fmt::format_to(out, "  {} {}", position, normals.corner.empty() ? position : normals.corner[c]);
        }
        text += '\n';
    }
    fmt::format_to(out, "triangles {}\n", mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t first = mesh.first_corner[t.face];
        fmt::format_to(out, "{} {} {} {}\n", t.face, t.corner[0] - first, t.corner[1] - first,
                       t.corner[2] - first);
    }
    return text;
}

namespace {

constexpr std::string_view wrong_prefix = "wrong.", calls_word = "calls";

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(separator);
        if (std::string_view part = text.substr(0, at); !part.empty()) parts.push_back(part);
        if (at == text.npos) return parts;
        text.remove_prefix(at + 1);
    }
}

/// A line of a text: the text before its directive, the directive's word, and the rest.
struct Line {
    std::string_view indent, comment;  // comment: "//" or "#"
    std::string_view word, rest;       // word: empty if the line is not a directive
};

Line parsed(std::string_view line) {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    std::string_view body = line.substr(start);
    for (const std::string_view comment : {std::string_view("//"), std::string_view("#")}) {
        if (!body.starts_with(comment) || body.substr(comment.size(), 1) != "@") continue;
        body.remove_prefix(comment.size() + 1);
        const std::size_t end = std::min(body.find(' '), body.size());
        return {line.substr(0, start), comment, body.substr(0, end),
                body.substr(std::min(end + 1, body.size()))};
    }
    return {};
}

template <class Visit> void for_lines(std::string_view text, const Visit& visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        visit(text.substr(0, text[end] == '\n' ? end : end + 1));
        text.remove_prefix(end + 1);
    }
}

bool holds(std::string_view condition, const Flags& on) {
    const auto term_holds = [&on](std::string_view term) {
        const bool negated = term.starts_with('!');
        return (on.find(term.substr(negated ? 1 : 0)) != on.end()) != negated;
    };
    const auto all_hold = [&](std::string_view terms) {
        const auto parts = split(terms, '&');
        return std::all_of(parts.begin(), parts.end(), term_holds);
    };
    const auto parts = split(condition, '|');
    return std::any_of(parts.begin(), parts.end(), all_hold);
}

/// The flags of a condition, including the "!" of negated ones.
std::vector<std::string_view> terms_of(std::string_view condition) {
    std::vector<std::string_view> all;
    for (const std::string_view part : split(condition, '|'))
        for (const std::string_view term : split(part, '&')) all.push_back(term);
    return all;
}

/// Returns the line with its placeholders replaced. A value of several lines is indented like its
/// placeholder.
std::string with_values(std::string_view line, const Values& values) {
    std::string out;
    while (true) {
        const std::size_t at = line.find('@'), end = line.find('@', at + 1);
        const auto value = end == line.npos ? values.end() : values.find(line.substr(at + 1, end - at - 1));
        if (end == line.npos) return out.append(line);
        out.append(line.substr(0, at));
        if (value != values.end()) {
            out.append(value->second);
            line.remove_prefix(end + 1);
        } else {
            out.append("@");
            line.remove_prefix(at + 1);
        }
    }
}

}  // namespace

Flags mentioned_flags(std::string_view text) {
    Flags flags;
    for_lines(text, [&flags](std::string_view raw) {
        const Line line = parsed(raw);
        if (line.word == "can")
            for (const std::string_view flag : split(line.rest, ' ')) flags.emplace(flag);
        if (line.word != "if") return;
        for (std::string_view term : terms_of(line.rest)) {
            if (term.starts_with('!')) term.remove_prefix(1);
            flags.emplace(term);
        }
    });
    return flags;
}

std::string_view lines_of_calls(std::string_view text, std::string_view name) {
    std::string_view lines;
    bool inside = false;
    for_lines(text, [&](std::string_view raw) {
        const Line line = parsed(raw);
        if (line.word == calls_word) inside = line.rest == name;
        if (!inside || line.word == calls_word) return;
        if (lines.empty()) lines = raw;
        lines = {lines.data(), static_cast<std::size_t>(raw.data() + raw.size() + 1 - lines.data())};
    });
    return lines;
}

std::string mistake_comment(std::string_view name) {
    for (const MistakeName& mistake : mistake_names())
        if (mistake.name == name) return fmt::format("MISTAKE {}: {}", name, mistake.what);
    return {};
}

std::string filled(std::string_view text, const Flags& on, const Values& values) {
    std::string out;
    std::vector<bool> shown{true};  // one for each open condition
    const auto all_shown = [&shown] { return std::find(shown.begin(), shown.end(), false) == shown.end(); };
    for_lines(text, [&](std::string_view raw) {
        const Line line = parsed(raw);
        if (line.word == "can" || line.word == calls_word) return;
        if (line.word == "if") {
            shown.push_back(holds(line.rest, on));
            if (!all_shown()) return;
            for (const std::string_view term : terms_of(line.rest))
                if (term.starts_with(wrong_prefix) && on.find(term) != on.end())
                    out += fmt::format("{}{} {}\n", line.indent, line.comment,
                                       mistake_comment(term.substr(wrong_prefix.size())));
        } else if (line.word == "else") {
            shown.back() = !shown.back();
        } else if (line.word == "end") {
            shown.pop_back();
        } else if (all_shown()) {
            const std::string whole = with_values(raw, values);
            if (whole.empty() && !raw.empty()) return;  // omits a line whose values are empty
            out.append(whole).append("\n");
        }
    });
    return out;
}

}  // namespace glint
