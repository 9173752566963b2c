// The sensitivity tab: background jobs that measure, and the rows of their results.
#include "ui/features/inspector/sensitivity.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>

#include "ui/document/loading.h"
#include "ui/feature.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/views/compare_view.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

namespace {

double largest(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

std::vector<Sensitivity> ranked(const Sensitivities& sensitivities) {
    std::vector<Sensitivity> rank;
    std::copy_if(sensitivities.numbers.begin(), sensitivities.numbers.end(), std::back_inserter(rank),
                 [](const Sensitivity& number) { return !number.is_w; });
    std::stable_sort(rank.begin(), rank.end(), [](const Sensitivity& a, const Sensitivity& b) {
        return largest(a.effect) > largest(b.effect);
    });
    return rank;
}

namespace {

constexpr double look_again = 0.05;  // seconds between checks of the job's progress

/// Measures one pixel of one scene. Shares only the document's meshes.
JobPtr<Sensitivities> measure(Jobs& jobs, const SceneDocument& document, PictureSize size, glm::ivec2 pixel) {
    const auto work = [document, size, pixel](LoadProgress& progress) -> Result<Sensitivities> {
        if (document.scene.lights.size() > max_sensitivity_lights)
            return Problem{"", "", fmt::format("More than {} lights take too long.", max_sensitivity_lights),
                           ""};
        const PartOfProgress meshes;
        SensitivityRun run(document, size, pixel.x, pixel.y, 1);  // one thread: the window needs the others
        progress.total = run.count();
        while (!progress.cancelled && run.step()) progress.done = run.measured();
        if (progress.cancelled) throw LoadCancelled();
        return run.result();
    };
    return jobs.start<Sensitivities>("Sensitivity", work);
}

/// Starts, drops and collects jobs; called once a frame while the results are needed. A job starts once the
/// scene and the pixel have not changed for a moment.
void poll_sensitivity(Jobs& jobs, SensitivityState& state, const SceneDocument& document, PictureSize size,
                      glm::ivec2 pixel) {
    const double now = ImGui::GetTime();
    const bool same =
        state.asked_pixel == pixel && state.asked_size == size && state.asked_scene == document.scene;
    if (!same) {
        state.asked_scene = document.scene, state.asked_pixel = pixel, state.asked_size = size;
        state.asked_since = now;
        state.current = false;
        leave(state.job, state.ending);
    }
    if (state.current) return;
    if (!state.job && has_ended(state.ending) && now - state.asked_since >= stillness &&
        !ImGui::IsAnyMouseDown())
        state.job = measure(jobs, document, size, pixel);
    if (state.job && state.job->done()) {
        const Result<Sensitivities> result = state.job->take();
        const auto* found = std::get_if<Sensitivities>(&result);
        const Problem* problem = problem_of(result);
        state.why_none = problem != nullptr ? problem->text() : "";
        state.shown = found != nullptr ? std::optional(*found) : std::nullopt;
        state.rank = found != nullptr ? ranked(*found) : std::vector<Sensitivity>();
        state.shown_scene = state.asked_scene;
        state.current = true;
        state.job.reset();
        return;
    }
    redraw_within(look_again);
}

/// The channel that changes most: 0 red, 1 green, 2 blue.
int strongest(glm::dvec3 v) {
    const glm::dvec3 size = glm::abs(v);
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

void number_tooltip(const NamedNumber& named, const Sensitivity& number) {
    const auto parts = [](glm::dvec3 v) {
        const auto part = [](double x) { return shown_number(static_cast<float>(x)); };
        return fmt::format("red {}, green {}, blue {}", part(v.x), part(v.y), part(v.z));
    };
    tooltip(fmt::format("{}: {}", named.owner, named.what).c_str(),
            "How much the pixel's colour changes with this number. Click to show its panel",
            fmt::format("now {:.4g}{}\nmoved by {:+.3g}: {}\nper unit: {}", number.value,
                        number.one_sided ? ", can move in one direction only" : "", number.move,
                        parts(number.effect), parts(number.change)),
            number.pointer);
}

/// Selects the owner of the number in the measured scene. Its index may belong to another item until the next
/// measurement; in that case nothing is selected.
void select_owner(UiState& state, const std::string& pointer, const NamedNumber& named) {
    if (named_number(pointer, state.editor.scene()).owner == named.owner)
        state.editor.selection = named.selection;
}

/// Draws a row: the effect, as a bar and as a number, and the number's name. A click selects the number's
/// owner.
void number_row(UiState& state, const Sensitivity& number, double most) {
    const NamedNumber named = named_number(number.pointer, state.get<SensitivityState>().shown_scene);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushID(number.pointer.c_str());
    const bool clicked =
        ImGui::Selectable("##row", false, 0, {ImGui::GetContentRegionAvail().x, line + px(5)});
    if (clicked) select_owner(state, number.pointer, named);
    const auto [low, high] = last_item();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto share = static_cast<float>(largest(number.effect) / std::max(most, 1e-30));
    const ImVec2 text = low + px(1) * ImVec2(4, 1);
    list.AddRectFilled({text.x, high.y - px(3)}, {text.x + share * (high.x - low.x - px(8)), high.y - px(1)},
                       to_u32(theme().accent));
    list.AddText(text, to_u32(theme().text), fmt::format("{}  {}", named.owner, named.what).c_str());
    const int channel = strongest(number.effect);
    const std::string figure =
        fmt::format("{} {}", shown_number(static_cast<float>(number.effect[channel])), "RGB"[channel]);
    ImGui::PushFont(fonts().figures);
    const float width = ImGui::CalcTextSize(figure.c_str()).x + px(6);
    list.AddRectFilled({high.x - width, low.y}, {high.x, high.y - px(4)}, to_u32(theme().panel));
    list.AddText({high.x - width + px(2), text.y}, to_u32(theme().text), figure.c_str());
    ImGui::PopFont();
    number_tooltip(named, number);
    ImGui::PopID();
}

/// Lists the numbers with no effect, one owner per line.
void owners(UiState& state, const char* title, const std::vector<std::string>& pointers) {
    if (pointers.empty() || !fold(title, false)) return;
    struct Line {
        NamedNumber named;
        std::string pointer, words;  // the first number's pointer; the text of all
    };
    std::vector<Line> lines;
    for (const std::string& pointer : pointers) {
        const NamedNumber named = named_number(pointer, state.get<SensitivityState>().shown_scene);
        const auto same = std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
            return line.named.owner == named.owner && line.named.selection == named.selection;
        });
        const auto line = same != lines.end() ? same : lines.insert(lines.end(), {named, pointer, ""});
        if (!named.what.empty()) line->words.append(line->words.empty() ? "" : ", ").append(named.what);
    }
    for (const auto& [named, pointer, words] : lines) {
        ImGui::PushID(named.owner.c_str());
        if (ImGui::Selectable(whole_label(named.owner).c_str())) select_owner(state, pointer, named);
        ImGui::PopID();
        ImGui::Indent(px(12));
        small_dim(words.empty() ? "is not visible at this pixel" : words);
        ImGui::Unindent(px(12));
    }
}

void progress(const SensitivityState& job) {
    const float share = job.job ? std::max(progress_share(job.job->progress()), 0.0f) : 0;
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, theme().accent);
    ImGui::ProgressBar(share, {ImGui::GetContentRegionAvail().x, px(4)}, "");
    ImGui::PopStyleColor();
    small_dim(job.shown ? "Measuring again; the previous numbers are shown below."
                        : "Changing every number in the scene slightly and measuring the pixel.");
}

/// The edited scene with the settings of the picked part of a comparison; a stored B is not the edited scene.
SceneDocument asked_document(const UiState& state) {
    SceneDocument document = state.editor.document;
    if (state.get<CompareState>().asked_part.kind != Variant::Kind::Stored)
        document.scene = scene_under(state.get<CompareState>().asked_part, document.scene, nullptr);
    return document;
}

}  // namespace

