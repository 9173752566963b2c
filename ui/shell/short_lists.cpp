#include "ui/shell/short_lists.h"

#include <algorithm>

namespace glint {
namespace {

constexpr unsigned reach = 1u << 16;  // how many vertices a 16-bit index can address

/// Copies the vertices of `list` that a command can reach if its indices count from vertex `first`.
void copy_vertices(const ImDrawList& list, unsigned first, ImDrawList& to) {
    const auto* const from = list.VtxBuffer.begin() + first;
    const auto count = std::min(static_cast<unsigned>(list.VtxBuffer.Size) - first, reach);
    to.VtxBuffer.resize(static_cast<int>(count));
    std::copy_n(from, count, to.VtxBuffer.begin());
}

void append(const ImDrawList& list, ImDrawCmd command, ImDrawList& to) {
    const auto* const from = list.IdxBuffer.begin() + command.IdxOffset;
    const int before = to.IdxBuffer.Size;
    to.IdxBuffer.resize(before + static_cast<int>(command.ElemCount));
    std::copy_n(from, command.ElemCount, to.IdxBuffer.begin() + before);
    command.IdxOffset = static_cast<unsigned>(before);
    command.VtxOffset = 0;
    to.CmdBuffer.push_back(command);
}

}  // namespace

std::vector<std::unique_ptr<ImDrawList>> short_lists(const ImDrawList& list) {
    std::vector<std::unique_ptr<ImDrawList>> lists;
    unsigned first = 0;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (lists.empty() || command.VtxOffset != first) {
            first = command.VtxOffset;
            lists.push_back(std::make_unique<ImDrawList>(nullptr));
            copy_vertices(list, first, *lists.back());
        }
        append(list, command, *lists.back());
    }
    return lists;
}

bool counts_from_further_on(const ImDrawList& list) {
    return std::any_of(list.CmdBuffer.begin(), list.CmdBuffer.end(),
                       [](const ImDrawCmd& command) { return command.VtxOffset > 0; });
}

}  // namespace glint
