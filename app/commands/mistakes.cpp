// glint mistakes: lists the catalogue of `shading.mistakes`.
#include "models/scene/mistakes.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "models/json/json.h"

namespace glint {
namespace {

std::vector<std::string> parts_of(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + separator.size(), text.size()));
    }
    return parts;
}
std::vector<std::string> look_alikes_of(const MistakeName& m) { return parts_of(m.look_alikes, " "); }
std::vector<std::string> sources_of(const MistakeName& m) { return parts_of(m.sources, "; "); }

std::string catalogue_json() {
    Json all = Json::array();
    for (const MistakeName& m : mistake_names())
        all.push_back({{"name", m.name},
                       {"seen_as", heading_of(m.seen_as)},
                       {"does", m.what},
                       {"looks", m.looks},
                       {"look_alikes", look_alikes_of(m)},
                       {"sources", sources_of(m)}});
    return json_text({{"mistakes", all}});
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string catalogue_text() {
    std::string text;
    for (const SeenAs seen_as : all_seen_as) {
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading_of(seen_as));
        for (const MistakeName& m : mistake_names()) {
            if (m.seen_as != seen_as) continue;
            text += fmt::format("\n  {}\n    {}\n    {}\n", m.name, m.what, m.looks);
            if (!m.look_alikes.empty())
                text += fmt::format("    Looks like: {}\n", joined(look_alikes_of(m)));
            if (!m.sources.empty()) text += fmt::format("    Reported in: {}\n", m.sources);
        }
    }
    return text;
}

Run declare_mistakes(Options& options) {
    auto as_json = std::make_shared<bool>(false);
    add_json_format(options, *as_json);
    return [as_json] {
        return Outcome{*as_json ? catalogue_json() : catalogue_text(), {}, ExitStatus::Done};
    };
}

}  // namespace

Command mistakes_command() {
    return {"mistakes", "", "list common mistakes in lighting code, which a scene can switch on",
            "glint mistakes --format json", declare_mistakes};
}

}  // namespace glint
