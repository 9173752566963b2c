#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnose/diagnosis_format.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

std::string text_of(Rgb c) { return fmt::format("({}, {}, {})", c[0], c[1], c[2]); }

std::string names_of(const std::vector<MistakeSet>& sets) {
    std::vector<std::string> names;
    names.reserve(sets.size());
    for (const MistakeSet& set : sets) names.push_back(name_of(set));
    return fmt::format("{}", fmt::join(names, ", "));
}

/// What the program that drew the picture does.
std::string what_is_done(const MistakeSet& set) {
    std::vector<std::string_view> words;
    for (const std::size_t i : set) words.push_back(mistake_names()[i].what);
    return fmt::format("{}", fmt::join(words, " And: "));
}

std::string verdict_line(const Diagnosis& d) {
    switch (d.verdict) {
    case Verdict::NoMistake:
        return "No mistake: the picture shows the scene as Glint does.";
    case Verdict::NotComparable:
        return "Not comparable: " + d.why + ".";
    case Verdict::NotReadable:
        return "Not readable: " + d.why + ".";
    case Verdict::NotInCatalogue:
        return fmt::format(
            "Not in the catalogue: {} of the pixels are wrong, and no {}.",
            percent_text(count_of(d.pixels, PixelKind::Surface).share()),
            d.of_pairs ? "mistake explains them, nor do any two at once as far as a small picture tells"
                       : "single mistake explains them");
    case Verdict::Mistake:
        break;
    }
    const Candidate& best = d.candidates.front();
    return fmt::format("Mistake: {}. {}", name_of(best.mistakes), what_is_done(best.mistakes));
}

/// The colour of a pixel, as the wrong picture stores its channels.
std::string stored_text(const DisplayChange& change, Rgb c) { return text_of(exchanged(change, c)); }

std::string candidate_lines(const Candidate& c, PictureSize size) {
    const glm::ivec2 place = changed_place(c.change, size, c.pixel);
    std::string text = fmt::format(
        "It explains {} % of the wrong pixels and leaves {:.2f} levels. At {},{} your picture has {}; right "
        "is {}, with the mistake {}",
        explained_percent(c), c.residual, place.x, place.y, stored_text(c.change, c.mine),
        stored_text(c.change, c.reference), stored_text(c.change, c.as_mistaken));
    text += place == c.pixel ? ".\n" : fmt::format("; the scene has that at {},{}.\n", c.pixel.x, c.pixel.y);
    if (!c.also.empty()) text += "In this scene surfaces look the same under " + names_of(c.also) + ".\n";
    return text;
}

/// "draw it with --set ...: pixel 4,2 is then a (1, 2, 3), with b (4, 5, 6).\n"
std::string experiment_line(const Experiment& e) {
    std::vector<std::string> options, shows;
    for (const Assignment& a : e.set) options.push_back(fmt::format("--set {}={}", a.pointer, a.json));
    for (std::size_t i = 0; i < e.shows.size(); ++i)
        shows.push_back(fmt::format("{} {}", name_of(e.mistakes[i]), text_of(e.shows[i])));
    return fmt::format("draw it with {}: pixel {},{} is then {}.\n", fmt::join(options, " "), e.pixel.x,
                       e.pixel.y, fmt::join(shows, ", with "));
}

/// "the specular term of Sun", "all light of Sun", "the specular term of all lights".
std::string term_words(const DifferenceTerm& t, const Scene& scene) {
    std::string words = t.term == "all" ? "all light" : "the " + t.term + " term";
    if (t.light == all_lights) words += " of all lights";
    if (t.light >= 0) words += " of " + on_one_line(scene.lights[static_cast<std::size_t>(t.light)].name);
    return words;
}

std::string difference_lines(const Diagnosis& d, const Scene& scene) {
    std::string text;
    if (!d.regions.empty()) {
        const DifferenceRegion& r = d.regions.front();
        text += fmt::format(
            "Most of it is on {}, wrong in {} of its pixels, from {},{} to {},{}, on average {} "
            "levels.\n",
            on_one_line(scene.objects[static_cast<std::size_t>(r.object)].name), percent_text(r.share),
            r.low.x, r.low.y, r.high.x, r.high.y,
            fmt::format("({:+.0f}, {:+.0f}, {:+.0f})", r.mean[0], r.mean[1], r.mean[2]));
    }
    if (!d.terms.empty()) {
        const DifferenceTerm& t = d.terms.front();
        const double factor = std::round(100 * t.factor) / 100 + 0.0;  // never "-0.00"
        text += fmt::format(
            "The difference is as if {} were multiplied by {:.2f}, which explains {:.0f} % of it.\n",
            term_words(t, scene), factor, 100 * t.explained);
    }
    if (!d.candidates.empty()) {
        const Candidate& nearest = d.candidates.front();
        const std::string brightness = own_brightness(d, nearest);
        constexpr double enough = 0.95;  // it is another reason that speaks against it
        text += fmt::format("Nearest is {}{}, which explains {} % of the wrong pixels{}.\n",
                            name_of(nearest.mistakes), brightness.empty() ? "" : " " + brightness,
                            explained_percent(nearest), nearest.explained < enough ? ": too few" : "");
    }
    return text;
}

