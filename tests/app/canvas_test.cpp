// Tests which parts of a frame are reported as changed, by comparing everything drawn at random points.
#include "app/window/canvas.h"

#include <cstring>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// The data of every triangle drawn over a point, from back to front.
using Cover = std::vector<unsigned char>;

float side(ImVec2 a, ImVec2 b, ImVec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

bool covers(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 p) {
    const float u = side(a, b, p), v = side(b, c, p), w = side(c, a, p);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

template <class T> void append(Cover& cover, const T& value) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    cover.insert(cover.end(), bytes, bytes + sizeof value);
}

Cover cover_of(const ImDrawData& data, ImVec2 p) {
    Cover cover;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4 clip = command.ClipRect;
            if (p.x < clip.x || p.x >= clip.z || p.y < clip.y || p.y >= clip.w) continue;
            for (unsigned e = 0; e < command.ElemCount; e += 3) {
                const auto corner = [&](unsigned k) {
                    return list
                        .VtxBuffer[int(command.VtxOffset + list.IdxBuffer[int(command.IdxOffset + e + k)])];
                };
                const ImDrawVert a = corner(0), b = corner(1), c = corner(2);
                if (!covers(a.pos, b.pos, c.pos, p)) continue;
                append(cover, a);
                append(cover, b);
                append(cover, c);
                append(cover, command.TextureId);
            }
        }
    }
    return cover;
}

/// Random points, and everything that was drawn over each one in the last frame.
class Watched {
  public:
    explicit Watched(ImVec2 size) {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> x(0, size.x), y(0, size.y);
        for (int i = 0; i < 400; ++i) points_.push_back({x(random), y(random)});
        covers_.resize(points_.size());
    }
    /// Returns the number of changed points. Asserts that each one is in a changed rectangle.
    int follow(const std::vector<Rect>& changed) {
        int count = 0;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            Cover now = cover_of(*ImGui::GetDrawData(), points_[i]);
            if (now == covers_[i]) continue;
            ++count;
            bool held = false;
            for (const Rect& rect : changed) held = held || rect.holds(points_[i]);
            CAPTURE(points_[i].x, points_[i].y, changed.size());
            CHECK(held);
            covers_[i] = std::move(now);
        }
        return count;
    }

  private:
    std::vector<ImVec2> points_;
    std::vector<Cover> covers_;
};

float area_of(const std::vector<Rect>& rects) {
    float area = 0;
    for (const Rect& rect : rects) area += rect.size().x * rect.size().y;
    return area;
}

}  // namespace

TEST_CASE("changed rectangles contain every point that differs from the last frame",
          "[app][canvas][release]") {
    HeadlessWindow bench;
    FrameChanges changes;
    Watched watched({1280, 800});
    int changed_points = 0;
    const auto look = [&] {
        const std::vector<Rect> rects = changes.update(*ImGui::GetDrawData());
        CHECK(rects.size() <= max_changed_rects);
        changed_points += watched.follow(rects);
    };
    bench.frames(3);
    look();
    std::mt19937 random(3);
    ImGuiIO& io = ImGui::GetIO();
    for (int i = 0; i < 200; ++i) {
        io.MousePos = {float(random() % 1280), float(random() % 800)};
        if (random() % 3 == 0) io.MouseDown[0] = !io.MouseDown[0];
        UiInput input;
        if (random() % 8 == 0) input.presses.push_back({random() % 2 == 0 ? Key::C : Key::H});
        (void)bench.frame(input);
        look();
    }
    CHECK(changed_points > 300);  // menus, panels, handles and the picture's lines appeared and disappeared
}

TEST_CASE("an identical frame has no changed rectangles", "[app][canvas]") {
    HeadlessWindow bench;
    FrameChanges changes;
    bench.frames(5);
    const std::vector<Rect> first = changes.update(*ImGui::GetDrawData());
    REQUIRE(first.size() == 1);
    CHECK(area_of(first) == 1280 * 800);
    (void)bench.frame();
    CHECK(changes.update(*ImGui::GetDrawData()).empty());
}

TEST_CASE("editing a light's number changes only a small part of the window", "[app][canvas]") {
    HeadlessWindow bench;
    FrameChanges changes;
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    bench.frames(5);
    (void)changes.update(*ImGui::GetDrawData());
    bench.state.editor.document.scene.lights[0].intensity += 0.125F;
    (void)bench.frame();
    const std::vector<Rect> changed = changes.update(*ImGui::GetDrawData());
    CHECK_FALSE(changed.empty());
    CHECK(area_of(changed) < 0.05F * 1280 * 800);
}

TEST_CASE("overlapping rectangles are merged, so only a few remain", "[app][canvas]") {
    std::vector<Rect> rects;
    add_rect(rects, {{0, 0}, {10, 10}});
    add_rect(rects, {{20, 0}, {30, 10}});
    add_rect(rects, {{5, 5}, {5, 9}});  // empty
    CHECK(rects.size() == 2);
    add_rect(rects, {{8, 2}, {22, 4}});
    REQUIRE(rects.size() == 1);
    CHECK(rects[0] == Rect{{0, 0}, {30, 10}});
    for (int i = 0; i < 10; ++i) add_rect(rects, {{0, 100 + 20 * float(i)}, {10, 110 + 20 * float(i)}});
    CHECK(rects.size() <= max_changed_rects);
    for (int i = 0; i < 10; ++i) {
        bool held = false;
        for (const Rect& rect : rects) held = held || rect.holds({5, 105 + 20 * float(i)});
        CHECK(held);
    }
}
