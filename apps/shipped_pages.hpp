#pragma once

#include <string_view>

namespace matrigrate::apps {

/// The pages that viewer/ builds, without data: they are part of the program.
std::string_view run_page_template();
std::string_view study_page_template();
std::string_view verdicts_page_template();

/// The script for Node.js that has the page of a run draw in a browser (viewer/drive.mjs).
std::string_view drive_script();

} // namespace matrigrate::apps
