#pragma once
// A column of a scene with thousands of lights or objects: only what is in sight is laid out.

#include <vector>

namespace glint {

/// What is remembered of such blocks from frame to frame: how high each is, since no two need be alike.
class BlocksInSight {
  public:
    /// `lines`: the room, in lines of text, of a block that was not drawn yet.
    explicit BlocksInSight(float lines) : lines_(lines) {}

    /// Draws `count` blocks, one below the other, with draw(index). Of one that is far from sight only the
    /// room is kept that it took when it was drawn last. `wanted`: the block that is drawn wherever it is, to
    /// be scrolled to or measured; so is the one that has the mouse or the keys.
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
    /// False where the block is skipped.
    bool begin_block(int index, bool is_wanted);
    void end_block(int index);
    void end();

    float lines_;
    std::vector<float> heights_;          // ImGui's units; 0: not drawn yet
    int held_ = -1;                       // the block whose control is in hand
    float top_ = 0, low_ = 0, high_ = 0;  // where the block begins; what is in sight or near
};

}  // namespace glint
