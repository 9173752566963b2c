// The tab "My picture": the mistakes in the user's picture.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>

#include "diagnose/diagnosis_format.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/mistake_row.h"
#include "ui/features/views/small_pictures.h"
#include "ui/picture/screen.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr float shown_share = 0.5f;  // logical pixels per thumbnail pixel: sharp on high-resolution displays

std::string what_is_done(const MistakeSet& mistakes) {
    std::string text;
    for (const std::size_t i : mistakes)
        text += fmt::format("{}{} {}", text.empty() ? "" : "\n", mistake_names()[i].what,
                            mistake_names()[i].looks);
    return text;
}

bool are_on(const Scene& scene, const MistakeSet& mistakes) {
    return under_mistakes(scene, mistakes).shading.mistakes == scene.shading.mistakes;
}

/// Hovering over the last item previews the scene with these mistakes; a click switches them on or off.
void offer(UiState& state, const MistakeSet& mistakes, bool clicked) {
    const bool pointed = is_pointed_at();
    const std::string title = title_of(mistakes);
    tooltip(title.c_str(), what_is_done(mistakes).c_str(), "Hover to preview, click to switch",
            fmt::format("/shading/mistakes/{}", mistake_names()[mistakes.front()].name));
    Scene& scene = state.editor.scene();
    if (clicked) switch_mistakes(scene, mistakes);
    if (pointed && !are_on(scene, mistakes)) show_instead(state, under_mistakes(scene, mistakes), title);
}

void heading(UiState& state) {
    const MyPictureState& mine = state.get<MyPictureState>();
    const PictureSize size = mine.shown->size;
    ImGui::AlignTextToFramePadding();
    mono_text(fmt::format("{}×{}", size.width, size.height));
    ImGui::SameLine(0, px(10));
    const float end = ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(at, {ImGui::GetWindowPos().x + end - px(4), at.y + ImGui::GetFrameHeight()}, true);
    ImGui::TextUnformatted(whole_label(mine.name).c_str());
    ImGui::PopClipRect();
    ImGui::SameLine(end);
    if (icon_button("##away", Icon::Close)) put_picture_away(state);
    tooltip("Close my picture", "Restores the previous comparison");
}

/// Draws the progress of the diagnosis and a button that cancels it, or restarts it when it is not running.
void progress(MyPictureState& mine) {
    if (mine.current || mine.is_outdated) return;
    const LoadProgress* now = mine.job ? &mine.job->progress() : nullptr;
    if (!mine.settled) {
        const float share = now != nullptr ? std::max(0.0f, progress_share(*now)) : 0;
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, theme().accent);
        ImGui::ProgressBar(share, {ImGui::GetContentRegionAvail().x, px(4)}, "");
        ImGui::PopStyleColor();
    }
    if (ImGui::Button(mine.settled ? "Look for the mistake" : "Cancel")) {
        if (mine.settled)
            ask_again(mine);
        else
            cancel_diagnosis(mine);
    }
    tooltip(mine.settled ? "Look for the mistake" : "Cancel the search",
            "The picture stays next to the scene when no search is running");
    small_dim(mine.settled
                  ? "The search for the mistake was stopped."
                  : "Drawing the scene correctly and with each mistake, to compare with the picture.");
    if (mine.answer) small_dim("Below is what the previous search found.");
}

/// Errors and warnings about the file.
void messages(const MyPictureState& mine) {
    constexpr std::size_t most = 6;  // compilers repeat themselves
    for (std::size_t i = 0; i < std::min(most, mine.messages.size()); ++i)
        warning_text(mine.messages[i].text());
    if (mine.is_outdated) small_dim("The last picture is still shown, dimmed.");
}

/// The latest verdicts, if there is more than one.
void previous_verdicts(const MyPictureState& mine) {
    if (mine.verdicts.size() < 2) return;
    section_heading("Verdicts");
    for (const std::string& line : mine.verdicts) small_dim(line);
}

