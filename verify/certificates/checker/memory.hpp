// Memory for GMP's numbers, most of which are short and soon given back.
#pragma once

namespace certificate_checker {

// From then on, blocks that GMP gives back are kept for its next numbers of about their size. For a single thread, and
// before the first number.
void keep_memory_of_numbers();

}  // namespace certificate_checker
