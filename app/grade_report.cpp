#include "app/grade_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "models/json/json.h"
#include "models/scene/mistakes.h"
#include "models/utf8.h"

namespace glint {
namespace {

constexpr std::array verdicts{
    "mistake",        "left out",       "another setting", "another number", "not in the catalogue",
    "not comparable", does_not_compile, does_not_end,      not_judged};
constexpr Range points_range{-1e6, 1e6, "a number"};

RubricEntry entry_of(const Node& node) {
    RubricEntry entry;
    node.allow_keys({"points", "hint"});
    node.with("points", [&](const Node& points) { entry.points = number(points, points_range); });
    node.with("hint", [&](const Node& hint) { entry.hint = text(hint); });
    return entry;
}

/// Reads the object's members, whose keys must be in `known`.
std::map<std::string, RubricEntry, std::less<>> entries_of(const Node& node,
                                                           const std::vector<std::string>& known) {
    std::map<std::string, RubricEntry, std::less<>> entries;
    if (!node.value().is_object()) node.wrong_type("an object");
    node.allow_keys(known);
    for (const auto& [key, value] : members_of(node.value())) entries[key] = entry_of(Node(value, node, key));
    return entries;
}

std::string string_of(const GradeRow& row, std::string_view key) {
    const Json* const found = find_member(row, key);
    if (found == nullptr || found->is_null()) return {};
    return found->is_string() ? found->get<std::string>() : json_line(*found);
}

/// Returns the strings of a list, each as one line.
std::vector<std::string> strings_of(const GradeRow& row, std::string_view key) {
    std::vector<std::string> strings;
    const Json* const found = find_member(row, key);
    if (found == nullptr) return strings;
    for (const Json& one : elements_of(*found)) strings.push_back(on_one_line(one.get<std::string>()));
    return strings;
}

bool has_points(const std::vector<GradeRow>& rows) {
    return std::any_of(rows.begin(), rows.end(),
                       [](const GradeRow& row) { return !string_of(row, "points").empty(); });
}

/// "mistake: reflect_sign".
std::string finding_of(const GradeRow& row) {
    const std::string mistake = string_of(row, "mistake");
    return string_of(row, "verdict") + (mistake.empty() ? "" : ": " + mistake);
}

std::string csv_field(std::string text) {
    if (!text.empty() && std::string_view("=+-@\t").find(text[0]) != std::string_view::npos)
        text.insert(0, "'");  // keeps spreadsheets from reading it as a formula
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string(2, c) : std::string(1, c);
    return quoted + "\"";
}

/// "537,188", or empty.
std::string pixel_of(const GradeRow& row, const char* separator) {
    const Json* const pixel = find_member(row, "pixel");
    if (pixel == nullptr) return {};
    return fmt::format("{}{}{}", (*pixel)[0].get<int>(), separator, (*pixel)[1].get<int>());
}

/// "rgb(1,2,3)", or empty.
std::string color_of(const GradeRow& row, std::string_view key) {
    const Json* const found = find_member(row, key);
    if (found == nullptr || !found->is_array()) return {};
    std::vector<int> channels;
    for (const Json& channel : elements_of(*found)) channels.push_back(channel.get<int>());
    return fmt::format("rgb({})", fmt::join(channels, ","));
}

/// The position of the deciding pixel in a small picture, as a fraction of its size.
std::string ring(const GradeRow& row) {
    const Json *const pixel = find_member(row, "pixel"), *const size = find_member(row, "size");
    if (pixel == nullptr || size == nullptr) return {};
    const auto share = [&](std::size_t i) {
        return 100 * ((*pixel)[i].get<double>() + 0.5) / std::max(1.0, (*size)[i].get<double>());
    };
    return fmt::format("<i style=\"left:{:.2f}%;top:{:.2f}%\"></i>", share(0), share(1));
}

constexpr std::string_view style =
    "body{font:16px/1.45 system-ui,sans-serif;margin:2em auto;max-width:75em;padding:0 1em}"
    "table{border-collapse:collapse;width:100%}th,td{text-align:left;vertical-align:top;padding:.6em .8em;"
    "border-bottom:1px solid #8884}figure{margin:0;position:relative;display:inline-block}img{display:block}"
    "i{position:absolute;width:14px;height:14px;margin:-9px;border:2px solid #fff;border-radius:50%;"
    "box-shadow:0 0 0 2px #000}b.s{display:inline-block;width:1em;height:1em;vertical-align:-.15em;"
    "border:1px solid #888}code{font-size:.9em}.right{color:#187a2f}.wrong{color:#b3261e}p{margin:.3em 0}"
    "pre{margin:.3em 0;white-space:pre-wrap;font-size:.9em}:root{color-scheme:light dark}"
    "@media(prefers-color-scheme:dark){.right{color:#7bd88f}.wrong{color:#ff9a92}}";

std::string figure(const GradeRow& row, std::string_view key) {
    const std::string image = string_of(row, key);
    return image.empty() ? "" : "<figure>" + image + ring(row) + "</figure>";
}

std::string html_row(const GradeRow& row, bool points) {
    const bool is_right = string_of(row, "verdict") == "no mistake";
    std::string cell =
        fmt::format("<b class=\"{}\">{}</b>", is_right ? "right" : "wrong", html_escaped(finding_of(row)));
    const auto paragraph = [&cell](const std::string& html) {
        if (!html.empty()) cell += "<p>" + html + "</p>";
    };
    const std::string hint = string_of(row, "hint"),
                      also = fmt::format("{}", fmt::join(strings_of(row, "also"), ", "));
    paragraph(html_escaped(string_of(row, "text")));
    paragraph(hint.empty() ? "" : "<em>" + html_escaped(hint) + "</em>");
    paragraph(also.empty() ? "" : "Looks the same here: <code>" + html_escaped(also) + "</code>");
    if (const std::string mine = color_of(row, "mine"); !mine.empty())
        paragraph(fmt::format(
            "Pixel {}: yours <b class=\"s\" style=\"background:{}\"></b> {}, correct "
            "<b class=\"s\" style=\"background:{}\"></b> {}",
            pixel_of(row, ","), mine, mine, color_of(row, "reference"), color_of(row, "reference")));
    for (const std::string& message : strings_of(row, "messages"))
        cell += "<pre>" + html_escaped(message) + "</pre>";
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}</tr>\n",
                       html_escaped(string_of(row, "file")), figure(row, "picture_html"),
                       figure(row, "reference_html"), cell,
                       points ? "<td>" + html_escaped(string_of(row, "points")) + "</td>" : "");
}

}  // namespace