/// Draws the verdict in large type, then the display mistakes that were set aside, or full sentences if no
/// mistake explains the picture.
void verdict(const Diagnosis& d, const Scene& scene) {
    std::string word(verdict_text(d.verdict));
    word[0] = static_cast<char>(word[0] - 'a' + 'A');
    if (is_explained(d.verdict)) word += ": " + title_of(d.candidates.front());
    ImGui::Dummy({0, px(2)});
    ImGui::PushFont(fonts().title);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(word.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    if (!is_explained(d.verdict)) {
        std::string text = diagnosis_text(d, scene);
        text.erase(0, text.find(": ") + 2);  // the verdict, which is shown above
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
        text.pop_back();  // the final newline
        return wrapped_dim(text);
    }
    if (const std::string display = display_text(d.display); !display.empty())
        wrapped_dim("Set aside first, because it is not a lighting mistake: " + display + ".");
    if (d.verdict != Verdict::Mistake) wrapped_dim(d.candidates.front().words);
    ImGui::Dummy({0, px(2)});
}

/// Offers to look for two mistakes at once, which may explain the picture if no single one does.
void offer_pairs(MyPictureState& mine) {
    if (!why_no_pairs(mine).empty()) return;
    if (ImGui::Button("Look for two at once")) ask_for_pairs(mine);
    tooltip("Look for two mistakes at once",
            "Tries every pair in the catalogue, which takes a second or two");
}

/// Lets the user state the conventions of the program; the diagnosis takes them as given.
void known_conventions(MyPictureState& mine) {
    if (!fold("My program", !mine.conventions.empty())) return;
    for (const ConventionName& row : convention_names()) {
        const auto at = std::find(mine.conventions.begin(), mine.conventions.end(), row.name);
        bool has = at != mine.conventions.end();
        const bool switched = ImGui::Checkbox(row.label.data(), &has);
        tooltip(row.label.data(), row.words.data());
        if (!switched) continue;
        if (has)
            mine.conventions.emplace_back(row.name);
        else
            mine.conventions.erase(at);
        ask_again(mine);
    }
}

/// Draws a candidate's thumbnail and text, in a row tall enough for both.
void candidate_row(UiState& state, const Candidate& candidate, std::size_t index) {
    MyPictureState& mine = state.get<MyPictureState>();
    const PictureSize cell = mine.sheet.cell;
    const ImVec2 small = px(shown_share) * ImVec2(float(cell.width), float(cell.height));
    const float pad = px(5), width = ImGui::GetContentRegionAvail().x, left = small.x + 3 * pad;
    const std::string title = title_of(candidate);
    const std::string brightness = own_brightness(mine.answer->diagnosis, candidate);
    const std::string words =
        fmt::format("explains {} % of the error, leaves {:.2f} levels{}{}", explained_percent(candidate),
                    candidate.residual, brightness.empty() ? "" : ", ", brightness);
    const float wrap = std::max(width - left - pad, px(40));
    const ImVec2 title_size = ImGui::CalcTextSize(title.c_str(), nullptr, false, wrap);
    const ImVec2 words_size = fonts().small->CalcTextSizeA(small_text_height(), 1e9f, wrap, words.c_str());
    const float room = std::max(small.y, title_size.y + px(2) + words_size.y) + 2 * pad;
    const bool clicked = hit_area("##candidate", {width, room});
    if (clicked) mine.chosen = index;
    const auto [low, end] = last_item();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool on = !candidate.mistakes.empty() && are_on(state.editor.scene(), candidate.mistakes),
               hovered = ImGui::IsItemHovered();
    list.AddRectFilled(low, end, to_u32(hovered ? theme().field_hovered : theme().field), px(4));
    list.AddRect(low, end, to_u32(on ? theme().accent : theme().line), px(4), 0, px(on ? 2 : 1));
    const ImVec2 corner = low + pad * ImVec2(1, 1);
    mine.sheet.draw(list, static_cast<int>(index), corner, corner + small);
    const ImVec2 text{low.x + left, corner.y};
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), text, to_u32(theme().text), title.c_str(), nullptr,
                 wrap);
    list.AddText(fonts().small, small_text_height(), {text.x, text.y + title_size.y + px(2)},
                 to_u32(theme().dim_text), words.c_str(), nullptr, wrap);
    if (candidate.mistakes.empty()) {
        if (is_pointed_at()) show_instead(state, scene_under(state.editor.scene(), candidate), title);
        return;
    }
    offer(state, candidate.mistakes, clicked);
    for (const MistakeSet& like : candidate.also) {
        const std::string label = "or: " + title_of(like);
        const bool chosen = ImGui::Selectable(label.c_str(), are_on(state.editor.scene(), like));
        offer(state, like, chosen);
    }
}

