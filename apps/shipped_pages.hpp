#pragma once

#include <string_view>

namespace matrigrate::apps {

/// The pages that viewer/ builds, without data: they are part of the program.
std::string_view run_page_template();
std::string_view study_page_template();
std::string_view verdicts_page_template();

} // namespace matrigrate::apps
