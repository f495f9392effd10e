// OpenImageIO 2.4.7, Debian 12's, draws labels through a Strutil::utf8_to_unicode that keeps the
// last six bits of each character: Greek comes out as digits (its issue 3933). This program's own
// definition stands before the library's.
#include <OpenImageIO/strutil.h>

OIIO_NAMESPACE_BEGIN
namespace Strutil {

// NOLINTNEXTLINE(performance-unnecessary-value-param): the library's own signature
void utf8_to_unicode(string_view str, std::vector<uint32_t>& uvec) {
  for (std::size_t i = 0; i < str.size();) {
    const auto first = static_cast<unsigned char>(str[i++]);
    int following = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    uint32_t character = following == 0 ? first : first & (0x3FU >> following);
    for (; following > 0 && i < str.size(); --following) {
      character = character << 6U | (static_cast<unsigned char>(str[i++]) & 0x3FU);
    }
    uvec.push_back(character);
  }
}

}  // namespace Strutil
OIIO_NAMESPACE_END