Result<Rubric> read_rubric(const std::string& text, const std::string& file) {
    return result_of(file, [&] {
        const Json json = parsed_json(text, file);
        const Node root(json);
        if (!json.is_object()) root.wrong_type("an object");
        root.allow_keys({"points", "mistakes", "verdicts"});
        std::vector<std::string> names;
        for (const MistakeName& mistake : mistake_names()) names.emplace_back(mistake.name);
        Rubric rubric;
        root.with("points", [&](const Node& node) { rubric.points = number(node, points_range); });
        root.with("mistakes", [&](const Node& node) { rubric.mistakes = entries_of(node, names); });
        root.with("verdicts", [&](const Node& node) {
            rubric.verdicts = entries_of(node, {verdicts.begin(), verdicts.end()});
        });
        return rubric;
    });
}

void apply_rubric(GradeRow& row, const Rubric& rubric) {
    const std::string verdict = string_of(row, "verdict");
    std::vector<std::string> names = strings_of(row, "also");  // they look the same
    names.insert(names.begin(), string_of(row, "mistake"));
    RubricEntry entry;
    if (verdict == "no mistake") {
        entry.points = rubric.points;
    } else {
        if (const auto found = rubric.verdicts.find(verdict); found != rubric.verdicts.end())
            entry = found->second;
        for (const std::string& name : names) {
            const auto found = rubric.mistakes.find(name);
            if (found == rubric.mistakes.end()) continue;
            if (found->second.points) entry.points = found->second.points;
            if (!found->second.hint.empty()) entry.hint = found->second.hint;
            break;
        }
        if (!entry.points && rubric.points) entry.points = 0;
    }
    row["points"] = entry.points ? number_json(static_cast<float>(*entry.points)) : Json();
    row["hint"] = entry.hint;
}

