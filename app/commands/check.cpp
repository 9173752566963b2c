// glint check: finds the first step in which another renderer's buffers differ from ours.
#include "diagnose/check/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/scene/scene.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

struct CheckArguments {
    SceneArguments scene;
    std::string directory;
    bool as_json = false;
    bool in_world = false;
};

/// Whether the path exists. A dangling symbolic link counts: reading it reports the problem. Throws Failure
/// if the system denies access.
bool is_there(const std::string& path) {
    std::error_code failed;
    const std::filesystem::file_type type = std::filesystem::symlink_status(path, failed).type();
    if (type == std::filesystem::file_type::none)
        throw Failure{
            ExitStatus::Impossible,
            {path, "", "cannot be accessed: " + reason(failed.value()), "a directory that can be read"}};
    return type != std::filesystem::file_type::not_found;
}

/// Returns the file of the named buffer, .pfm or .exr; empty if there is none.
std::string buffer_file(const std::string& directory, const std::string& name) {
    const std::string path = (std::filesystem::path(directory) / name).string();
    const std::string pfm = path + ".pfm";
    std::string exr = path + ".exr";
    if (!is_there(exr)) return is_there(pfm) ? pfm : "";
    if (is_there(pfm))
        throw Failure{ExitStatus::Impossible,
                      {exr, "", "exists in addition to " + name + ".pfm", "only one of the two"}};
    return exr;
}

/// Returns one warning that lists the pictures in the directory that are not buffers of the scene.
Warnings unknown_pictures(const std::string& directory, std::vector<std::string> known) {
    constexpr std::size_t most = 5;
    known.emplace_back("face");  // render writes it, but check does not compare it
    std::vector<std::string> unknown;
    std::error_code ignored;
    for (std::filesystem::directory_iterator at(directory, ignored), end; !ignored && at != end;
         at.increment(ignored)) {
        const std::filesystem::path file = at->path().filename();
        const bool is_picture = file.extension() == ".pfm" || file.extension() == ".exr";
        if (is_picture && std::find(known.begin(), known.end(), file.stem().string()) == known.end())
            unknown.push_back(on_one_line(file.string()));
    }
    if (unknown.empty()) return {};
    std::sort(unknown.begin(), unknown.end());
    const std::size_t more = unknown.size() - std::min(unknown.size(), most);
    unknown.resize(unknown.size() - more);
    return {fmt::format("{}: not compared, because the scene has no such buffers: {}{}",
                        on_one_line(directory), fmt::join(unknown, ", "),
                        more > 0 ? fmt::format(" and {} more", more) : "")};
}

/// Reads the scene's buffers that exist in the directory.
std::vector<PixelBuffer> read_buffers(const std::string& directory, const Scene& scene) {
    std::vector<PixelBuffer> buffers;
    const std::vector<std::string> names = checked_buffers(scene);
    for (const std::string& name : names) {
        const std::string file = buffer_file(directory, name);
        if (file.empty()) continue;
        buffers.push_back({name, take(read_picture(file))});
        const PictureSize size = buffers.front().picture.size;
        if (auto problem = too_much_memory({.picture = buffers_memory(size, buffers.size())})) {
            problem->file = file;
            throw Failure{ExitStatus::Impossible, *problem};
        }
        if (buffers.back().picture.size != size)
            throw Failure{ExitStatus::Impossible,
                          {file, "", "differs in size from " + buffers.front().name,
                           fmt::format("{}x{}", size.width, size.height)}};
    }
    if (buffers.empty())
        throw Failure{ExitStatus::Impossible,
                      {directory, "", "contains none of the buffers",
                       fmt::format("one of {}, .pfm or .exr", fmt::join(names, ", "))}};
    return buffers;
}

Outcome check(const CheckArguments& arguments) {
    require_file(arguments.scene);
    const std::string expected = "a directory with buffers like those that render --buffers writes";
    require_given(arguments.directory, "DIR", expected);
    std::error_code ignored;
    if (!std::filesystem::is_directory(arguments.directory, ignored))
        throw wrong_usage("DIR", arguments.directory + " is not a directory", expected);
    const SceneDocument document = open_scene(arguments.scene);
    const std::vector<PixelBuffer> buffers = read_buffers(arguments.directory, document.scene);
    const BufferCheck found = check_buffers(document, buffers, arguments.scene.threads, arguments.in_world);
    if (found.compared == 0)
        throw Failure{
            ExitStatus::Impossible,
            {arguments.directory, "", "no pixel to compare", "a size at which a surface covers more pixels"}};
    Warnings warnings = document.warnings;
    for (std::string& unknown : unknown_pictures(arguments.directory, checked_buffers(document.scene)))
        warnings.push_back(std::move(unknown));
    return {arguments.as_json ? check_json(found) : check_text(found), warnings, ExitStatus::Done};
}

Run declare_check(Options& options) {
    auto arguments = std::make_shared<CheckArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "DIR", "",
             "a directory with another program's buffers, named like those of render --buffers",
             arguments->directory);
    add_json_format(options, arguments->as_json);
    options.add_value("--frame", "FRAME", "coordinates of the program's vectors: camera (default) or world",
                      [&in_world = arguments->in_world](const std::string& text) {
                          in_world = read_word("--frame", text, {"camera", "world"}) == 1;
                      });
    return [arguments] { return check(*arguments); };
}

}  // namespace

Command check_command() {
    return {"check", "FILE DIR", "find the first wrong step in the buffers of another program",
            "glint check teapot.json my-buffers", declare_check};
}

}  // namespace glint
