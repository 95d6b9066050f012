// Eigen's code for SSE names this header and uses nothing of it; of SSE's headers Emscripten lacks
// this one alone.
#pragma once
