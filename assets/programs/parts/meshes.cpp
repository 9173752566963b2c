// ---- Meshes and their transforms ----
struct Corner { int position, normal; };
struct Triangle { int face, corner[3]; };  // three of that polygon's corners
struct Mesh {
    std::vector<vec3> positions, normals, colors;
    std::vector<std::vector<Corner>> faces;  // polygons
    std::vector<Triangle> triangles;
};
double number(FILE* file) {
    double x = 0;
    if (std::fscanf(file, "%lf", &x) != 1) std::exit(1);
    return x;
}
int index(FILE* file) { return int(number(file)); }
int count(FILE* file) { return std::fscanf(file, "%*s") == 0 ? index(file) : 0; }  // the number after a word
std::vector<vec3> vectors(FILE* file) {
    std::vector<vec3> all(count(file));
    for (vec3& v : all) v = {number(file), number(file), number(file)};
    return all;
}
/// The mesh of a file, in object coordinates.
Mesh read_mesh(const char* name) {
    FILE* file = std::fopen(name, "r");
    if (!file) std::exit(std::fprintf(stderr, "%s cannot be read: run the program in its folder\n", name));
    Mesh mesh;
    mesh.positions = vectors(file);
    mesh.normals = vectors(file);
    mesh.colors = vectors(file);
    mesh.faces.resize(count(file));
    for (std::vector<Corner>& face : mesh.faces) {
        face.resize(index(file));
        for (Corner& c : face) c = {index(file), index(file)};
    }
    mesh.triangles.resize(count(file));
    for (Triangle& t : mesh.triangles) t = {index(file), {index(file), index(file), index(file)}};
    std::fclose(file);
    return mesh;
}
mat4 rotation(int a, int b, double degrees) {  // from axis a towards axis b
    mat4 m = identity;
    m.m[a][a] = m.m[b][b] = std::cos(radians(degrees));
    m.m[b][a] = std::sin(radians(degrees));
    m.m[a][b] = -m.m[b][a];
    return m;
}
/// M = T Rz Ry Rx S.
mat4 transform(vec3 t, vec3 rotate, vec3 s) {
    const mat4 move = {{{1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1}}};
    const mat4 scale = {{{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}}};
    return move * rotation(0, 1, rotate.z) * rotation(2, 0, rotate.y) * rotation(1, 2, rotate.x) * scale;
}
//@if facet_normals
/// Topic: facet normals. Newell's sum of cross products around the polygon, outward if counter-clockwise.
vec3 facet_normal(const Mesh& mesh, const std::vector<Corner>& face) {
    const auto edge = [&](std::size_t i) {
        return mesh.positions[face[i].position] - mesh.positions[face[0].position];
    };
    vec3 sum;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) sum = sum + cross(edge(i), edge(i + 1));
    //@if wrong.cross_reversed
    sum = -1 * sum;  // (the mesh file's averaged normals are reversed, too)
    //@end
    return unit(sum);
}
//@end

