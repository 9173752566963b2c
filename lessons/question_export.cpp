#include "lessons/question_export.h"

#include <fmt/format.h>
#include <zlib.h>

#include <utility>

#include "models/utf8.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

using ZipFiles = std::vector<std::pair<std::string, std::string>>;  // name and bytes

/// Encodes pairs of size in bytes and value as little-endian numbers.
std::string little_endian(std::initializer_list<std::pair<std::size_t, int>> numbers) {
    std::string bytes;
    for (const auto& [number, count] : numbers)
        for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

std::string zip_bytes(const ZipFiles& files) {
    // 1 January 1980 instead of today, so that equal input gives equal bytes.
    constexpr std::size_t version = 20, first_day = (1 << 5) + 1;
    std::string zip, directory;
    for (const auto& [name, bytes] : files) {
        const std::string fields =
            little_endian({{version, 2},
                           {0, 2},
                           {0, 2},
                           {0, 2},
                           {first_day, 2},
                           {crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()), 4},
                           {bytes.size(), 4},
                           {bytes.size(), 4},
                           {name.size(), 2},
                           {0, 2}});
        directory.append("PK\x01\x02").append(little_endian({{version, 2}})).append(fields);
        directory.append(little_endian({{0, 2}, {0, 2}, {0, 2}, {0, 4}, {zip.size(), 4}})).append(name);
        zip.append("PK\x03\x04").append(fields).append(name).append(bytes);
    }
    const std::size_t count = files.size(), start = zip.size();
    return zip + directory + "PK\x05\x06" +
           little_endian({{0, 2}, {0, 2}, {count, 2}, {count, 2}, {directory.size(), 4}, {start, 4}, {0, 2}});
}

constexpr std::string_view xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// {0} name, {1} title, {2} type of the answer, {3} answer, {4} picture and text, {5} interaction, {6}
/// comparison with the answer, {7} feedback declaration, {8} feedback assignment, {9} feedback text.
constexpr const char* item_form = R"(<assessmentItem xmlns="http://www.imsglobal.org/xsd/imsqti_v2p1"
 identifier="{0}" title="{1}" adaptive="false" timeDependent="false">
<responseDeclaration identifier="RESPONSE" cardinality="single" baseType="{2}">
<correctResponse><value>{3}</value></correctResponse></responseDeclaration>
<outcomeDeclaration identifier="SCORE" cardinality="single" baseType="float">
<defaultValue><value>0</value></defaultValue></outcomeDeclaration>
{7}<itemBody>
{4}{5}</itemBody>
<responseProcessing>
<responseCondition><responseIf>{6}
<setOutcomeValue identifier="SCORE"><baseValue baseType="float">1</baseValue></setOutcomeValue>
</responseIf></responseCondition>
{8}</responseProcessing>
{9}</assessmentItem>
)";
constexpr const char* number_form =
    R"(<equal toleranceMode="absolute" tolerance="{0} {0}">)"
    R"(<variable identifier="RESPONSE"/><correct identifier="RESPONSE"/></equal>)";
constexpr const char* test_form = R"(<assessmentTest xmlns="http://www.imsglobal.org/xsd/imsqti_v2p1"
 identifier="test" title="{0}">
<testPart identifier="part" navigationMode="nonlinear" submissionMode="simultaneous">
<assessmentSection identifier="section" title="{0}" visible="true">
{1}</assessmentSection>
</testPart>
</assessmentTest>
)";
constexpr const char* manifest_form =
    R"(<manifest xmlns="http://www.imsglobal.org/xsd/imscp_v1p1" identifier="glint">
<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>
<organizations/>
<resources>
<resource identifier="r-test" type="imsqti_test_xmlv2p1" href="test.xml"><file href="test.xml"/></resource>
{}</resources>
</manifest>
)";

