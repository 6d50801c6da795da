#pragma once

#include <string>
#include <string_view>

namespace algae {

/// A text as HTML and XML have it between tags and within double quotes.
///
/// Example: escaped_markup("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;"
std::string escaped_markup(std::string_view text);

}  // namespace algae
