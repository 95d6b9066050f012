#include "model/stages.h"
