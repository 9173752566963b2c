#include "lessons/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "models/io/markup.h"

namespace glint {
namespace {

constexpr std::string_view style =
    "body{font:17px/1.5 system-ui,'DejaVu Sans',sans-serif;max-width:46em;margin:2em auto;padding:0 1em;"
    "color:#1a1a1a;background:#fff}h1{font-size:1.7em;line-height:1.2;margin:.2em 0 .6em}"
    "h2{font-size:1.25em;margin:1.6em 0 .5em}img{display:block;max-width:100%;height:auto;margin:1em 0;"
    "border-radius:4px}code{font-size:.92em;background:#0001;padding:0 .2em;border-radius:3px}"
    "pre{background:#0001;padding:.6em .9em;overflow-x:auto}pre code{background:none}"
    ".topic{color:#595959;margin:0}.box{border:1px solid #bbb;border-left:5px solid "
    "#2a6fb0;border-radius:4px;"
    "padding:.5em 1em;margin:1em 0;break-inside:avoid}.box.try{border-left-color:#2b8a4b}"
    ".box.key{border-left-color:#b4632a}.box h3{margin:.1em 0 .4em;font-size:.85em;letter-spacing:.04em;"
    "text-transform:uppercase;color:#595959}.box ul.options{list-style:none;padding-left:.2em}"
    ".answer{border-bottom:1px solid #888;min-width:12em;width:40%;text-align:right;margin:.8em 0 1.2em;"
    "min-height:1.6em;color:#595959}.lines{height:4em;background:repeating-linear-gradient(#0000 0 "
    "1.9em,#888 1.9em 2em)}blockquote{margin:1em 0;"
    "border-left:5px solid #888;padding:.1em "
    "1em}.slide{font-size:28px;line-height:1.35;min-height:94vh}.slide[hidden]{display:none}"
    ".slide img{max-height:48vh;width:auto}body:has(.slide){max-width:60em;margin:0 "
    "auto}.right{font-weight:600}.room{height:4.5em}.name{border-bottom:1px solid #888;"
    "width:60%}table{border-collapse:collapse}td,th{text-align:left;vertical-align:top;padding:.3em .9em "
    ".3em 0;"
    "border-bottom:1px solid #ddd}td ol{margin:0}svg{display:block;margin:.6em 0;max-width:100%;height:auto}"
    "@media "
    "print{.window,button{display:none}.slide{break-after:page}body{margin:0;max-width:none;font-size:11pt}"
    "h2,h3{break-after:avoid}img{max-height:7.5cm;"
    "width:auto}.paper{break-after:page}}";

std::string span_html(const ProseSpan& span) {
    std::string html;
    std::string_view rest = span.text;
    while (true) {  // an intended line break
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        html += span.code ? html_escaped(rest.substr(0, end)) : lesson_html(rest.substr(0, end));
        if (end == rest.size()) break;
        html += "<br>";
        rest.remove_prefix(end + 1);
    }
    if (span.code) html = "<code>" + html + "</code>";
    if (span.emphasis) html = "<em>" + html + "</em>";
    if (span.strong) html = "<strong>" + html + "</strong>";
    // Other links could execute code, or break when the page is moved.
    if (span.link.starts_with("https://") || span.link.starts_with("http://"))
        html = fmt::format("<a href=\"{}\">{}</a>", html_escaped(span.link), html);
    return html;
}

std::string spans_html(const ProseBlock& block) {
    std::string html;
    for (const ProseSpan& span : block.spans) html += span_html(span);
    return html;
}

/// The lines of a code block, with HTML characters escaped.
std::string code_html(const ProseBlock& block) {
    std::string html;
    const std::string whole = plain_text(block);
    for (std::size_t at = 0; at < whole.size();) {
        const std::size_t end = std::min(whole.find('\n', at), whole.size());
        html += html_escaped(std::string_view(whole).substr(at, end - at)) + "\n";
        at = end + 1;
    }
    return "<pre><code>" + html + "</code></pre>\n";
}

/// Writes the list tags before and after list items.
class Lists {
  public:
    void close_to(std::string& html, std::size_t depth) {
        while (open_.size() > depth) {
            html += open_.back() ? "</ol>\n" : "</ul>\n";
            open_.pop_back();
        }
    }
    void item(std::string& html, const ProseBlock& block) {
        const auto depth = static_cast<std::size_t>(block.level);
        const bool numbered = block.number >= 0;
        close_to(html, open_.size() == depth && open_.back() != numbered ? depth - 1 : depth);
        while (open_.size() < depth) {
            html += numbered ? "<ol>\n" : "<ul>\n";
            open_.push_back(numbered);
        }
        html += numbered ? fmt::format("<li value=\"{}\">", block.number) : "<li>";
        html += spans_html(block) + "</li>\n";
    }

  private:
    std::vector<bool> open_;  // whether each open list is numbered
};

}  // namespace

std::string with_indices(std::string_view text, std::string_view underline, const std::string& form) {
    const auto is_of_name = [&text](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    std::string set;
    std::size_t done = 0;
    for (std::size_t at = text.find(underline); at != text.npos; at = text.find(underline, at + 1)) {
        const std::size_t after = at + underline.size();
        const bool one_before = at > 0 && is_of_name(at - 1) && !(at > 1 && is_of_name(at - 2));
        if (at <= done || !one_before || !is_of_name(after) || is_of_name(after + 1)) continue;
        set += text.substr(done, at - 1 - done);
        set += fmt::format(fmt::runtime(form), text[at - 1], text[after]);
        done = after + 1;
    }
    return set += text.substr(done);
}

std::string lesson_html(std::string_view text) {
    return with_indices(html_escaped(text), "_", "{0}<sub>{1}</sub>");
}

std::string page_html(std::string_view title, std::string_view body) {
    constexpr std::string_view end = "</body></html>\n";
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>{}</title><style>{}</style></head>\n<body>\n",
        html_escaped(title), style);
    page.reserve(page.size() + body.size() + end.size());  // avoids reallocations of a large page
    return page.append(body).append(end);
}

std::string prose_html(const std::vector<ProseBlock>& blocks) {
    std::string html;
    Lists lists;
    for (const ProseBlock& block : blocks) {
        if (block.kind == ProseKind::Item) {
            lists.item(html, block);
            continue;
        }
        lists.close_to(html, 0);
        switch (block.kind) {
        case ProseKind::Paragraph:
        case ProseKind::Item:
            html += "<p>" + spans_html(block) + "</p>\n";
            break;
        case ProseKind::Heading:
            html += fmt::format("<h{0}>{1}</h{0}>\n", block.level, spans_html(block));
            break;
        case ProseKind::Quote:
            html += fmt::format("<blockquote{}><p>{}</p></blockquote>\n",
                                plain_text(block).starts_with("In the window") ? " class=\"window\"" : "",
                                spans_html(block));
            break;
        case ProseKind::Code:
            html += code_html(block);
            break;
        }
    }
    lists.close_to(html, 0);
    return html;
}

}  // namespace glint
