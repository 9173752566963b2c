// A window with more corners than 16 bits count, for drivers that count from the first one only.
#include "ui/shell/short_lists.h"

#include <cstring>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Everything that a list draws, in its order.
std::vector<unsigned char> drawn(const ImDrawList& list) {
    std::vector<unsigned char> all;
    const auto append = [&all](const auto& value) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
        all.insert(all.end(), bytes, bytes + sizeof value);
    };
    for (const ImDrawCmd& command : list.CmdBuffer)
        for (unsigned i = 0; i < command.ElemCount; ++i) {
            append(list.VtxBuffer[int(command.VtxOffset + list.IdxBuffer[int(command.IdxOffset + i)])]);
            append(command.ClipRect);
            append(command.TextureId);
        }
    return all;
}

}  // namespace

TEST_CASE("a list of more corners than 16 bits count draws the same in lists of fewer", "[ui][lists]") {
    const HeadlessWindow bench;
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    for (int i = 0; i < 20'000; ++i) {
        const ImVec2 at{float(i % 1000), 0.01f * float(i)};
        if (i % 1000 == 0) list.PushClipRect({0, 0}, {900, at.y + 9});
        list.AddRectFilled(at, at + ImVec2(1, 2), IM_COL32(i % 256, 7, 8, 255));
        if (i % 1000 == 999) list.PopClipRect();
    }
    ImGui::Render();
    CHECK(list.VtxBuffer.Size == 80'000);
    std::vector<unsigned char> together;
    const auto lists = short_lists(list);
    CHECK(lists.size() == 2);
    for (const auto& each : lists) {
        CHECK(each->VtxBuffer.Size <= 1 << 16);
        for (const ImDrawCmd& command : each->CmdBuffer) CHECK(command.VtxOffset == 0);
        const auto part = drawn(*each);
        together.insert(together.end(), part.begin(), part.end());
    }
    const bool same = together == drawn(list);
    CHECK(same);
    CHECK(counts_from_further_on(list));
    CHECK_FALSE(counts_from_further_on(*lists.back()));
}
