#pragma once
// *Predict*: the user picks a pixel, changes the scene while the picture stands still, says what the pixel's
// colour will be, and is shown what it is.

#include <array>
#include <glm/vec2.hpp>
#include <optional>

#include "models/json/json.h"
#include "ui/commands/keys.h"

namespace glint {

struct UiState;

enum class PredictStage { Off, Pick, Change, Revealed };

struct PredictState {
    PredictStage stage = PredictStage::Off;
    std::optional<glm::dvec2> probe;  // the pixel, as a share of the picture's size
    std::array<int, 3> before{};      // its colour when the picture was stopped, 0 to 255
    Json mine;                        // what it will be, channels from 0 to 1; null: nothing is said yet
    bool takes_keys = false;          // the colour's first field shall get the keyboard
    std::optional<std::array<int, 3>> answer;  // what it is, once the picture goes on
};

/// Begins with the picked pixel, or asks for one; while it goes on, gives it up.
void switch_prediction(UiState& state);
/// The picture goes on, whatever was said.
void end_prediction(UiState& state);

/// Enter leads to the colour's fields, locks it in, and begins again; true: the key is taken.
bool predict_by_key(UiState& state, KeyPress press);

/// Once a frame, before the columns: follows the pixel that is picked, and takes the answer when it is drawn.
void poll_prediction(UiState& state);
/// Draws it into the WHY column. True when what usually stands there may stand below it.
[[nodiscard]] bool predict_panel(UiState& state);

}  // namespace glint
