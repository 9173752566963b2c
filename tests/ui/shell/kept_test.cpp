// A cached result is recomputed for another key, and for no other reason.
#include "ui/widgets/kept.h"

#include "tests/support/catch.h"

using namespace glint;

TEST_CASE("a cached result is computed once for each new key", "[ui][kept]") {
    Kept<int, int> square;
    int computed = 0;
    const auto of = [&](int n) {
        return square.of(n, [&] {
            ++computed;
            return n * n;
        });
    };
    CHECK(square.value() == nullptr);
    CHECK(of(0) == 0);  // the key of an empty cache
    CHECK(of(0) == 0);
    CHECK(computed == 1);
    CHECK(of(3) == 9);
    CHECK(square.is_of(3));
    CHECK(of(0) == 0);
    CHECK(computed == 3);
    square.forget();
    CHECK_FALSE(square.is_of(0));
    CHECK(square.value() == nullptr);
}
