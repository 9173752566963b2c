#pragma once
// What is pasted into a field of one line.

namespace glint {

/// Text fields leave out the line breaks of what is pasted: of a table's column they would make one number.
/// While this lives a break within the text is a space, with which it is not a number, and that is said.
class PasteInOneLine {
  public:
    PasteInOneLine();
    ~PasteInOneLine();
    PasteInOneLine(const PasteInOneLine&) = delete;
    PasteInOneLine& operator=(const PasteInOneLine&) = delete;
};

}  // namespace glint
