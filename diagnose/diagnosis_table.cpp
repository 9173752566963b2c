// Diagnoses of many pictures as a table, in CSV and in HTML.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "diagnose/diagnosis_format.h"
#include "diagnose/search/display_change.h"
#include "models/utf8.h"
#include "renderer/image/compare.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

constexpr int thumbnail_side = 160;

PictureSize thumbnail_size(PictureSize size) {
    const int longest = std::max({size.width, size.height, thumbnail_side});
    return {std::max(1, size.width * thumbnail_side / longest),
            std::max(1, size.height * thumbnail_side / longest)};
}

constexpr std::array columns{"picture",  "verdict", "mistake",    "also", "explained",
                             "residual", "display", "experiment", "why"};
using Row = std::array<std::string, columns.size()>;

Row row_of(const DiagnosedPicture& p) {
    const Diagnosis& d = p.diagnosis;
    Row row;
    row[0] = on_one_line(p.name);
    row[1] = verdict_text(d.verdict);
    if (!d.candidates.empty() && is_explained(d.verdict)) {
        const Candidate& c = d.candidates.front();
        row[2] = c.name;
        row[3] = fmt::format("{}", fmt::join(c.also_named, ", "));
        row[4] = fmt::format("{:.3f}", c.explained);
        row[5] = fmt::format("{:.2f}", c.residual);
    }
    row[6] = display_text(d.display);
    if (d.experiment)
        for (const Assignment& a : d.experiment->set)
            row[7] = fmt::format("{}{}--set {}={}", row[7], row[7].empty() ? "" : " ", a.pointer, a.json);
    row[8] = d.why;
    return row;
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

constexpr std::string_view style =
    "body{font:16px/1.4 system-ui,sans-serif;margin:2em}table{border-collapse:collapse}"
    "th,td{text-align:left;vertical-align:top;padding:.5em .8em;border-bottom:1px solid #8884}"
    "code{font-size:.9em}img{display:block}:root{color-scheme:light dark}";

std::string html_row(const DiagnosedPicture& p) {
    const Row row = row_of(p);
    std::string words = fmt::format("<b>{}</b>", html_escaped(row[1]));
    if (!row[2].empty()) words += fmt::format("<br><code>{}</code>", html_escaped(row[2]));
    if (!row[3].empty()) words += fmt::format("<br>looks the same: <code>{}</code>", html_escaped(row[3]));
    if (!row[8].empty()) words += fmt::format("<br>{}", html_escaped(row[8]));
    const std::string share =
        row[4].empty() ? "" : fmt::format("{} %", explained_percent(p.diagnosis.candidates[0]));
    const auto image = [](const Picture& picture, const char* alt) {
        return picture.rgba.empty() ? std::string() : html_image(picture, alt);
    };
    return fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td><code>{}</code></td></"
        "tr>\n",
        html_escaped(row[0]), image(p.thumbnail, "as submitted"), image(p.as_explained, "as Glint draws it"),
        words, share, html_escaped(row[6]), html_escaped(row[7]));
}

}  // namespace

DiagnosedPicture diagnosed_picture(const std::string& name, Diagnosis diagnosis, const Scene& scene,
                                   const Picture& wrong, int threads) {
    const PictureSize size = thumbnail_size(wrong.size);
    const Scene shown = is_explained(diagnosis.verdict) ? scene_under(scene, diagnosis.candidates.front())
                                                        : under_mistakes(scene, {});
    Renderer renderer(threads);
    return {name, std::move(diagnosis), resampled(wrong, size), renderer.render(shown, size)};
}

std::string diagnoses_csv(const std::vector<DiagnosedPicture>& pictures) {
    std::string text = fmt::format("{}\n", fmt::join(columns, ","));
    for (const DiagnosedPicture& p : pictures) {
        Row row = row_of(p);
        // Still names the file; a spreadsheet takes a field that begins with one of these for a formula.
        if (!p.name.empty() && std::string_view("=+-@").find(p.name[0]) != std::string_view::npos)
            row[0].insert(0, "./");
        for (std::string& field : row) field = csv_field(field);
        text += fmt::format("{}\n", fmt::join(row, ","));
    }
    return text;
}

