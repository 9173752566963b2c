#include "programs/scene_tables.h"
#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("equal names are numbered in a program, skipping numbers already used", "[programs]") {
    Identifiers identifiers({"x_4"});
    CHECK(identifiers.once("x") == "x");
    CHECK(identifiers.once("x_3") == "x_3");
    CHECK(identifiers.once("x") == "x_2");
    CHECK(identifiers.once("x") == "x_5");
    CHECK(identifiers.once("x") == "x_6");
    CHECK(identifiers.once("x_3") == "x_3_2");
    CHECK(identifiers.once("y") == "y");
}

TEST_CASE("a name that a library may define is not used in a program", "[programs]") {
    Identifiers identifiers({});
    for (const std::string name :
         {"log", "NULL", "GLint", "glFlush", "OSMesaPixelStore", "M_PIf", "L_tmpnam", "P_tmpdir"})
        CHECK(identifiers.of(name, "object") == name + "_object");
    for (const std::string name : {"Teapot", "Left_lamp", "Moon", "Plate"})
        CHECK(identifiers.of(name, "object") == name);
}
