// `artisketch reconstruct` for many documents, each in a process of its own: what ends one of them,
// even a crash or want of memory, leaves the others alone, and each gives the bytes that it gives
// by itself.
#pragma once

#include "app/verbs.h"

namespace artisketch {

// Whether results go to folders, a file for each document: `a` names several documents, or -o ends
// in "/".
bool names_folder(const Arguments& a);

// Exit status: the largest of the documents' own, 130 where it was stopped.
int reconstruct_many(const Arguments& a);

}  // namespace artisketch