std::string diagnoses_html(const std::vector<DiagnosedPicture>& pictures, const std::string& title) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
        "charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>"
        "<body>\n<h1>Pictures of {0}</h1>\n<table>\n<tr><th>Picture</th><th>Yours</th><th>Glint's</th>"
        "<th>Verdict</th><th>Explained</th><th>Set aside first</th><th>To be sure, draw with</th></tr>\n",
        html_escaped(title), style);
    for (const DiagnosedPicture& p : pictures) html += html_row(p);
    return html + "</table>\n</body></html>\n";
}

namespace {

const SheetAxis one_row{"/", {""}};

SheetAxis columns_of(const Diagnosis& d) {
    SheetAxis axis{"/", {"yours", "right"}};
    if (!d.candidates.empty()) axis.values.push_back(name_of(d.candidates.front().mistakes));
    axis.values.emplace_back("yours - right");
    return axis;
}

/// Returns the picture of the scene as the diagnosed display would show it.
Picture as_displayed(Picture picture, const DisplayChange& change) {
    const ByteRanges ranges = byte_ranges(change);
    for (std::size_t pixel = 0; pixel < picture.size.pixels(); ++pixel) {
        const Rgb colour = shown(ranges, rgb_at(picture, pixel));
        std::copy(colour.begin(), colour.end(), &picture.rgba[4 * pixel]);
    }
    return picture;
}

/// The wrong picture the right way up, its channels in order.
Picture upright(const Picture& wrong, const DisplayChange& change) {
    Picture picture{wrong.size, std::vector<std::uint8_t>(wrong.rgba.size(), 255), {}};
    for (int y = 0; y < wrong.size.height; ++y)
        for (int x = 0; x < wrong.size.width; ++x) {
            const Rgb colour = mine_at(wrong, change, x, y);
            std::copy(colour.begin(), colour.end(), &picture.rgba[4 * wrong.pixel(x, y)]);
        }
    return picture;
}

/// The byte that the change maps closest to this level.
std::uint8_t drawn_byte(const ByteRanges& ranges, std::uint8_t wrong) {
    const auto nearest = std::min_element(
        ranges.begin(), ranges.end(),
        [wrong](const auto& a, const auto& b) { return a.from_middle(wrong) < b.from_middle(wrong); });
    return static_cast<std::uint8_t>(nearest - ranges.begin());
}

}  // namespace

Picture undone(const Picture& wrong, const DisplayChange& change) {
    Picture picture = upright(wrong, change);
    const ByteRanges ranges = byte_ranges(change);
    std::array<std::uint8_t, 256> drawn{};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        drawn[i] = drawn_byte(ranges, static_cast<std::uint8_t>(i));
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) picture.rgba[i] = drawn[picture.rgba[i]];
    return picture;
}

PictureSize diagnosis_sheet_size(const Diagnosis& d, const Font& font) {
    return sheet_size(one_row, columns_of(d), d.size, font);
}

Picture diagnosis_sheet(const Diagnosis& d, const Scene& scene, const Picture& wrong, const Font& font,
                        int threads) {
    const DisplayChange& change = d.display.change;
    Renderer renderer(threads);
    std::vector<Picture> cells{upright(wrong, change)};
    cells.push_back(as_displayed(renderer.render(under_mistakes(scene, {}), d.size), change));
    const Comparison far = std::get<Comparison>(compare(cells[0], cells[1]));
    Picture difference = difference_picture(cells[0], cells[1], difference_gain(far));
    if (!d.candidates.empty())
        cells.push_back(
            as_displayed(renderer.render(scene_under(scene, d.candidates.front()), d.size), change));
    cells.push_back(std::move(difference));
    return make_sheet(one_row, columns_of(d), d.size, font,
                      [&](std::size_t, std::size_t column) -> const Picture& { return cells[column]; });
}

}  // namespace glint
