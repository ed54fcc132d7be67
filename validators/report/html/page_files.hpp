// Private to this folder: the files of the page, as the program carries them.
#pragma once

#include <string_view>

namespace mapwright::validators::page_files {

extern const std::string_view kStyle;   ///< CSS
extern const std::string_view kTheme;   ///< script that chooses light or dark before all else
extern const std::string_view kBody;    ///< the page's elements, open at its end for data
extern const std::string_view kScript;  ///< all the rest

/// What a Content Security Policy calls the three: "'sha256-…'".
extern const std::string_view kStyleHash, kThemeHash, kScriptHash;

}  // namespace mapwright::validators::page_files
