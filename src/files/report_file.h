// `--report`: what a run did and how well it fits, as JSON.
#pragma once

#include <string>

#include "model/stages.h"

namespace artisketch {

std::string report_text(const Document& document, const Reconstruction& result);
std::string report_text(const Document& document, const Calibration& result, double seconds);

}  // namespace artisketch
