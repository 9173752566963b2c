#pragma once
// *Predict*: the user picks a pixel, changes the scene while the picture is frozen, predicts the pixel's
// colour, and then sees it.

#include <array>
#include <glm/vec2.hpp>
#include <optional>

#include "models/json/json.h"
#include "ui/commands/keys.h"

namespace glint {

struct UiState;

enum class PredictStage { Off, Pick, Change, Revealed };

struct PredictState {
    PredictState() noexcept(false) = default;  // JSON may allocate

    PredictStage stage = PredictStage::Off;
    std::optional<glm::dvec2> probe;           // the pixel, as a fraction of the picture's size
    std::array<int, 3> before{};               // the pixel's colour when the picture was frozen, 0 to 255
    Json mine;                                 // the prediction, channels from 0 to 1; null: none yet
    bool takes_keys = false;                   // the colour's first field gets focus
    std::optional<std::array<int, 3>> answer;  // the real colour, once the picture is unfrozen
};

/// Starts a prediction for the picked pixel, or requests a pixel; cancels a prediction in progress.
void switch_prediction(UiState& state);
/// Unfreezes the picture without an answer.
void end_prediction(UiState& state);

/// Enter focuses the colour's fields, then locks the colour in, then begins again. Returns true if the key is
/// consumed.
bool predict_by_key(UiState& state, KeyPress press);

/// Once a frame, before the columns: follows the picked pixel, and stores the answer when it is drawn.
void poll_prediction(UiState& state);
/// Draws the prediction into the WHY column. True if the usual contents may follow below it.
[[nodiscard]] bool predict_panel(UiState& state);

}  // namespace glint