void candidates(UiState& state) {
    const Diagnosis& d = state.get<MyPictureState>().answer->diagnosis;
    if (d.candidates.empty()) return;
    if (!is_explained(d.verdict)) section_heading("Nearest");
    for (std::size_t i = 0; i < d.candidates.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        candidate_row(state, d.candidates[i], i);
        ImGui::PopID();
    }
    const Candidate& c = d.candidates[std::min(state.get<MyPictureState>().chosen, d.candidates.size() - 1)];
    section_heading(fmt::format("Clearest at pixel {}, {}", c.pixel.x, c.pixel.y).c_str());
    if (small_button("Why?")) {
        pick_pixel_of_mine(state, c.pixel);
        state.get<InspectorState>().tab = InspectorTab::Equation;
    }
    tooltip("Why?", "Picks this pixel and shows which term differs in the equation");
    colour_line("mine", c.mine);
    colour_line("right", c.reference);
    colour_line(title_of(c).c_str(), c.as_mistaken);
}

/// The change to the scene that distinguishes the candidates, and the colour that each would then produce.
void experiment(UiState& state) {
    const Experiment* shown = shown_experiment(state);
    const Experiment* e = shown != nullptr ? shown : offered_experiment(state);
    if (e == nullptr) return;
    section_heading("To be sure");
    for (const Assignment& a : e->set) {
        const NamedNumber named = named_number(a.pointer, state.editor.scene());
        wrapped_dim(fmt::format("{} {} = {}", named.owner, named.what, a.json));
    }
    if (shown == nullptr) {
        if (ImGui::Button("Change the scene this way")) try_experiment(state, *e);
        tooltip("Change the scene this way",
                "Changes the scene in one undo step and picks the pixel that distinguishes the mistakes");
    } else {
        small_dim(fmt::format("The scene has this change ({} undoes it). Draw it with your program as well.",
                              keys_of(CommandId::Undo)));
    }
    small_dim(fmt::format("Pixel {}, {} of a {}×{} picture should then be:", e->pixel.x, e->pixel.y,
                          state.get<MyPictureState>().shown->size.width,
                          state.get<MyPictureState>().shown->size.height));
    for (std::size_t i = 0; i < e->shows.size(); ++i)
        colour_line(title_of(e->mistakes[i]).c_str(), e->shows[i]);
}

void nothing_brought(UiState& state) {
    inspector_empty_state(
        "Drop a picture of this scene that your own program drew (.png, .pfm, .exr), or your lighting "
        "equation (.glsl), onto the window: Glint names the mistake in it.");
    if (ImGui::Button("Blank shader…")) state.files.ask(blank_shader_purpose, offered_name(state, ".glsl"));
    tooltip("Blank shader…", "Writes a file with the steps of this scene's equation for you to fill in");
    const std::string& path = state.get<MyPictureState>().path;
    if (path.empty()) return;
    const std::string again =
        whole_label(fmt::format("Compare {} again", std::filesystem::path(path).filename().string()));
    if (ImGui::Button(again.c_str())) bring_picture(state, path);
    tooltip(again.c_str(), "The picture you compared last");
}

}  // namespace

std::string title_of(const Candidate& candidate) {
    return candidate.mistakes.empty() ? candidate.name : title_of(candidate.mistakes);
}