bool is_judged(const GradeRow& row) { return string_of(row, "verdict") != not_judged; }

std::string grades_text(const std::vector<GradeRow>& rows) {
    const bool points = has_points(rows);
    std::size_t widest = std::string_view("file").size();
    for (const GradeRow& row : rows) widest = std::max(widest, on_one_line(string_of(row, "file")).size());
    const std::size_t indent = widest + 2 + (points ? 8 : 0);
    std::string text;
    const auto line = [&](const std::string& file, const std::string& point, const std::string& rest) {
        text += fmt::format("{:<{}}  ", file, widest);
        if (points) text += fmt::format("{:>6}  ", point);
        text += rest + "\n";
    };
    line("file", "points", "verdict");
    for (const GradeRow& row : rows) {
        line(on_one_line(string_of(row, "file")), string_of(row, "points"), finding_of(row));
        std::vector<std::string> more = strings_of(row, "messages");
        if (const std::string hint = string_of(row, "hint"); !hint.empty())
            more.insert(more.begin(), on_one_line(hint));
        for (const std::string& message : more) text += std::string(indent, ' ') + message + "\n";
    }
    return text;
}

std::string grades_json(const std::vector<GradeRow>& rows) {
    std::string lines;
    for (GradeRow row : rows) {
        row.erase("picture_html");
        row.erase("reference_html");
        lines += json_line(row) + "\n";
    }
    return lines;
}

std::string grades_csv(const std::vector<GradeRow>& rows) {
    std::string text = "file,verdict,mistake,also,points,hint,pixel,messages\n";
    for (const GradeRow& row : rows) {
        const std::array fields{
            string_of(row, "file"),    string_of(row, "verdict"),
            string_of(row, "mistake"), fmt::format("{}", fmt::join(strings_of(row, "also"), ", ")),
            string_of(row, "points"),  string_of(row, "hint"),
            pixel_of(row, " "),        fmt::format("{}", fmt::join(strings_of(row, "messages"), "; "))};
        for (std::size_t i = 0; i < fields.size(); ++i)
            text +=
                (i > 0 ? "," : "") + (i == 4 ? fields[i] : csv_field(fields[i]));  // points may be negative
        text += "\n";
    }
    return text;
}

std::string grades_html(const std::vector<GradeRow>& rows, const std::string& title) {
    const bool points = has_points(rows);
    const auto right = std::count_if(rows.begin(), rows.end(), [](const GradeRow& row) {
        return string_of(row, "verdict") == "no mistake";
    });
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
        "charset=\"utf-8\"><title>{0}</title><style>{1}</style>"
        "</head><body>\n<h1>Grades: {0}</h1>\n<p>{2} of {3} without a "
        "mistake.</p>\n<table>\n<tr><th>File</th>"
        "<th>Yours</th><th>Correct</th><th>Verdict</th>{4}</tr>\n",
        html_escaped(title), style, right, rows.size(), points ? "<th>Points</th>" : "");
    for (const GradeRow& row : rows) html += html_row(row, points);
    return html + "</table>\n</body></html>\n";
}

std::string grades_junit(const std::vector<GradeRow>& rows, const std::string& title) {
    std::string cases;
    std::size_t failures = 0, errors = 0;
    for (const GradeRow& row : rows) {
        cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", html_escaped(title),
                             html_escaped(string_of(row, "file")));
        if (string_of(row, "verdict") == "no mistake") {
            cases += "/>\n";
            continue;
        }
        ++(is_judged(row) ? failures : errors);
        const char* const kind = is_judged(row) ? "failure" : "error";
        std::vector<std::string> more = strings_of(row, "messages");
        for (const char* key : {"text", "hint"})
            if (std::string text = string_of(row, key); !text.empty()) more.push_back(std::move(text));
        cases +=
            fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n", kind,
                        html_escaped(finding_of(row)), html_escaped(fmt::format("{}", fmt::join(more, " "))));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
        "errors=\"{}\">\n{}</testsuite>\n",
        html_escaped(title), rows.size(), failures, errors, cases);
}

}  // namespace glint
