// Where the program starts.
#include <fmt/core.h>

int main() {
    fmt::print("glint {}\n", GLINT_VERSION);
    return 0;
}
