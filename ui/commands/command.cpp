#include "ui/commands/command.h"

#include <stdexcept>

#include "ui/commands/command_rows.h"
#include "ui/ui.h"

namespace glint {
namespace {

std::vector<Command> all_commands() {
    std::vector<Command> all;
    for (const auto rows : {file_commands, edit_commands, view_commands, lecture_commands, shading_commands})
        for (Command& row : rows()) all.push_back(std::move(row));
    return all;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all = all_commands();
    return all;
}

const Command& command(CommandId id) {
    for (const Command& row : commands())
        if (row.id == id) return row;
    throw std::logic_error("a command without a row");  // a test asks for every one
}

std::string keys_of(const Command& command) {
    std::string keys;
    for (const KeyPress& press : command.keys) keys.append(keys.empty() ? "" : " or ").append(text_of(press));
    return keys;
}

std::string keys_of(CommandId id) { return keys_of(command(id)); }

std::string keys_of_value(std::string_view value) {
    if (value.empty()) return {};
    for (const Command& row : commands())
        if (row.sets == value) return keys_of(row);
    return {};
}

std::string why_disabled(const UiState& state, const Command& command) {
    return command.why_disabled == nullptr ? std::string() : command.why_disabled(state);
}

std::optional<bool> is_on(const UiState& state, const Command& command) {
    if (command.is_on == nullptr) return {};
    return command.is_on(state);
}

void run_command(UiState& state, const Command& command) {
    if (!can_run(state, command)) return;
    state.viewport.touched |= command.changes_picture;
    command.run(state);
}

}  // namespace glint