void sensitivity_tab(UiState& state, const PictureView& view) {
    if (!state.on_screen.explanation)
        return inspector_empty_state("Click a pixel to sort every number in the scene by its effect there.");
    SensitivityState& job = state.get<SensitivityState>();
    if (state.get<CompareState>().asked_part == Variant{})
        poll_sensitivity(state.jobs, job, state.editor.document, view.map.size, state.on_screen.pixel);
    else
        poll_sensitivity(state.jobs, job, asked_document(state), view.map.size, state.on_screen.pixel);
    if (!job.current) progress(job);
    if (!job.shown) {
        if (job.current) warning_text(job.why_none);
        return;
    }
    small_dim(
        "The change in colour, in the channel that changes most, when a number moves by a tenth of its "
        "usual range, or, if it has none, by as much as a drag of 100 pixels changes it.");
    constexpr std::size_t first_few = 12;
    const double most = job.rank.empty() ? 1 : largest(job.rank.front().effect);
    if (job.rank.empty()) wrapped_dim("No number in the scene affects this pixel.");
    for (std::size_t i = 0; i < job.rank.size(); ++i) {
        if (i == first_few &&
            !fold(fmt::format("{} more with less effect", job.rank.size() - i).c_str(), false))
            break;
        number_row(state, job.rank[i], most);
    }
    owners(state, "No effect here", job.shown->no_effect);
}

extern const Feature sensitivity_feature;
const Feature sensitivity_feature{
    .leave_document = [](UiState& s, const SceneDocument&) { s.get<SensitivityState>().forget(); }};

}  // namespace glint
