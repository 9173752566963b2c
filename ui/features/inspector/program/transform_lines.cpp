#include "ui/features/inspector/program/transform_lines.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "models/numbers.h"
#include "models/scene_file/scene_file.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

ImGuiID key_of(int object, int number) {
    return ImGui::GetID(fmt::format("transform of {}, {}", object, number).c_str());
}

/// The numbers that determine how an object is written, in a fixed order: its translation, and the resulting
/// transform.
std::array<float, 12> numbers_of(const glm::vec3& translate, const Transform& t) {
    return {translate.x,    translate.y,    translate.z,    t.translate.x, t.translate.y, t.translate.z,
            t.rotate_deg.x, t.rotate_deg.y, t.rotate_deg.z, t.scale.x,     t.scale.y,     t.scale.z};
}

int code_of(const TransformOrder& order) {
    return 100 * static_cast<int>(order[0]) + 10 * static_cast<int>(order[1]) + static_cast<int>(order[2]);
}
TransformOrder order_of(int code) {
    const auto step = [](int digit) { return static_cast<TransformStep>(digit % 10); };
    return {step(code / 100), step(code / 10), step(code)};
}

bool is_before(const TransformOrder& order, TransformStep a, TransformStep b) {
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
}

}  // namespace

WrittenTransform written_transform(int object, const Transform& transform) {
    WrittenTransform written{file_order, transform};
    const ImGuiStorage& kept = *ImGui::GetStateStorage();
    std::array<float, 12> numbers{};
    for (int i = 0; i < 12; ++i) numbers[static_cast<std::size_t>(i)] = kept.GetFloat(key_of(object, i));
    const glm::vec3 translate(numbers[0], numbers[1], numbers[2]);
    if (numbers != numbers_of(translate, transform)) return written;  // changed elsewhere in the meantime
    written.order = order_of(kept.GetInt(key_of(object, -1), code_of(file_order)));
    written.numbers.translate = translate;
    return written;
}

void keep_written(int object, const WrittenTransform& written, const Transform& transform) {
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    kept.SetInt(key_of(object, -1), code_of(written.order));
    const std::array<float, 12> numbers = numbers_of(written.numbers.translate, transform);
    for (int i = 0; i < 12; ++i) kept.SetFloat(key_of(object, i), numbers[static_cast<std::size_t>(i)]);
}

std::optional<TransformStep> step_of(const GlCall& call) {
    const std::string_view name = call.pieces.front().text;
    if (name.starts_with("glTranslatef(")) return TransformStep::Translate;
    if (name.starts_with("glRotatef(")) return TransformStep::Rotate;
    if (name.starts_with("glScalef(")) return TransformStep::Scale;
    return std::nullopt;
}

void put_in_order(std::vector<GlCall>& calls, const TransformOrder& order) {
    const auto is_step = [](const GlCall& call) { return step_of(call).has_value(); };
    const auto first = std::find_if(calls.begin(), calls.end(), is_step);
    std::stable_sort(first, std::find_if_not(first, calls.end(), is_step),
                     [&order](const GlCall& a, const GlCall& b) {
                         return *step_of(a) != *step_of(b) && is_before(order, *step_of(a), *step_of(b));
                     });
}

TransformOrder dragged_order(const TransformOrder& order, TransformStep held, float mouse_y,
                             std::span<const Rect, 3> areas) {
    const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), held) - order.begin());
    const float height = areas[at].size().y;
    TransformOrder changed = order;
    if (at > 0 && mouse_y < std::min(areas[at - 1].low.y + height, areas[at - 1].high.y))
        std::swap(changed[at - 1], changed[at]);
    else if (at < 2 && mouse_y > std::max(areas[at + 1].high.y - height, areas[at + 1].low.y))
        std::swap(changed[at + 1], changed[at]);
    return changed;
}

void order_note(const WrittenTransform& written, const Transform& transform) {
    if (written.order == file_order) return;
    std::string note = "The order is swapped.";
    if (is_before(written.order, TransformStep::Rotate, TransformStep::Translate))
        note += " Moved before it is turned, the object turns about the world's origin, not about its own.";
    if (is_before(written.order, TransformStep::Scale, TransformStep::Translate))
        note += " Moved before it is scaled, the object has its translation scaled as well.";
    const glm::vec3& t = transform.translate;
    wrapped_dim(fmt::format("{} In the scene file, where translate comes first: [{}, {}, {}].", note,
                            number_text(t.x), number_text(t.y), number_text(t.z)));
}

}  // namespace glint
