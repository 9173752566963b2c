// Markdown -> headings, text and blocks, by md4c, which calls back for each element.

#include <fmt/format.h>
#include <md4c.h>

#include <algorithm>
#include <array>
#include <exception>

#include "lessons/lesson_source.h"
#include "models/problem.h"

namespace glint {
namespace {

constexpr int max_nesting = 16;
// Each piece of a link's text stores the address, and one reference can serve any number of links.
constexpr std::size_t max_address = 2048, max_addresses = std::size_t{4} << 20;

/// Decodes the HTML entities that people write in lessons; leaves others unchanged.
std::string entity_text(std::string_view entity) {
    constexpr std::array<std::array<std::string_view, 2>, 5> known{
        {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&nbsp;", "\u00a0"}}};
    for (const auto& [name, text] : known)
        if (name == entity) return std::string(text);
    return std::string(entity);
}

bool same_style(const ProseSpan& a, const ProseSpan& b) {
    return a.strong == b.strong && a.emphasis == b.emphasis && a.code == b.code && a.link == b.link;
}

std::string_view text_of(const MD_ATTRIBUTE& attribute) {
    return attribute.text ? std::string_view(attribute.text, attribute.size) : std::string_view();
}

class Collector {
  public:
    explicit Collector(std::string_view text) : text_(text) {}

    void enter(MD_BLOCKTYPE type, const void* detail) {
        if (++depth_ > max_nesting)
            fail_at(line_, "lists and quotes are nested too deeply", "at most 16 levels");
        switch (type) {
        case MD_BLOCK_UL:
            next_number_.push_back(-1);
            break;
        case MD_BLOCK_OL:
            next_number_.push_back(static_cast<int>(
                std::min(static_cast<const MD_BLOCK_OL_DETAIL*>(detail)->start, 1'000'000U)));
            break;
        case MD_BLOCK_LI: {
            int& number = next_number_.back();
            begin({ProseKind::Item, static_cast<int>(next_number_.size()), number, {}});
            if (number >= 0) ++number;
            break;
        }
        case MD_BLOCK_P:
            if (!(open_ && open_->kind == ProseKind::Item && open_->spans.empty()))
                begin({quotes_ > 0 ? ProseKind::Quote : ProseKind::Paragraph, 0, -1, {}});
            break;
        case MD_BLOCK_QUOTE:
            ++quotes_;
            break;
        case MD_BLOCK_H:
            begin({ProseKind::Heading,
                   static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level),
                   -1,
                   {}});
            break;
        case MD_BLOCK_CODE:
            begin({ProseKind::Code, 0, -1, {}});
            code_info_ = words_of(text_of(static_cast<const MD_BLOCK_CODE_DETAIL*>(detail)->info));
            note(static_cast<const MD_BLOCK_CODE_DETAIL*>(detail)->info.text);
            code_line_ = line_;
            break;
        default:
            break;
        }
    }

    void leave(MD_BLOCKTYPE type) {
        --depth_;
        switch (type) {
        case MD_BLOCK_UL:
        case MD_BLOCK_OL:
            next_number_.pop_back();
            break;
        case MD_BLOCK_QUOTE:
            --quotes_;
            break;
        case MD_BLOCK_CODE:
            if (!code_info_.empty() && code_info_[0] != "text") {
                end_block();
                break;
            }
            [[fallthrough]];
        default:
            end();
        }
    }

    void span(MD_SPANTYPE type, const void* detail, bool begins) {
        switch (type) {
        case MD_SPAN_STRONG:
            style_.strong = begins;
            break;
        case MD_SPAN_EM:
            style_.emphasis = begins;
            break;
        case MD_SPAN_CODE:
            style_.code = begins;
            break;
        case MD_SPAN_A:
            style_.link.clear();
            if (begins)
                style_.link =
                    text_of(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href).substr(0, max_address + 1);
            break;
        default:  // a picture is replaced by its description
            break;
        }
    }

    void text(MD_TEXTTYPE type, std::string_view piece) {
        note(piece.data());
        if (!open_) return;
        if (style_.link.size() > max_address)
            fail_at(line_, "the address of a link is too long", "at most 2048 bytes");
        switch (type) {
        case MD_TEXT_NULLCHAR:
            return add("\ufffd");
        case MD_TEXT_BR:
            return add("\n");
        case MD_TEXT_SOFTBR:
            return add(" ");
        case MD_TEXT_ENTITY:
            return add(entity_text(piece));
        default:
            return add(piece);
        }
    }

    std::vector<SourcePart> take() && { return std::move(parts_); }

  private:
    /// Records the line of a piece of the file; md4c's own strings have no line.
    void note(const char* piece) {
        const char* const begin = text_.data();
        if (piece < begin || piece > begin + text_.size()) return;
        const auto place = static_cast<std::size_t>(piece - begin);
        if (place < counted_) return;
        line_ += static_cast<int>(std::count(begin + counted_, piece, '\n'));
        counted_ = place;
        if (open_ && open_->spans.empty()) open_line_ = line_;
    }
    void begin(ProseBlock block) {
        end();
        if (++blocks_ > 4 * max_lesson_parts) fail_at(line_, "the lesson is too long", "at most 4000 blocks");
        open_ = std::move(block);
        style_ = {};
    }
    void add(std::string_view piece) {
        std::vector<ProseSpan>& spans = open_->spans;
        if (spans.empty() || !same_style(spans.back(), style_)) {
            addresses_ += style_.link.size();
            if (addresses_ > max_addresses)
                fail_at(line_, "the addresses of the links are too long", "at most 4 MiB in all");
            spans.push_back(style_);
        }
        spans.back().text += piece;
    }
    std::string open_text() const {
        std::string whole;
        for (const ProseSpan& s : open_->spans) whole += s.text;
        return whole;
    }
    void end() {
        if (!open_) return;
        if (open_->kind == ProseKind::Heading && open_->level < 3)
            parts_.emplace_back(SourceHeading{open_->level, open_line_, open_text()});
        else if (!open_->spans.empty())
            parts_.emplace_back(std::move(*open_));
        open_.reset();
    }
    void end_block() {
        SourceBlock block{code_info_[0], code_info_.size() > 1 ? code_info_[1] : "", {}, code_line_};
        const std::vector<std::string>& known = lesson_block_words();
        if (std::find(known.begin(), known.end(), block.word) == known.end())
            fail_at(code_line_, "there is no block " + in_quotes(block.word),
                    in_quotes(nearest(block.word, known)) + ", or \"text\" for a block that is only shown");
        if (code_info_.size() > 2)
            fail_at(code_line_, in_quotes(code_info_[2]) + " does not belong there", "at most one word");
        std::vector<std::string> lines(1);
        for (const char c : open_text()) {
            if (c == '\n')
                lines.emplace_back();
            else
                lines.back() += c;
        }
        block.lines = block_lines(lines, code_line_ + 1);
        parts_.emplace_back(std::move(block));
        open_.reset();
    }

    std::string_view text_;
    std::size_t counted_ = 0, blocks_ = 0, addresses_ = 0;
    int line_ = 1, open_line_ = 1, code_line_ = 1, depth_ = 0, quotes_ = 0;
    std::vector<int> next_number_;
    std::vector<std::string> code_info_;
    std::optional<ProseBlock> open_;
    ProseSpan style_;
    std::vector<SourcePart> parts_;
};

/// Callbacks from C: an exception is stored until the parser has finished.
struct Calls {
    Collector collector;
    std::exception_ptr thrown;

    template <class F> static int guarded(void* self, F f) {
        auto& calls = *static_cast<Calls*>(self);
        try {
            f(calls.collector);
            return 0;
        } catch (...) {
            calls.thrown = std::current_exception();
            return -1;  // md4c continues after a positive value
        }
    }
};

}  // namespace

std::vector<SourcePart> lesson_source(std::string_view text) {
    Calls calls{Collector(text), {}};
    MD_PARSER parser{};
    parser.flags = MD_FLAG_NOHTML | MD_FLAG_NOINDENTEDCODEBLOCKS;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) {
        return Calls::guarded(self, [&](Collector& c) { c.enter(type, detail); });
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) {
        return Calls::guarded(self, [&](Collector& c) { c.leave(type); });
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) {
        return Calls::guarded(self, [&](Collector& c) { c.span(type, detail, true); });
    };
    parser.leave_span = [](MD_SPANTYPE type, void* detail, void* self) {
        return Calls::guarded(self, [&](Collector& c) { c.span(type, detail, false); });
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* piece, MD_SIZE size, void* self) {
        return Calls::guarded(self, [&](Collector& c) { c.text(type, {piece, size}); });
    };
    const int ended = md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &parser, &calls);
    if (calls.thrown) std::rethrow_exception(calls.thrown);
    if (ended != 0) throw std::bad_alloc();  // other failures of md4c are thrown above
    return std::move(calls.collector).take();
}

