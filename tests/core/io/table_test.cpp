#include <cmath>
#include <cstdlib>
#include <limits>

#include "preshape/io/table.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

TEST_CASE("Table: columns are aligned, numbers to the right with three decimals, gaps as a dash") {
  const Table table{{"object", "score", "rows"}, {{"cube", 3.14159, 24}, {"toy_plane", -10.5, 1234567}, {Value{}, Value{}, 7}}};
  CHECK(table_text(table) ==
        "object       score     rows\n"
        "cube         3.142       24\n"
        "toy_plane  -10.500  1234567\n"
        "-                -        7\n");
}

TEST_CASE("Table: a last column of words has no trailing blanks") {
  CHECK(table_text({{"n", "text"}, {{1, "a"}, {2, "longer"}}}) == "n  text\n1  a\n2  longer\n");
}

TEST_CASE("Table: nothing is printed as minus zero") {
  for (const double x : {-0.0, -1e-9, -0.0004}) {
    const std::string text = table_text({{"x"}, {{x}, {1.5}}});
    CHECK(text.find("-0") == std::string::npos);
  }
}

TEST_CASE("Table: rows shorter than the columns are gaps at their end, and a table may be empty") {
  CHECK_NOTHROW(table_text({{"a", "b"}, {{1}}}));
  CHECK(table_text({{"a", "b"}, {{1}}}) == "a  b\n1\n");
  CHECK(table_text({{"a", "b"}, {}}) == "a  b\n");
  CHECK(table_csv({{"a"}, {}}) == "a\r\n");
}

TEST_CASE("CSV: cells with commas, quotes or line ends are quoted, quotes doubled, gaps empty (RFC 4180)") {
  const Table table{{"name", "a,b"}, {{"plain", 1}, {"say \"so\"", Value{}}, {"two\nlines", true}, {"cr\r", "x,y"}}};
  CHECK(table_csv(table) ==
        "name,\"a,b\"\r\nplain,1\r\n\"say \"\"so\"\"\",\r\n\"two\nlines\",true\r\n\"cr\r\",\"x,y\"\r\n");
}

TEST_CASE("CSV: numbers read back as the same double") {
  for (const double x : {0.1, 1.0 / 3.0, -2.5e-300, 1e300, 0.30000000000000004, 4.9e-324, 123456789.123456789}) {
    const std::string text = table_csv({{"x"}, {{x}}});
    CHECK(std::strtod(text.c_str() + 3, nullptr) == x);
  }
}

TEST_SUITE_END();
