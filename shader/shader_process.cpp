#include "shader/shader_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "models/io/file.h"

namespace glint {
namespace {

// Both processes are the same program, so values are sent as raw bytes.

class Packer {
  public:
    template <class T> void operator()(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void operator()(const std::string& text) { list(text); }
    template <class T> void operator()(const std::vector<T>& values) {
        if constexpr (std::is_trivially_copyable_v<T>) {
            list(values);
        } else {
            (*this)(values.size());
            for (const T& value : values) fields(*this, value);
        }
    }

    std::string bytes;

  private:
    template <class List> void list(const List& values) {
        (*this)(values.size());
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    }
};

/// Throws std::runtime_error if the bytes end too early.
class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : rest_(bytes) {}
    template <class T> void operator()(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        std::memcpy(&value, take(1, sizeof value), sizeof value);
    }
    void operator()(std::string& text) { list(text); }
    template <class T> void operator()(std::vector<T>& values) {
        if constexpr (std::is_trivially_copyable_v<T>) {
            list(values);
        } else {
            std::size_t count = 0;
            (*this)(count);
            for (; count > 0; --count) fields(*this, values.emplace_back());
        }
    }

  private:
    const char* take(std::size_t count, std::size_t size) {
        if (count > rest_.size() / size) throw std::runtime_error("the data ends too early");
        const char* const begin = rest_.data();
        rest_.remove_prefix(count * size);
        return begin;
    }
    template <class List> void list(List& values) {
        std::size_t count = 0;
        (*this)(count);
        const char* const begin = take(count, sizeof(values[0]));
        values.resize(count);
        if (count > 0) std::memcpy(values.data(), begin, count * sizeof(values[0]));
    }
    std::string_view rest_;
};

// The fields of each type, in both directions. T is const while packing.

template <class A, class T>
requires std::is_same_v<std::remove_const_t<T>, Uniform>
void fields(A& a, T& u) {
    a(u.name);
    a(u.value);
}
template <class A, class T>
requires std::is_same_v<std::remove_const_t<T>, ShaderMessage>
void fields(A& a, T& m) {
    a(m.is_error);
    a(m.line);
    a(m.text);
}
template <class A, class T> void scene_fields(A& a, T& s) {
    a(s.size);
    a(s.stages.before);
    a(s.stages.vertex);
    a(s.stages.fragment);
    a(s.stages.lights_pixels);
    a(s.cull);
    a(s.background);
    a(s.shown_background);
    a(s.uniforms);
}
template <class A, class T> void answer_fields(A& a, T& s) {
    a(s.end);
    a(s.messages);
    a(s.why);
    a(s.picture.picture.size);
    a(s.picture.picture.rgba);
    a(s.picture.picture.linear);
    a(s.picture.positions);
    a(s.picture.normals);
    a(s.picture.is_black);
    a(s.picture.not_finite);
    a(s.picture.discarded);
    a(s.picture.stopped);
}

std::string packed(const ShaderScene& scene, const std::string& text, ShaderOutput output) {
    Packer pack;
    pack(text);
    pack(output);
    scene_fields(pack, scene);
    pack(scene.objects.size());
    std::vector<const std::vector<float>*> sent;
    for (const ShaderObject& object : scene.objects) {
        pack(object.is_mirrored);
        pack(object.uniforms);
        // Objects may share a mesh: it is sent once.
        const auto found = std::find(sent.begin(), sent.end(), object.corners.get());
        pack(static_cast<std::size_t>(found - sent.begin()));
        if (found != sent.end()) continue;
        sent.push_back(object.corners.get());
        pack(*object.corners);
    }
    return std::move(pack.bytes);
}

ShaderScene unpacked(std::string_view bytes, std::string& text, ShaderOutput& output) {
    Unpacker unpack(bytes);
    ShaderScene scene;
    unpack(text);
    unpack(output);
    scene_fields(unpack, scene);
    std::size_t objects = 0;
    unpack(objects);
    std::vector<CornerNumbers> received;
    for (; objects > 0; --objects) {
        ShaderObject& object = scene.objects.emplace_back();
        unpack(object.is_mirrored);
        unpack(object.uniforms);
        std::size_t mesh = 0;
        unpack(mesh);
        if (mesh >= received.size()) {
            auto numbers = std::make_shared<std::vector<float>>();
            unpack(*numbers);
            received.push_back(std::move(numbers));
        }
        object.corners = received.at(mesh);
    }
    return scene;
}

std::string pixel_text(const PixelFinding& found) {
    return fmt::format("{} pixel{}, the first at {},{}", found.count, found.count == 1 ? "" : "s",
                       found.first.x, found.first.y);
}

ShaderAnswer shaded(const ShaderScene& scene, const std::string& text, ShaderOutput output) {
    ShaderAnswer answer;
    const OffscreenContext context;
    ShaderCanvas canvas;
    ShaderLog log = canvas.compile(scene, text);
    answer.messages = std::move(log.messages);
    answer.end = ShaderAnswer::End::NotCompiled;
    if (!log.is_compiled) return answer;
    answer.picture = canvas.draw(scene, output);
    answer.end = ShaderAnswer::End::Drawn;
    if (answer.picture.stopped.count == 0) return answer;
    answer.end = ShaderAnswer::End::NeverEnds;
    answer.why = fmt::format("its loops run more than {} times in a pixel, such as {},{}", max_loop_runs,
                             answer.picture.stopped.first.x, answer.picture.stopped.first.y);
    return answer;
}

std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);  // npos + 1 is 0
}

