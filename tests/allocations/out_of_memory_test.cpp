// The window goes on when memory runs out anywhere in a frame: allocations fail one by one, and the scene in
// hand stays, or is the new one, whole; and the next picture is right.
#include "tests/allocations/counted_new.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/memory_helpers.h"
#include "ui/picture/draw_picture.h"
#include "ui/views/views.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

const ImVec2 window{640, 400};

SceneDocument other_document() {
    SceneDocument document = first_scene();
    document.path = "other.json";
    document.scene.lights.resize(1);
    Object& object = document.scene.objects.front();
    object.source = PrimitiveMesh{Primitive::Knot, 64};
    object.mesh = nullptr;
    REQUIRE(problem_of(load_meshes(document.scene, "", "")) == nullptr);
    return document;
}

/// Lets the allocation number `which` of a frame fail, and all large ones after it in that frame.
void failing_frame(HeadlessWindow& bench, long which, std::size_t large) {
    large_bytes = large;
    large_ones_fail = false;
    fails_after = which;
    const auto stop = [] { fails_after = -1, large_ones_fail = false; };
    try {
        (void)bench.frame();
    } catch (...) {
        stop();
        throw;
    }
    stop();
}

/// How many allocations a frame makes after `action`.
template <class Do> long allocations_after(const Do& action) {
    HeadlessWindow bench(window);
    bench.frames(2);
    action(bench);
    const long before = allocations;
    (void)bench.frame();
    return allocations - before;
}

PictureSize whole_size(HeadlessWindow& bench) {
    return picture_view(lay_out(ImGui::GetIO().DisplaySize, bench.state.layout, 1).centre, bench.state)
        .map.size;
}

void check_next_picture(HeadlessWindow& bench) {
    for (int i = 0; i < 10; ++i) {  // a larger picture is tried again, and there is memory now
        bench.state.pace.memory_rests_until = 0;
        (void)bench.frame();
    }
    REQUIRE(bench.state.rendered != nullptr);
    REQUIRE(bench.state.displayed != nullptr);
    Renderer fresh(1);
    const Picture& right = fresh.render(bench.scene(), bench.state.rendered->size);
    CHECK(bench.state.rendered->rgba == right.rgba);
    CHECK(bench.state.rendered->size == whole_size(bench));
}

/// `action` before a frame in which the allocations fail from some number on: about `tries` numbers.
template <class Do, class Check> void fail_one_by_one(const Do& action, int tries, const Check& check) {
    const long count = allocations_after(action);
    REQUIRE(count > 0);
    for (const std::size_t large : {SIZE_MAX, std::size_t{1} << 14})
        for (long which = 0; which < count; which += std::max(count / tries, 1L)) {
            CAPTURE(which, count, large);
            HeadlessWindow bench(window);
            bench.frames(2);
            action(bench);
            REQUIRE_NOTHROW(failing_frame(bench, which, large));
            check_next_picture(bench);
            check(bench);
        }
}

}  // namespace

TEST_CASE("when memory runs out as another document is drawn, it is there whole, or the one before",
          "[ui][memory]") {
    const SceneDocument other = other_document();
    const Scene first = first_scene().scene;
    fail_one_by_one([&](HeadlessWindow& bench) { take_document(bench.state.editor, other); }, 60,
                    [&](HeadlessWindow& bench) {
                        const bool is_new = bench.state.editor.document.path == "other.json";
                        CHECK(same_description(bench.scene(), is_new ? other.scene : first));
                        CHECK(bench.state.editor.history.present() == bench.scene());
                        if (!is_new) CHECK_FALSE(bench.state.notifications.list.empty());
                    });
}

TEST_CASE("when memory runs out as an edit is drawn, it is taken back or there", "[ui][memory]") {
    const Scene first = first_scene().scene;
    fail_one_by_one(
        [](HeadlessWindow& bench) { bench.scene().shading.mode = ShadingMode::Gouraud; }, 40,
        [&](HeadlessWindow& bench) {
            Scene edited = first;
            edited.shading.mode = ShadingMode::Gouraud;
            CHECK((same_description(bench.scene(), first) || same_description(bench.scene(), edited)));
        });
}

TEST_CASE("when memory runs out as pictures are compared or looked at, the picture stays", "[ui][memory]") {
    const auto nothing_more = [](HeadlessWindow&) {};
    fail_one_by_one(
        [](HeadlessWindow& bench) {
            CompareChoice& choice = bench.state.views.compare.choice;
            set_parts(choice, {{Variant::Kind::Mode, 0}, {Variant::Kind::Mode, 2}});
            choice.on = true;
        },
        30, nothing_more);
    fail_one_by_one([](HeadlessWindow& bench) { show_quantity(bench.state.views, DebugView::Normal); }, 30,
                    nothing_more);
    fail_one_by_one([](HeadlessWindow& bench) { bench.state.views.scope.open = true; }, 30, nothing_more);
}

TEST_CASE("when memory runs out as a pixel is explained, the window goes on", "[ui][memory]") {
    fail_one_by_one([](HeadlessWindow& bench) { bench.state.viewport.probe = glm::dvec2(0.5); }, 30,
                    [](HeadlessWindow&) {});
}

TEST_CASE("a document that needs more memory than there is leaves the open one as it is", "[ui][memory]") {
    HeadlessWindow bench(window);
    bench.frames(2);
    const Scene before = bench.scene();
    SceneDocument large = other_document();
    for (int i = 0; i < 5000; ++i) large.scene.objects.push_back(large.scene.objects.front());
    const test::MemoryLimit limit(50 << 20);
    take_document(bench.state.editor, large);
    bench.frames(3);
    CHECK(bench.scene() == before);
    CHECK(bench.state.editor.document.path.empty());
    CHECK_FALSE(bench.state.editor.unsaved());
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list.front().text.find("of memory, ") != std::string::npos);
    check_next_picture(bench);
}

TEST_CASE("where the system itself has no more memory, the open document stays", "[ui][memory]") {
    CHECK(test::in_process_with_room(std::uint64_t{300} << 20, [] {
        set_memory_limit(std::uint64_t{1} << 50);  // nothing is refused by us
        HeadlessWindow bench(window);
        bench.frames(2);
        const Scene before = bench.scene();
        SceneDocument large = other_document();
        large.scene.objects.front().source = PrimitiveMesh{Primitive::Teapot, 60};
        large.scene.objects.front().mesh = nullptr;
        if (problem_of(load_meshes(large.scene, "", "")) != nullptr) return false;
        for (int i = 0; i < 100; ++i) large.scene.objects.push_back(large.scene.objects.front());
        take_document(bench.state.editor, large);
        bench.frames(3);
        Renderer fresh(1);
        return bench.scene() == before && bench.state.notifications.list.size() == 1 &&
               bench.state.rendered->rgba == fresh.render(before, whole_size(bench)).rgba;
    }));
}

TEST_CASE("a window too large for its picture shows a coarser one, and says so once", "[ui][memory]") {
    HeadlessWindow bench({400, 300});
    bench.frames(2);
    const test::MemoryLimit limit(3 << 20);
    ImGui::GetIO().DisplaySize = {2560, 1600};
    bench.frames(5);
    CHECK(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.pace.memory_divisor > 1);
    bench.state.notifications.list.clear();
    bench.frames(200);  // tried again, which is not said again
    CHECK(bench.state.notifications.list.empty());
    CHECK(bench.state.rendered->size.width >= 100);
    ImGui::GetIO().DisplaySize = {500, 350};
    bench.frames(3);
    CHECK(bench.state.rendered->size == whole_size(bench));
}
