// What the commands print of a scene whose light no float holds: numbers, and nothing that JSON has no word
// for.
#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

std::string ball_under(const std::string& light, const std::string& more = "") {
    return R"({"glint": 1, "objects": [{}], "lights": [)" + light + "]" + more + "}";
}

void check_numbers(const Ended& ended) {
    CAPTURE(ended.out, ended.err);
    CHECK(ended.status == 0);
    CHECK_FALSE(ended.out.empty());
    for (const char* const wrong : {"inf", "nan", "null"}) CHECK(ended.out.find(wrong) == std::string::npos);
}

}  // namespace

TEST_CASE("no command prints infinity or null where intensity over falloff is more than a float",
          "[cli][extreme]") {
    const std::string bulb =
        R"({"intensity": 1e10, "ambient": [1, 0, 0], "falloff": {"constant": 1e-30, "linear": 0, "quadratic": 0}})";
    const std::string area =
        R"({"type": "area", "intensity": 1e30, "position": [0, 0.25, 0.9682458], "area": {"samples": 4}})";
    for (const std::string& scene :
         {ball_under(bulb), ball_under(fmt::format("{0},{0},{0}", bulb)), ball_under(area),
          ball_under(bulb, R"(, "display": {"exposure": 1e30, "transfer": "srgb"})"),
          ball_under(bulb, R"(, "shading": {"reflection": "cook-torrance"})"),
          ball_under(bulb, R"(, "shading": {"mode": "gouraud"})")})
        for (const std::string& arguments :
             {std::string("profile --from 2,10 --to 17,10"), std::string("explain --pixel 10,8"),
              std::string("explain --pixel 10,8 --format json --sensitivity"),
              std::string("explain --pixel 10,8 --format latex")}) {
            std::vector<std::string> words{arguments.substr(0, arguments.find(' ')), "-", "--size", "20x20"};
            for (std::size_t at = arguments.find(' '); at != std::string::npos;) {
                const std::size_t end = arguments.find(' ', at + 1);
                words.push_back(arguments.substr(at + 1, end == std::string::npos ? end : end - at - 1));
                at = end;
            }
            const Ended ended = run_glint(words, scene);
            CAPTURE(scene, arguments);
            check_numbers(ended);
            const char* const power_of_ten = arguments.ends_with("latex") ? "10^{" : "e+";
            CHECK(ended.out.find(power_of_ten) != std::string::npos);
        }
}

TEST_CASE("a lobe has a number for its energy where k_s times the highlight is more than a float",
          "[cli][extreme]") {
    check_numbers(
        run_glint({"lobe", "-", "--format", "json", "--set", "/shading/reflection=cook-torrance", "--set",
                   "/objects/0/material/specular=[1e30,1,1]", "--set", "/objects/0/material/f0=[1e30,1,1]"},
                  ball_under("")));
}