std::string finding_of(const Diagnosis& diagnosis) {
    return is_explained(diagnosis.verdict) ? title_of(diagnosis.candidates.front())
                                           : std::string(verdict_text(diagnosis.verdict));
}

std::string title_of(const MistakeSet& mistakes) {
    if (mistakes.empty()) return "right";
    std::string title;
    for (const std::size_t i : mistakes) title += (title.empty() ? "" : " + ") + title_of(mistake_names()[i]);
    return title;
}

void colour_line(const char* what, Rgb colour) {
    const float edge = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos(), high = low + edge * ImVec2(1, 1);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, IM_COL32(colour[0], colour[1], colour[2], 255), px(3));
    list.AddRect(low, high, to_u32(theme().line), px(3));
    ImGui::Dummy({edge, edge});
    ImGui::SameLine(0, px(6));
    mono_text(fmt::format("{:3} {:3} {:3}", colour[0], colour[1], colour[2]));
    ImGui::SameLine(0, px(8));
    wrapped_dim(what);
    list_control(what, "", last_item());
}

void my_picture_tab(UiState& state, const PictureView&) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (!mine.shown) {
        if (mine.reading) return wrapped_dim("Reading " + mine.reading->name());
        return nothing_brought(state);
    }
    heading(state);
    if (!mine.shown) return;  // the picture was closed
    messages(mine);
    progress(mine);
    if (mine.answer && !mine.is_outdated) {
        verdict(mine.answer->diagnosis, state.editor.scene());
        offer_pairs(mine);
    }
    if (is_shader(mine.path)) shader_editor(state);
    if (mine.answer && !mine.is_outdated) {
        candidates(state);
        experiment(state);
    }
    known_conventions(mine);
    previous_verdicts(mine);
}

// The picked pixel in the user's picture, the correct pixel, and the pixel under the chosen mistake, term by
// term.

namespace {

/// Explains the pixel in the scene with these mistakes. Draws the scene, because a mistake may change which
/// face is visible.
Explanation explained_under(UiState& state, std::unique_ptr<Renderer>& renderer, const MistakeSet& mistakes,
                            glm::ivec2 pixel) {
    if (!renderer) renderer = std::make_unique<Renderer>(state.threads);
    (void)renderer->render(under_mistakes(state.editor.scene(), mistakes), state.rendered->size);
    return renderer->explain(pixel.x, pixel.y);
}

Rgb bytes_of(const Explanation& e) {
    Rgb colour{};
    std::transform(e.byte.begin(), e.byte.end(), colour.begin(),
                   [](int byte) { return static_cast<std::uint8_t>(byte); });
    return colour;
}

struct TermRow {
    Symbol symbol;
    std::string name;
    float right = 0, mistaken = 0;
};

/// The sum of each term, then the individual lights' terms that differ.
std::vector<TermRow> term_rows(const Explanation& right, const Explanation& mistaken, int channel) {
    const TermSums a = term_sums(right), b = term_sums(mistaken);
    std::vector<TermRow> rows{{Symbol::Emission, "e  emission", a.emission[channel], b.emission[channel]},
                              {Symbol::Ambient, "a  ambient", a.ambient[channel], b.ambient[channel]},
                              {Symbol::Diffuse, "d  diffuse", a.diffuse[channel], b.diffuse[channel]},
                              {Symbol::Specular, "s  specular", a.specular[channel], b.specular[channel]}};
    if (right.at.lights.size() != mistaken.at.lights.size() || right.lit_per_corner) return rows;
    for (std::size_t i = 0; i < right.at.lights.size(); ++i) {
        const ExplainedLight &x = right.at.lights[i], &y = mistaken.at.lights[i];
        for (const TermRow& row : {TermRow{Symbol::Ambient, "a", x.ambient[channel], y.ambient[channel]},
                                   TermRow{Symbol::Diffuse, "d", x.diffuse[channel], y.diffuse[channel]},
                                   TermRow{Symbol::Specular, "s", x.specular[channel], y.specular[channel]}})
            if (row.right != row.mistaken)
                rows.push_back({row.symbol, row.name + "  " + x.name, row.right, row.mistaken});
    }
    return rows;
}

void number_cell(float value, const ImVec4& colour) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    mono_text(shown_number(value));
    ImGui::PopStyleColor();
}

