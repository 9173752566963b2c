#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnose/check/check.h"
#include "models/json/json.h"

namespace glint {
namespace {

std::string text_of(glm::vec3 v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

}  // namespace

std::string check_text(const BufferCheck& check) {
    std::string text;
    if (!check.agree.empty()) text += fmt::format("These agree: {}.\n", fmt::join(check.agree, ", "));
    if (!check.differs) return text + "Nothing differs.\n";
    const BufferDifference& d = *check.differs;
    text += fmt::format(
        "{} is the first that differs, in {:.0f} % of the pixels: at {},{} yours is {}, ours {}.\n", d.name,
        100 * d.share, d.pixel.x, d.pixel.y, text_of(d.mine), text_of(d.ours));
    text += d.found.empty() ? "No transform that is tried makes the one of the other.\n"
                            : fmt::format("Yours are {}.\n", d.found);
    return text;
}

std::string check_json(const BufferCheck& check) {
    Json json;
    json["width"] = check.size.width;
    json["height"] = check.size.height;
    json["agree"] = check.agree;
    Json& differs = json["differs"];
    if (check.differs) {
        const BufferDifference& d = *check.differs;
        differs["buffer"] = d.name;
        differs["share"] = d.share;
        differs["pixel"] = Json{d.pixel.x, d.pixel.y};
        differs["mine"] = json_of(d.mine);
        differs["ours"] = json_of(d.ours);
        differs["found"] = d.found;
    }
    return json_text(json);
}

}  // namespace glint
