#pragma once

#include "study_runs/study_folder.hpp"

namespace matrigrate::apps {

/// Points, runs and cost, in words or as JSON.
int print_plan(const study::StudyFolder& study, int jobs, bool json);

} // namespace matrigrate::apps
