// A frame that fails, usually because of a limit: the last drawn scene is restored, with one message.
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

SceneDocument large_document() {
    SceneDocument document = first_scene();
    document.path = "large.json";
    document.scene.objects = {test::object_of(test::primitive(Primitive::Sphere, 400))};
    return document;
}

}  // namespace

TEST_CASE("a document that exceeds the memory limit is replaced by the previous one", "[ui][memory]") {
    DrawnWindow bench({640, 400});
    const Scene before = bench.scene();
    const PictureSize size = bench.state.rendered->size;
    const test::MemoryLimit limit(test::cost_of(before, size));
    take_document(bench.state.editor, large_document());
    (void)bench.frame();
    CHECK(bench.state.editor.document.path.empty());
    CHECK(bench.scene() == before);
    bench.frames(3);
    CHECK(bench.state.notifications.list.size() == 1);
    CHECK(bench.notes_with("(change it with --memory or GLINT_MEMORY)") == 1);
    CHECK(bench.state.rendered->rgba == Renderer(1).render(before, size).rgba);
}

TEST_CASE("an edit that exceeds the memory limit is reverted", "[ui][memory]") {
    DrawnWindow bench({640, 400});
    const Scene before = bench.scene();
    const test::MemoryLimit limit(test::cost_of(before, bench.state.rendered->size));
    bench.scene().objects[0].mesh = test::primitive(Primitive::Sphere, 400);
    bench.frames(3);
    CHECK(bench.scene() == before);
    CHECK(bench.notes_with("of memory") == 1);
}

TEST_CASE("the picture keeps its size if a larger one would exceed the memory limit", "[ui][memory]") {
    DrawnWindow bench({640, 400});
    const Scene before = bench.scene();
    const PictureSize size = bench.state.rendered->size;
    {
        const test::MemoryLimit limit(test::cost_of(before, size));
        ImGui::GetIO().DisplaySize = {1280, 800};
        bench.frames(5);
        CHECK(bench.state.rendered->size == size);
        CHECK(bench.state.notifications.list.size() == 1);
    }
    take_document(bench.state.editor, first_scene());  // the first scene may be smaller
    bench.frames(2);
    CHECK(bench.state.rendered->size.width > size.width);
}

TEST_CASE("a first scene that exceeds the memory limit closes the window", "[ui][memory]") {
    HeadlessWindow bench;
    const test::MemoryLimit limit(1 << 20);
    CHECK_THROWS_AS(bench.frame(), LimitExceeded);
}

TEST_CASE("running out of memory in a frame shows one message", "[ui][memory]") {
    DrawnWindow bench;
    const Scene before = bench.scene();
    for (int i = 0; i < 2; ++i) {
        ImGui::NewFrame();
        give_up_frame(bench.state, std::bad_alloc());
        ImGui::Render();
        bench.frames(1);
    }
    CHECK(bench.scene() == before);
    CHECK(bench.state.notifications.list.size() == 1);
    CHECK(bench.notes_with("there is not enough memory") == 1);
}
