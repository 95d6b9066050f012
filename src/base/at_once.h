// Independent pieces of work on several threads.
#pragma once

#include <functional>

namespace artisketch {

// Threads that this machine runs at once; 1 where there are none, as in a page.
int threads_here();

// Calls work(i) for each i of [0, count), in no order, on up to `threads` threads; the calling one
// is among them, and alone does all where there is nothing to share. What a piece throws is thrown
// here, once all that were begun have ended; of several the one with the least i.
//
// Pieces must neither write what another reads nor take their result from the order in which they
// run: then it's the same, to the bit, for any number of threads.
void at_once(int count, int threads, const std::function<void(int)>& work);

}  // namespace artisketch