// Parses the runs of a block: commands in command-line syntax.

namespace {

struct RunWord {
    std::string_view word;
    RunKind kind;
    std::vector<std::string> options;  // allowed in addition to --set and --size
};

const std::array<RunWord, 7>& kinds() {
    static const std::array<RunWord, 7> all{
        {{"explain", RunKind::Explain, {"--pixel"}},
         {"render", RunKind::Render, {}},
         {"profile", RunKind::Profile, {"--from", "--to"}},
         {"info", RunKind::Info, {}},
         {"lobe", RunKind::Lobe, {"--object", "--angle"}},
         {"microfacets", RunKind::Microfacets, {"--roughness", "--angle", "--view", "--rays", "--facets"}},
         {"compare", RunKind::Compare, {}}}};
    return all;
}

const RunWord& kind_of(const std::string& word, int line) {
    std::vector<std::string> names;
    for (const RunWord& kind : kinds()) {
        if (kind.word == word) return kind;
        names.emplace_back(kind.word);
    }
    fail_at(line, in_quotes(word) + " is not a run", in_quotes(nearest(word, names)));
}

double within(std::string_view text, int line, double least, double most) {
    const double value = read_decimal(text, line);
    if (value < least || value > most)
        fail_at(line, in_quotes(text) + " is out of range", fmt::format("{} to {}", least, most));
    return value;
}

void read_option(LessonRun& run, const std::string& option, const std::string& value) {
    const int line = run.line;
    if (option == "--set") return run.set.push_back(read_set({"", value, line}));
    if (option == "--size")
        run.size = read_lesson_size(value, line);
    else if (option == "--pixel" || option == "--from")
        run.from = read_place(value, line);
    else if (option == "--to")
        run.to = read_place(value, line);
    else if (option == "--object")
        run.object = read_whole(value, line, 0, 9999);
    else if (option == "--angle")
        run.angle_deg =
            within(value, line, 0, run.kind == RunKind::Lobe ? max_lobe_deg : max_microfacets_deg);
    else if (option == "--view")
        run.view_deg = within(value, line, 0, max_microfacets_deg);
    else if (option == "--roughness")
        run.roughness = within(value, line, 0, 1);
    else if (option == "--facets")
        run.facets = read_whole(value, line, 4, 100000);
    else
        run.rays = read_whole(value, line, 1, 100000);
}

void read_compare(LessonRun& run, const std::vector<std::string>& words,
                  const std::vector<LessonRun>& above) {
    if (words.size() != 3)
        fail_at(run.line, "compare names " + std::to_string(words.size() - 1) + " runs",
                "two earlier render runs");
    run.first = words[1];
    run.second = words[2];
    for (const std::string& name : {run.first, run.second})
        if (std::none_of(above.begin(), above.end(),
                         [&](const LessonRun& r) { return r.name == name && r.kind == RunKind::Render; }))
            fail_at(run.line, in_quotes(name) + " is not a picture", "an earlier render run");
}

LessonRun read_run(const BlockLine& line, const std::vector<LessonRun>& above) {
    const std::vector<std::string> words = words_of(line.value);
    if (words.empty()) fail_at(line.line, "nothing is run", "a command such as explain --pixel 640,360");
    const RunWord& kind = kind_of(words[0], line.line);
    LessonRun run;
    run.name = line.key;
    run.kind = kind.kind;
    run.line = line.line;
    if (kind.kind == RunKind::Compare) {
        read_compare(run, words, above);
        return run;
    }
    std::vector<std::string> known = kind.options;
    if (kind.kind != RunKind::Microfacets) known.insert(known.end(), {"--set", "--size"});
    std::vector<std::string> given;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        if (std::find(known.begin(), known.end(), words[i]) == known.end())
            fail_at(line.line, in_quotes(words[i]) + " is not an option of " + words[0],
                    in_quotes(nearest(words[i], known)));
        if (words[i] != "--set" && std::find(given.begin(), given.end(), words[i]) != given.end())
            fail_at(line.line, words[i] + " is given twice", "it only once");
        if (i + 1 == words.size()) fail_at(line.line, words[i] + " has no value", "one after it");
        read_option(run, words[i], words[i + 1]);
        given.push_back(words[i]);
    }
    for (const char* const needed : {"--pixel", "--from", "--to"})
        if (std::find(kind.options.begin(), kind.options.end(), needed) != kind.options.end() &&
            std::find(given.begin(), given.end(), needed) == given.end())
            fail_at(line.line, words[0] + " has no " + needed, std::string(needed) + " X,Y");
    return run;
}

}  // namespace

std::vector<LessonRun> read_runs(const std::vector<BlockLine>& lines) {
    constexpr std::size_t max_runs = 32;
    std::vector<LessonRun> runs;
    for (const BlockLine& line : lines) {
        if (!line.is_run) continue;
        if (std::any_of(runs.begin(), runs.end(), [&](const LessonRun& r) { return r.name == line.key; }))
            fail_at(line.line, in_quotes(line.key) + " is run twice", "a different name");
        if (runs.size() == max_runs) fail_at(line.line, "a block has too many runs", "at most 32");
        runs.push_back(read_run(line, runs));
    }
    return runs;
}

}  // namespace glint
