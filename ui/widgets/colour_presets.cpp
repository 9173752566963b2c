#include "ui/widgets/colour_presets.h"

#include <array>

namespace glint {

std::span<const ColourPreset> colour_presets() {
    // Lamps: Planck's law over the colour matching functions of CIE 1931 (Wyman, Sloan, Shirley 2013), to
    // linear sRGB, cut at 0 and divided by the largest channel.
    static constexpr std::array all{ColourPreset{"White", {1, 1, 1}},
                                    ColourPreset{"Half grey", {0.5f, 0.5f, 0.5f}},
                                    ColourPreset{"Middle grey, 18 %", {0.18f, 0.18f, 0.18f}},
                                    ColourPreset{"Black", {0, 0, 0}},
                                    ColourPreset{"Red", {1, 0, 0}},
                                    ColourPreset{"Yellow", {1, 1, 0}},
                                    ColourPreset{"Green", {0, 1, 0}},
                                    ColourPreset{"Cyan", {0, 1, 1}},
                                    ColourPreset{"Blue", {0, 0, 1}},
                                    ColourPreset{"Magenta", {1, 0, 1}},
                                    ColourPreset{"Candle", {1, 0.242f, 0}, 1900},
                                    ColourPreset{"Incandescent lamp", {1, 0.423f, 0.1f}, 2700},
                                    ColourPreset{"Halogen lamp", {1, 0.522f, 0.195f}, 3200},
                                    ColourPreset{"Moonlight", {1, 0.674f, 0.403f}, 4100},
                                    ColourPreset{"Sun at noon", {1, 0.852f, 0.755f}, 5500},
                                    ColourPreset{"Overcast sky", {1, 0.944f, 0.993f}, 6500},
                                    ColourPreset{"Blue sky", {0.61f, 0.695f, 1}, 10'000}};
    return all;
}

}  // namespace glint
