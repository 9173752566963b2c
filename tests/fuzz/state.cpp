// The files of the window's folder: its settings, and the copy of unsaved work. The first byte selects one.

#include <variant>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/json_mutator.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using fuzz::require;

namespace {

void read_copy(std::string_view text) {
    const Result<SceneDocument> opened = open_autosave(fuzz::path_of_bytes(text));
    if (const Problem* problem = problem_of(opened)) {
        require(problem->text().find('\n') == std::string::npos, "a problem is reported on one line");
        return;
    }
    const auto& document = std::get<SceneDocument>(opened);
    const Result<SceneDocument> again =
        open_autosave(fuzz::path_of_bytes(autosave_text(document, "/proc/self/fd")));
    require(!problem_of(again), "a copy that was opened and copied again can be opened");
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed) {
    if (size < 2 || seed % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
    return 1 + fuzz::mutate_json(data + 1, size - 1, max_size - 1, seed);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text = fuzz::text_of(data + 1, size - 1);
    if (data[0] == 'c') {
        read_copy(text);
    } else {
        const Preferences preferences = read_preferences(std::string(text));
        require(preferences.recent.size() <= max_recent_files, "no more recent files than the limit");
        require(read_preferences(preferences_text(preferences)) == preferences,
                "reading written preferences gives the same preferences");
    }
    return 0;
}