std::string qti_item(const ExportedQuestion& q, const std::string& name) {
    const bool is_choice = !q.options.empty();
    std::string correct = fmt::format("{}", q.answer), feedback, options;
    for (std::size_t i = 0; i < q.options.size(); ++i) {
        const ExportedQuestion::Option& option = q.options[i];
        const char letter = static_cast<char>('A' + i);
        if (option.is_right) correct = letter;
        options += fmt::format("<simpleChoice identifier=\"{}\">{}</simpleChoice>\n", letter,
                               html_escaped(option.text));
        if (option.feedback.empty()) continue;
        feedback +=
            fmt::format(
                R"(<modalFeedback outcomeIdentifier="FEEDBACK" showHide="show" identifier="{}">{}</modalFeedback>)",
                letter, html_escaped(option.feedback)) +
            "\n";
    }
    const std::string interaction =
        is_choice
            ? fmt::format(
                  R"(<choiceInteraction responseIdentifier="RESPONSE" shuffle="false" maxChoices="1">{}</choiceInteraction>)",
                  options)
            : fmt::format(
                  R"(<p><textEntryInteraction responseIdentifier="RESPONSE" expectedLength="12"/> {}</p>)",
                  html_escaped(q.unit));
    const char* const match =
        R"(<match><variable identifier="RESPONSE"/><correct identifier="RESPONSE"/></match>)";
    const char* const declares =
        R"(<outcomeDeclaration identifier="FEEDBACK" cardinality="single" baseType="identifier"/>)";
    const char* const sets =
        R"(<setOutcomeValue identifier="FEEDBACK"><variable identifier="RESPONSE"/></setOutcomeValue>)";
    std::string text;
    if (q.picture) text = fmt::format("<p><img src=\"{}.png\" alt=\"{}\"/></p>\n", name, html_escaped(q.alt));
    text += "<p>" + html_escaped(q.text) + "</p>\n";
    return std::string(xml_head) +
           fmt::format(fmt::runtime(item_form), name, html_escaped(q.title),
                       is_choice ? "identifier" : "float", correct, text, interaction,
                       is_choice ? match : fmt::format(fmt::runtime(number_form), q.tolerance),
                       feedback.empty() ? "" : declares, feedback.empty() ? "" : sets, feedback);
}

}  // namespace

std::string qti_package(const std::string& title, const std::vector<ExportedQuestion>& questions) {
    ZipFiles files;
    std::string references, resources;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const std::string name = fmt::format("q{}", i + 1);
        files.emplace_back(name + ".xml", qti_item(questions[i], name));
        references += fmt::format("<assessmentItemRef identifier=\"{0}\" href=\"{0}.xml\"/>\n", name);
        const bool has_picture = questions[i].picture.has_value();
        if (has_picture) files.emplace_back(name + ".png", png_bytes(*questions[i].picture, {}));
        resources +=
            fmt::format(
                R"(<resource identifier="r-{0}" type="imsqti_item_xmlv2p1" href="{0}.xml"><file href="{0}.xml"/>{1}</resource>)",
                name, has_picture ? "<file href=\"" + name + ".png\"/>" : "") +
            "\n";
    }
    files.emplace_back("test.xml", std::string(xml_head) +
                                       fmt::format(fmt::runtime(test_form), html_escaped(title), references));
    files.emplace_back("imsmanifest.xml",
                       std::string(xml_head) + fmt::format(fmt::runtime(manifest_form), resources));
    return zip_bytes(files);
}

std::string moodle_xml(const std::string& title, const std::vector<ExportedQuestion>& questions) {
    const auto text = [](const char* element, const std::string& html, const std::string& file = {}) {
        return fmt::format("<{0} format=\"html\"><text>{1}</text>{2}</{0}>\n", element, html_escaped(html),
                           file);
    };
    std::string xml = fmt::format(
        "{}<quiz>\n<question "
        "type=\"category\"><category><text>$course$/Glint/{}</text></category></question>\n",
        xml_head, html_escaped(title));
    for (const ExportedQuestion& q : questions) {
        std::string html = "<p>" + html_escaped(q.text) + "</p>", file;
        if (q.picture) {
            html = fmt::format("<p><img src=\"@@PLUGINFILE@@/picture.png\" alt=\"{}\"></p>{}",
                               html_escaped(q.alt), html);
            file = fmt::format("<file name=\"picture.png\" path=\"/\" encoding=\"base64\">{}</file>",
                               base64(png_bytes(*q.picture, {})));
        }
        if (!q.unit.empty()) html += "<p>(" + html_escaped(q.unit) + ")</p>";
        xml += fmt::format(
            "<question "
            "type=\"{}\"><name><text>{}</text></name>\n{}{}<defaultgrade>1</defaultgrade><hidden>0</"
            "hidden>\n",
            q.options.empty() ? "numerical" : "multichoice", html_escaped(q.title),
            text("questiontext", html, file), text("generalfeedback", html_escaped(q.feedback)));
        if (q.options.empty())
            xml += fmt::format(
                "<answer fraction=\"100\" "
                "format=\"moodle_auto_format\"><text>{}</text>{}<tolerance>{}</tolerance></answer>\n",
                q.answer, text("feedback", ""), q.tolerance);
        else
            xml +=
                "<single>true</single><shuffleanswers>false</shuffleanswers><answernumbering>ABCD</"
                "answernumbering>\n";
        for (const ExportedQuestion::Option& option : q.options)
            xml += fmt::format("<answer fraction=\"{}\" format=\"html\"><text>{}</text>{}</answer>\n",
                               option.is_right ? 100 : 0, html_escaped(html_escaped(option.text)),
                               text("feedback", html_escaped(option.feedback)));
        xml += "</question>\n";
    }
    return xml + "</quiz>\n";
}

std::string exported(const std::string& out, const std::string& title,
                     const std::vector<ExportedQuestion>& questions) {
    return out.ends_with(".zip") ? qti_package(title, questions) : moodle_xml(title, questions);
}

}  // namespace glint
