#include "io/bitmap_font.h"

namespace preshape {

namespace {

/// From the space to the tilde: nine rows of five pixels each, a row a digit to base 32, its highest bit on
/// the left. The last two rows hold descenders.
constexpr std::string_view kGlyphs[] = {
    "000000000", "444440400", "AAA000000", "AAVAVAA00", "4FKE5U400", "OP248J300", "CIK8LID00", "444000000",
    "248884200", "842224800", "04LEL4000", "044V44000", "00000CC48", "000V00000", "00000CC00", "01248G000",
    "EHJLPHE00", "4C4444E00", "EH1248V00", "V2421HE00", "26AIV2200", "VGU11HE00", "68GUHHE00", "V12488800",
    "EHHEHHE00", "EHHF12C00", "0CC0CC000", "0CC00CC48", "248G84200", "00V0V0000", "842124800", "EH1240400",
    "EHNLNGE00", "EHHVHHH00", "UHHUHHU00", "EHGGGHE00", "SIHHHIS00", "VGGUGGV00", "VGGUGGG00", "EHGNHHE00",
    "HHHVHHH00", "E44444E00", "72222IC00", "HIKOKIH00", "GGGGGGV00", "HRLLHHH00", "HHPLJHH00", "EHHHHHE00",
    "UHHUGGG00", "EHHHLID00", "UHHUKIH00", "FGGE11U00", "V44444400", "HHHHHHE00", "HHHHHA400", "HHHLLLA00",
    "HHA4AHH00", "HHHA44400", "V1248GV00", "E88888E00", "0G8421000", "E22222E00", "4AH000000", "0000000V0",
    "842000000", "00E1FHF00", "GGMPHHU00", "00EGGHE00", "11DJHHF00", "00EHVGE00", "698S88800", "00FHHHF1E",
    "GGMPHHH00", "40C444E00", "2062222IC", "GGIKOKI00", "C44444E00", "00QLLHH00", "00MPHHH00", "00EHHHE00",
    "00UHHHUGG", "00FHHHF11", "00MPGGG00", "00FGE1U00", "88S889600", "00HHHJD00", "00HHHA400", "00HHLLA00",
    "00HA4AH00", "00HHHHF1E", "00V248V00", "244844200", "444444400", "844244800", "008L20000"};
static_assert(std::size(kGlyphs) == '~' - ' ' + 1);

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

/// Whether the glyph's pixel is drawn; none is outside.
bool inked(std::string_view glyph, int x, int y) {
  if (x < 0 || x > 4 || y < 0 || y > 8) return false;
  const char digit = glyph[static_cast<std::size_t>(y)];
  const int row = digit <= '9' ? digit - '0' : digit - 'A' + 10;
  return ((row >> (4 - x)) & 1) != 0;
}

/// A pixel of the glyph at twice its size: steps of slanted lines are filled where both neighbours are drawn
/// and the opposite ones are not.
bool inked_twice(std::string_view glyph, int x, int y) {
  const int column = x >> 1, row = y >> 1, across = (x & 1) != 0 ? 1 : -1, down = (y & 1) != 0 ? 1 : -1;
  if (inked(glyph, column, row)) return true;
  return inked(glyph, column + across, row) && inked(glyph, column, row + down) &&
         !inked(glyph, column + across, row + down) && !inked(glyph, column - across, row) &&
         !inked(glyph, column, row - down);
}

}  // namespace

void draw_text(Image& image, int x, int y, std::string_view words, Rgb colour, int scale) {
  int left = x;
  for (const char c : words) {
    if (is_continuation(c)) continue;
    const std::string_view glyph = kGlyphs[c >= ' ' && c <= '~' ? c - ' ' : '?' - ' '];
    for (int v = 0; v < kLetterHeight * scale; ++v) {
      for (int u = 0; u < kLetterWidth * scale; ++u) {
        if (left + u < 0 || left + u >= image.width() || y + v < 0 || y + v >= image.height()) continue;
        const bool ink = scale == 1 ? inked(glyph, u, v) : inked_twice(glyph, 2 * u / scale, 2 * v / scale);
        if (ink) image.at(left + u, y + v) = colour;
      }
    }
    left += kLetterWidth * scale;
  }
}

int text_width(std::string_view words, int scale) {
  int letters = 0;
  for (const char c : words) letters += !is_continuation(c);
  return letters * kLetterWidth * scale;
}

std::vector<std::string> wrapped(std::string_view words, int width, int scale, int lines) {
  std::vector<std::string> all;
  const std::size_t most =
      std::max<std::size_t>(4, static_cast<std::size_t>(std::max(0, width / (kLetterWidth * scale))));
  while (!words.empty()) {
    std::size_t end = words.size();
    if (end > most) {
      end = words.rfind(' ', most);
      if (end == std::string_view::npos || end == 0) end = most;
      while (end > 1 && is_continuation(words[end])) --end;
    }
    if (static_cast<int>(all.size()) == lines) {
      all.back() = all.back().substr(0, most - 3) + "...";
      break;
    }
    all.emplace_back(words.substr(0, end));
    words.remove_prefix(std::min(words.size(), end + (end < words.size() && words[end] == ' ')));
  }
  return all;
}

}  // namespace preshape
