#include "app/lesson_arguments.h"

#include <filesystem>

#include "app/assets.h"
#include "app/failure.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// "05-lambert" is named by itself, by "lambert", "05" and "5".
bool is_named(const std::string& file, const std::string& word) {
    const std::string name = fs::path(file).stem().string();
    const std::size_t dash = std::min(name.find('-'), name.size());
    const std::string number = name.substr(0, dash);
    const std::size_t first = std::min(number.find_first_not_of('0'), number.size());
    return word == name || word == number || word == number.substr(first) ||
           (dash < name.size() && word == name.substr(dash + 1));
}

std::vector<std::string> own_lessons() {
    const std::string folder = asset_path("lessons");
    std::vector<std::string> files;
    if (!folder.empty()) files = take(lesson_files({folder}));
    if (files.empty())
        throw Failure{ExitStatus::Impossible, {"", "", "no lessons are installed", asset_places("lessons")}};
    return files;
}

}  // namespace

std::vector<std::string> named_lessons(const std::vector<std::string>& words) {
    if (words.empty()) return own_lessons();
    std::vector<std::string> files;
    for (const std::string& word : words) {
        std::error_code ignored;
        if (fs::exists(word, ignored)) {
            const std::vector<std::string> found = take(lesson_files({word}));
            if (found.empty()) throw wrong_usage(word, "holds no lesson", "a folder with one");
            files.insert(files.end(), found.begin(), found.end());
            continue;
        }
        const std::size_t before = files.size();
        std::vector<std::string> names;
        for (const std::string& file : own_lessons()) {
            names.push_back(fs::path(file).stem().string());
            if (is_named(file, word)) files.push_back(file);
        }
        if (files.size() == before)
            throw wrong_usage(word, "neither a file nor a lesson",
                              "a lesson, such as " + nearest(word, names) + ", or a file");
    }
    return files;
}

std::string lesson_file(const std::string& word) {
    const std::vector<std::string> files = named_lessons({word});
    if (files.size() != 1)
        throw wrong_usage(word, std::to_string(files.size()) + " lessons are named", "one of them");
    return files[0];
}

Lesson open_lesson(const std::string& word) { return take(read_lesson(lesson_file(word))); }

}  // namespace glint
