#include "preshape/io/page.h"

#include <fstream>

#include "preshape/io/report_json.h"
#include "reports.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

constexpr const char* kTemplate =
    "A<!--preshape:title-->B<!--preshape:sets-->C<!--preshape:report-->D<!--preshape:set-names-->E<!--"
    "preshape:scene-->F";

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const auto begin = text.find(from) + from.size();
  return text.substr(begin, text.find(to, begin) - begin);
}

}  // namespace

TEST_CASE("Page: the report stands in it as report_json gives it, and no text of it can end its element") {
  RunRecord record = records_of_every_status()[0];
  record.report.task.name = "</script><!-- & \"";
  const std::string json = between(page_html(kTemplate, record, ""), "C{", "}\nD");
  CHECK(json.find('<') == std::string::npos);
  std::string plain = json;
  for (auto at = plain.find("\\u003c"); at != std::string::npos; at = plain.find("\\u003c", at))
    plain.replace(at, 6, "<");
  CHECK("{" + plain + "}\n" == report_json(record));
  const std::string title = between(page_html(kTemplate, record, ""), "A", "B<svg");
  CHECK(title == record.object->object.name + ", &lt;/script>&lt;!-- &amp; \"");
}

TEST_CASE("Page: the sets are drawn and named, and the scene is in base 64") {
  const RunRecord& record = records_of_every_status()[0];
  const std::string page = page_html(kTemplate, record, "foobar");
  CHECK(between(page, "B", "\nC{").starts_with("<svg"));
  CHECK(between(page, "}\nD", "E") == "[\"RwdH\",\"RwdM\",\"RwdL\",\"Zero\",\"FwdL\",\"FwdM\",\"FwdH\"]");
  // RFC 4648, sec. 10.
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    CHECK(page_html(kTemplate, record, bytes).ends_with(fmt::format("]E{}F", text)));
  }
  CHECK(page_html(kTemplate, record, "\xff\xfe\xfd").ends_with("E//79F"));
}

TEST_CASE("Page: every way that a run ends has one") {
  for (const RunRecord& record : records_of_every_status()) {
    CHECK(page_html(kTemplate, record, "x").ends_with("EeA==F"));
  }
}

TEST_CASE("Page: a template that is absent or lacks a place is refused by name") {
  const TemporaryDirectory folder;
  CHECK_THROWS_SAYING(read_page_template(folder / "absent.html"), InputError, "absent.html' cannot be read");
  std::ofstream(folder / "page.html") << kTemplate;
  CHECK(read_page_template(folder / "page.html") == kTemplate);
  std::ofstream(folder / "cut.html") << std::string(kTemplate).substr(0, 60);
  CHECK_THROWS_SAYING(read_page_template(folder / "cut.html"), InputError,
                      "cut.html' lacks '<!--preshape:report-->'; build it again");
}

TEST_SUITE_END();
