
#include "models/fields/scene_fields.h"
#include "models/json/json.h"
#include "models/scene_file/read_scene.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

Json range_json(const Range& range) {
    Json within{{"type", "number"},
                {range.low_open ? "exclusiveMinimum" : "minimum", range.low},
                {range.high_open ? "exclusiveMaximum" : "maximum", range.high}};
    if (!range.also) return within;
    return {{"anyOf", {within, {{"const", *range.also}}}}};
}

Json array_of(const Json& each, std::size_t least, std::size_t most) {
    return {{"type", "array"}, {"items", each}, {"minItems", least}, {"maxItems", most}};
}

template <class T> Json schema_of(const T& value);

// A member's schema without its texts, and its default. Groups and lists have no default of their own.
struct Described {
    Json schema, initial = nullptr;
};

template <class V> Json numbers_json(const V& v, int size) {
    Json list = Json::array();
    for (int i = 0; i < size; ++i) list.push_back(number_json(v[i]));
    return list;
}

Described described(const Text& kind, const std::string& s) {
    Json schema{{"type", "string"}};
    if (kind.max_characters > 0) schema["maxLength"] = kind.max_characters;
    return {std::move(schema), s};
}
Described described(const Path&, const std::string&) {
    return {{{"type", "string"}, {"minLength", 1}, {"not", {{"pattern", "\\u0000"}}}}};
}
Described described(const Switch&, bool b) { return {{{"type", "boolean"}}, b}; }
Described described(const Real& kind, float x) { return {range_json(kind.range), number_json(x)}; }
Described described(const Colour&, const glm::vec3& v) {
    return {array_of(range_json(at_least_zero), 3, 3), numbers_json(v, 3)};
}
Described described(const Vector&, const glm::vec3& v) {
    return {array_of(range_json(any_number), 3, 3), numbers_json(v, 3)};
}
Described described(const Homogeneous&, const glm::vec4& v) {
    return {array_of(range_json(any_number), 3, 4), numbers_json(v, 3)};
}
Described described(const Count& kind, int n) {
    if (kind.is_allowed == nullptr)
        return {{{"type", "number"}, {"multipleOf", 1}, {"minimum", kind.low}, {"maximum", kind.high}}, n};
    if (kind.high > 64) {  // too many to list: the range, and the forbidden values
        Json refused = Json::array();
        for (int i = kind.low; i <= kind.high; ++i)
            if (!kind.contains(i)) refused.push_back(i);
        return {{{"type", "number"},
                 {"multipleOf", 1},
                 {"minimum", kind.low},
                 {"maximum", kind.high},
                 {"not", {{"enum", refused}}}},
                n};
    }
    Json allowed = Json::array();
    for (int i = kind.low; i <= kind.high; ++i)
        if (kind.contains(i)) allowed.push_back(i);
    return {{{"enum", allowed}}, n};
}
template <class E> Described described(const OneOf&, E value) {
    Json words = Json::array();
    for (const Choice& row : choices<E>)
        words.push_back(
            {{"const", std::string(row.word)}, {"title", row.label}, {"description", row.meaning}});
    return {{{"oneOf", words}}, std::string(name_of(value))};
}
template <class T> Described described(const Group&, const T& value) { return {schema_of(value)}; }
template <class T> Described described(const List& kind, const std::vector<T>&) {
    return {{{"type", "array"}, {"items", schema_of(T{})}, {"maxItems", kind.max}}, Json::array()};
}
Described described(const OneProjection&, const Projection&) {
    Json any = Json::array();
    for (const ProjectionKind kind : enumerators<ProjectionKind>) {
        const Choice row = choice_of(kind);
        Json schema = schema_of(default_projection(kind));
        schema["description"] = row.meaning;
        schema["properties"]["type"] = {{"const", std::string(row.word)}};
        // Without a type the first one applies; a frustum needs all of its numbers.
        if (kind != ProjectionKind::Perspective) schema["required"] = {"type"};
        if (kind == ProjectionKind::Frustum) schema["required"] = projection_keys(kind);
        any.push_back(schema);
    }
    return {{{"oneOf", any}}};
}
/// One schema per primitive, because its maximum detail differs; and one for a file.
Described described(const OneMesh&, const MeshSource&) {
    Json any = Json::array();
    for (const Primitive primitive : enumerators<Primitive>) {
        const PrimitiveInfo info = info_of(primitive);
        Json schema = schema_of(PrimitiveMesh{primitive, info.default_detail});
        schema["description"] = info.choice.meaning;
        schema["properties"]["primitive"] = {{"const", std::string(info.choice.word)}};
        if (primitive != PrimitiveMesh{}.primitive) schema["required"] = {"primitive"};
        any.push_back(schema);
    }
    Json file = schema_of(MeshFile{});
    file["required"] = {"file"};
    any.push_back(file);
    return {{{"oneOf", any}}};
}

template <class T> Json schema_of(const T& value) {
    Json properties = Json::object();
    fields(value, [&](const Row& row, const auto& kind, const auto& member) {
        Described made = described(kind, member);
        made.schema["title"] = row.label;
        if (!made.schema.contains("description")) made.schema["description"] = row.help;
        if (!made.initial.is_null()) made.schema["default"] = made.initial;
        properties[std::string(row.key)] = made.schema;
    });
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

/// position with four numbers: w = 0 for a directional light, above 0 for the others.
Json w_follows_type() {
    const auto fourth = [](const Json& w) {
        return Json{{"properties", {{"position", {{"prefixItems", {true, true, true, w}}}}}}};
    };
    return {{"if",
             {{"properties", {{"type", {{"const", std::string(name_of(LightKind::Directional))}}}}},
              {"required", {"type"}}}},
            {"then", fourth({{"const", 0}})},
            {"else", fourth({{"exclusiveMinimum", 0}})}};
}

}  // namespace

std::string scene_schema() {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "Scene of Glint, version 1"},
                {"description", "See docs/scene_file.md."}};
    schema.update(schema_of(Scene{}));
    schema["properties"]["glint"] = {{"const", 1}, {"description", "The version of the format"}};
    schema["required"] = {"glint"};
    schema["properties"]["lights"]["items"].update(w_follows_type());
    return schema.dump(2) + "\n";
}

}  // namespace glint
