#pragma once
// Draws only the visible part of a column with thousands of lights or objects.

#include <vector>

namespace glint {

/// Keeps the height of each block from frame to frame, since all heights may differ.
class BlocksInSight {
  public:
    /// `lines`: the estimated height, in lines of text, of a block that has not been drawn yet.
    explicit BlocksInSight(float lines) : lines_(lines) {}

    /// Draws `count` blocks, one below the other, with draw(index). A block far outside the view only takes
    /// up its last height. Always drawn: the block `wanted`, to be scrolled to or measured, and the one with
    /// the mouse or the focus.
    template <class Draw> void draw(int count, const Draw& draw, int wanted = -1) {
        begin(count);
        for (int i = 0; i < count; ++i) {
            if (!begin_block(i, i == wanted)) continue;
            draw(i);
            end_block(i);
        }
        end();
    }

  private:
    void begin(int count);
    /// False if the block is skipped.
    bool begin_block(int index, bool is_wanted);
    void end_block(int index);
    void end();

    float lines_;
    std::vector<float> heights_;          // ImGui's units; 0: not drawn yet
    int held_ = -1;                       // the block with the control being edited
    float top_ = 0, low_ = 0, high_ = 0;  // where the block begins; the visible range with a margin
};

}  // namespace glint
