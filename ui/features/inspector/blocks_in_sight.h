#pragma once
// Layout of only the visible part of a column with thousands of lights or objects.

#include <vector>

namespace glint {

/// State of such blocks from frame to frame: the height of each, since they may all differ.
class BlocksInSight {
  public:
    /// `lines`: the estimated height, in lines of text, of a block that was not drawn yet.
    explicit BlocksInSight(float lines) : lines_(lines) {}

    /// Draws `count` blocks, one below the other, with draw(index). A block far outside the view only keeps
    /// its last height. `wanted`: the block that is always drawn, to be scrolled to or measured; so is the
    /// one with the mouse or the focus.
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
    int held_ = -1;                       // the block whose control is being edited
    float top_ = 0, low_ = 0, high_ = 0;  // where the block begins; the visible range with a margin
};

}  // namespace glint