/// The result for a process that ended without an answer.
ShaderAnswer without_answer(const ChildEnd& end, const ChildLimits& limits) {
    ShaderAnswer answer;
    switch (end.how) {
    case ChildEnd::How::TimedOut:
        answer.end = ShaderAnswer::End::TimedOut;
        answer.why = fmt::format("it did not end within {:g} s", limits.seconds);
        break;
    case ChildEnd::How::Cancelled:
        answer.end = ShaderAnswer::End::Cancelled;
        answer.why = "it was cancelled";
        break;
    case ChildEnd::How::Killed:
        answer.why = fmt::format("OpenGL crashed (signal {})", end.status);
        break;
    case ChildEnd::How::NotStarted:
        answer.why = "the drawing process did not start: " + reason(end.status);
        break;
    case ChildEnd::How::Exited:
        answer.why = "OpenGL cannot draw: " + last_line(end.errors);
        break;
    }
    return answer;
}

}  // namespace

ShaderAnswer shade_in_process(const ShaderScene& scene, const std::string& text, ShaderOutput output,
                              ChildLimits limits) {
    const std::string input = packed(scene, text, output);
    // For the scene, OpenGL's copies of it, and the picture's four buffers, in OpenGL and in this process.
    constexpr std::uint64_t bytes_per_pixel = 200;
    if (limits.bytes == 0)
        limits.bytes = shader_memory + 4 * input.size() + bytes_per_pixel * scene.size.pixels();
    const ChildEnd end = run_child(shader_worker_name, {}, input, limits);
    if (!end.succeeded()) return without_answer(end, limits);
    ShaderAnswer answer;
    try {
        Unpacker unpack(end.output);
        answer_fields(unpack, answer);
    } catch (const std::runtime_error& error) {
        answer = {};
        answer.why = error.what();
    }
    return answer;
}

std::vector<Problem> problems_of(const ShaderAnswer& answer, const std::string& file) {
    std::vector<Problem> problems;
    if (answer.end == ShaderAnswer::End::Drawn) return problems;
    for (const ShaderMessage& message : answer.messages)
        if (message.is_error) problems.push_back(problem_from(message, file));
    if (answer.end != ShaderAnswer::End::NotCompiled) problems.push_back({file, "", answer.why, ""});
    return problems;
}

Warnings warnings_of(const ShaderAnswer& answer, const std::string& file) {
    Warnings warnings;
    for (const ShaderMessage& message : answer.messages)
        if (!message.is_error) warnings.push_back(problem_from(message, file).text());
    const auto add = [&](const PixelFinding& found, const char* what) {
        if (found.count > 0) warnings.push_back(fmt::format("{}: {} in {}", file, what, pixel_text(found)));
    };
    add(answer.picture.not_finite, "lit() returns NaN or an infinity");
    add(answer.picture.discarded, "nothing is drawn (discard)");
    if (answer.picture.is_black)
        warnings.push_back(file +
                           ": lit() returns black in all pixels, so nothing is lit yet. Begin with "
                           "material.ambient * global_ambient, then add one light");
    return warnings;
}

int run_shader_worker() {
    try {
        const auto input = value_or_throw(read_file("-", std::size_t{1} << 40));
        std::string text;
        ShaderOutput output{};
        const ShaderScene scene = unpacked(input, text, output);
        const ShaderAnswer answer = shaded(scene, text, output);
        Packer pack;
        answer_fields(pack, answer);
        return problem_of(write_file("-", pack.bytes)) == nullptr ? 0 : 1;
    } catch (const ProblemFound& found) {
        fmt::print(stderr, "{}\n", found.problem.text());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "not enough memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 1;
}

}  // namespace glint
