#include "programs/gl_call_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "models/numbers.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

constexpr std::string_view rgb = "rgb(";

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class CallReader {
  public:
    CallReader(std::span<const Variable> variables, const std::string& below, const NumbersByPointer& numbers)
        : variables_(variables), below_(below), numbers_(numbers) {}

    GlCall read(std::string_view statement) {
        add(statement);
        return std::move(call_);
    }

  private:
    void text(std::string_view text) {
        if (call_.pieces.empty() || !call_.pieces.back().pointer.empty()) call_.pieces.emplace_back();
        call_.pieces.back().text += text;
    }

    void add(std::string_view statement) {
        bool in_name = false;  // the previous character belongs to a name
        while (!statement.empty()) {
            const Variable* variable = in_name ? nullptr : variable_at(statement);
            if (variable != nullptr) {
                value_of(*variable);
                statement.remove_prefix(variable->name.size());
            } else if (!in_name && statement.starts_with(rgb)) {
                const std::size_t comma = statement.find(", ");
                const std::string_view factor = statement.substr(rgb.size(), comma - rgb.size());
                if (factor != "1") {
                    add(factor);
                    text(" * ");
                }
                text(rgb);
                statement.remove_prefix(comma + 2);
            } else {
                in_name = is_of_name(statement.front());
                text(statement.substr(0, 1));
                statement.remove_prefix(1);
            }
        }
    }

    /// The longest variable at the beginning of `statement`.
    [[nodiscard]] const Variable* variable_at(std::string_view statement) const {
        const Variable* longest = nullptr;
        for (const Variable& v : variables_) {
            if (!statement.starts_with(v.name)) continue;
            if (statement.size() > v.name.size() && is_of_name(statement[v.name.size()])) continue;
            if (longest == nullptr || v.name.size() > longest->name.size()) longest = &v;
        }
        return longest;
    }

    void value_of(const Variable& variable) {
        if (variable.count == 0) return text(variable.text);
        if (call_.about.empty()) call_.about = fmt::format("{}{}", below_, variable.key);
        for (int i = 0; i < variable.count; ++i) {
            if (i > 0) text(", ");
            std::string pointer = fmt::format("{}{}", below_, variable.key);
            if (variable.count > 1) pointer += fmt::format("/{}", i);
            call_.pieces.push_back({number_text(numbers_.find(pointer)->second), pointer});
        }
    }

    std::span<const Variable> variables_;
    const std::string& below_;
    const NumbersByPointer& numbers_;
    GlCall call_;
};

}  // namespace

std::string_view statement_of(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const std::size_t name =
        static_cast<std::size_t>(std::find_if_not(line.begin(), line.end(), is_of_name) - line.begin());
    if (name == 0 || line.substr(name, 1) != "(") return {};
    line = line.substr(0, line.find("//"));
    return line.substr(0, line.rfind(';') + 1);
}

GlCall call_of(std::string_view statement, std::span<const Variable> variables, const std::string& below,
               const NumbersByPointer& numbers) {
    return CallReader(variables, below, numbers).read(statement);
}

}  // namespace glint