/// Highlights differing rows.
void term_table(const UiState& state, const Explanation& right, const Explanation& mistaken) {
    constexpr std::array channels{"red", "green", "blue"};
    const int channel = state.get<InspectorState>().channel;
    const float width = std::min(px(70), (ImGui::GetContentRegionAvail().x - px(100)) / 2);
    if (!ImGui::BeginTable("##mine", 3, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const char* column : {"right", "mistaken"})
        ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthFixed, width);
    ImGui::PushFont(fonts().small);
    ImGui::TableNextRow();
    for (const char* title : {channels[static_cast<std::size_t>(channel)], "right", "mistaken"}) {
        ImGui::TableNextColumn();
        dim_text(title);
    }
    ImGui::PopFont();
    for (const TermRow& row : term_rows(right, mistaken, channel)) {
        const bool same = row.right == row.mistaken;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        coloured(row.symbol, row.name);
        number_cell(row.right, same ? theme().dim_text : theme().text);
        number_cell(row.mistaken, same ? theme().dim_text : theme().warning);
    }
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("sum");
    number_cell(right.sum[channel], theme().text);
    number_cell(mistaken.sum[channel], theme().text);
    ImGui::EndTable();
}

/// The chosen candidate; null if there is none.
const Candidate* chosen_candidate(const MyPictureState& mine) {
    if (!mine.answer || mine.answer->diagnosis.candidates.empty()) return nullptr;
    const auto& all = mine.answer->diagnosis.candidates;
    return &all[std::min(mine.chosen, all.size() - 1)];
}

}  // namespace

std::optional<PixelOfMine> pixel_of_mine(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    const Scene& scene = state.editor.scene();
    if (!mine.shown || !state.on_screen.explanation) return {};
    const glm::ivec2 pixel{state.on_screen.explanation->x, state.on_screen.explanation->y};
    const PictureSize size = state.rendered->size;
    const auto lacks_mesh = [](const Object& object) { return !object.mesh; };
    if (!is_inside(size, pixel) || std::any_of(scene.objects.begin(), scene.objects.end(), lacks_mesh))
        return {};
    const Picture& picture = mine.answer ? *mine.answer->mine : *mine.shown;
    const auto place = pixel_in(pixels_between(scene.camera, size, picture.size), pixel, picture.size);
    if (!place) return {};
    PixelOfMine found{*place,
                      rgb_at(picture, picture.pixel(place->x, place->y)),
                      explained_under(state, mine.right, {}, pixel),
                      {}};
    if (const Candidate* candidate = chosen_candidate(mine))
        found.mistaken = explained_under(state, mine.mistaken, candidate->mistakes, pixel);
    return found;
}

void my_pixel(UiState& state) {
    if (!state.get<MyPictureState>().shown) return;
    section_heading("In my picture");
    const std::optional<PixelOfMine> pixel = pixel_of_mine(state);
    if (!pixel) return wrapped_dim("My picture does not cover this pixel.");
    if (shown_experiment(state) != nullptr)
        small_dim("My picture shows the scene before the experiment.");
    else
        colour_line(fmt::format("mine, pixel {}, {}", pixel->place.x, pixel->place.y).c_str(), pixel->mine);
    colour_line("right", bytes_of(pixel->right));
    if (!pixel->mistaken) return;
    colour_line(title_of(*chosen_candidate(state.get<MyPictureState>())).c_str(), bytes_of(*pixel->mistaken));
    if (pixel->right.hit && pixel->mistaken->hit) term_table(state, pixel->right, *pixel->mistaken);
}

}  // namespace glint