/// What differs although nothing is wrong: at edges, or in too few pixels. Empty where nothing does.
std::string still_unlike_line(const PixelCounts& counts, float noise) {
    std::vector<std::string> kinds;
    const auto add = [&](PixelKind kind, std::string_view where) {
        const PixelCount& count = count_of(counts, kind);
        if (count.unlike > 0) kinds.push_back(fmt::format("{} of {} {}", count.unlike, count.pixels, where));
    };
    add(PixelKind::Surface, "on surfaces, too few for a mistake");
    add(PixelKind::Edge, "at edges, which are not compared");
    add(PixelKind::Background, "in the background, which is not compared");
    if (kinds.empty()) return "";
    return fmt::format("Pixels that differ by more than {} levels{}: {}.\n", visible_levels,
                       noise > 0 ? " beyond what noise explains" : "", fmt::join(kinds, "; "));
}

}  // namespace

std::string_view verdict_text(Verdict verdict) {
    switch (verdict) {
    case Verdict::NoMistake:
        return "no mistake";
    case Verdict::Mistake:
        return "mistake";
    case Verdict::NotInCatalogue:
        return "not in the catalogue";
    case Verdict::NotComparable:
        return "not comparable";
    case Verdict::NotReadable:
        return "not readable";
    }
    return "";  // not reached
}

std::string display_text(const DisplayFinding& display) {
    const DisplayChange& c = display.change;
    std::vector<std::string> words;
    if (c.upside_down && c.mirrored) {
        words.emplace_back("turned by 180 degrees");
    } else if (c.upside_down || c.mirrored) {
        words.emplace_back(c.upside_down ? "upside down" : "mirrored");
    }
    if (c.red_blue) words.emplace_back("red and blue exchanged");
    if (c.is_by_power())
        words.push_back(
            c.encodings() > 0
                ? fmt::format("encoded once too often, by a power of {}", encoding_power)
                : fmt::format("encoded by a power of {} in place of sRGB's curve", encoding_power));
    else if (c.encodings() != 0)
        words.emplace_back(c.encodings() > 0 ? "sRGB-encoded once too often"
                                             : "sRGB-encoded one time too few");
    if (c.gain != 1) words.push_back(fmt::format("all brightness times {:.3g}", c.gain));
    if (c.noise > 0) words.push_back(fmt::format("noise of about {:.1f} levels", c.noise));
    if (display.background) words.push_back("another background, " + text_of(*display.background));
    if (display.shift != glm::vec2(0))
        words.push_back(fmt::format("shifted by {:.2f} pixels to the right and {:.2f} down", display.shift.x,
                                    display.shift.y));
    if (display.smooth_edges)
        words.emplace_back("smooth edges");
    else if (display.smoothed)
        words.emplace_back("smoothed");
    if (display.softened > 0)
        words.push_back(fmt::format("within surfaces by up to {} levels in {} pixels", display.softened_most,
                                    display.softened));
    return fmt::format("{}", fmt::join(words, "; "));
}

std::string experiment_text(const std::optional<Experiment>& experiment) {
    return experiment ? "To tell them apart, " + experiment_line(*experiment)
                      : "No change that is tried tells them apart by more than a level.\n";
}

std::string percent_text(double share) {
    return share > 0 && share < 0.005 ? "less than 1 %" : fmt::format("{:.0f} %", 100 * share);
}

int explained_percent(const Candidate& candidate) {
    return static_cast<int>(std::floor(100 * candidate.explained));
}

std::string diagnosis_text(const Diagnosis& d, const Scene& scene) {
    std::string text = verdict_line(d) + "\n";
    if (d.verdict == Verdict::NotComparable || d.verdict == Verdict::NotReadable) return text;
    if (const std::string display = display_text(d.display); !display.empty())
        text += "Set aside first, because it is not a lighting mistake: " + display + ".\n";
    if (d.verdict == Verdict::NoMistake) text += still_unlike_line(d.pixels, d.display.change.noise);
    if (d.verdict == Verdict::NoMistake && d.display.softened > 0)
        text +=
            "A small highlight that is lit differently can look like a softened one: a larger "
            "picture "
            "would tell it from a soft one.\n";
    if (d.verdict == Verdict::Mistake) text += candidate_lines(d.candidates.front(), d.size);
    if (d.left_out) text += left_out_text(*d.left_out, scene) + "\n";
    if (d.experiment) text += "To be sure, " + experiment_line(*d.experiment);
    if (d.verdict == Verdict::NotInCatalogue) text += difference_lines(d, scene);
    return text;
}

std::string left_out_text(const DifferenceTerm& term, const Scene& scene) {
    return fmt::format("Or {} is left out: that shows the same.", term_words(term, scene));
}

std::string own_brightness(const Diagnosis& diagnosis, const Candidate& candidate) {
    constexpr float hardly = 0.005f;
    const float gain = candidate.change.gain, told = diagnosis.display.change.gain;
    if (std::abs(gain - told) <= hardly * std::max(gain, told)) return {};
    return fmt::format("with all brightness times {:.3g}", gain);
}

}  // namespace glint
