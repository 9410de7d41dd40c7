#include "preshape/agent/memory_csv.h"

#include <sstream>

#include "memory_examples.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

Memory example_memory() {
  Memory memory = Memory::in_memory();
  Learning learning = memory.begin_learning();
  for (int number = 1; number <= 3; ++number) {
    MemoryObject object = example_object(number);
    if (number == 2) object.name = "a \"quoted\", two\r\nline name";
    learning.add_object(object);
  }
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Sample sample = example_sample(1 + static_cast<int>(seed % 3), seed);
    const auto object = memory.object(sample.object);
    const ObjectAttributes& a = object->attributes;
    std::copy_n(
        std::array{a.width_normalised, a.height_normalised, a.depth_normalised, a.vertices_per_triangle,
                   a.normals_per_triangle, a.faces_per_triangle, a.kilotriangles}
            .begin(),
        7, sample.inputs.begin() + 8);
    if (seed == 4) sample.score = std::numeric_limits<double>::quiet_NaN();
    if (seed == 5) sample.wrench.fill(std::numeric_limits<double>::quiet_NaN());
    if (seed == 6) sample.task = "", sample.inputs[0] = 1e-310;
    learning.add_sample(sample);
  }
  learning.commit();
  return memory;
}

std::string exported(const Memory& memory) {
  std::ostringstream out;
  export_samples(memory, out);
  return out.str();
}

std::int64_t imported(Memory& memory, const std::string& text) {
  std::istringstream in(text);
  return import_samples(memory, in, "rows.csv");
}

/// The header and one row of plain fields.
std::string one_row() {
  Memory memory = Memory::in_memory();
  Learning learning = memory.begin_learning();
  learning.add_object(example_object(1));
  learning.add_sample(example_sample(1, 1));
  learning.commit();
  return exported(memory);
}

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const auto place = text.find(old_part);
  REQUIRE(place != std::string::npos);
  return text.replace(place, old_part.size(), new_part);
}

/// Replaces a field of the second line by its column's name.
std::string with_field(const std::string& text, const std::string& column, const std::string& field) {
  const auto end = text.find('\n');
  std::istringstream names(text.substr(0, end)), fields(text.substr(end + 1));
  std::string name, old_field, line;
  while (std::getline(names, name, ',') && std::getline(fields, old_field, ',')) {
    line += (line.empty() ? "" : ",") + (name == column ? field : old_field);
  }
  return text.substr(0, end + 1) + line;
}

void refuse(const std::string& text, const std::string& part) {
  Memory memory = Memory::in_memory();
  CHECK_THROWS_SAYING(imported(memory, text), InputError, part);
  CHECK(memory.samples().empty());
  CHECK(memory.objects().empty());
  CHECK(memory.generation() == 0);
}

}  // namespace

TEST_CASE("CSV: export, import and export again give the same bytes") {
  const Memory memory = example_memory();
  const std::string text = exported(memory);
  Memory copy = Memory::in_memory();
  CHECK(imported(copy, text) == 30);
  CHECK(exported(copy) == text);
  const auto samples = memory.samples(), copies = copy.samples();
  REQUIRE(copies.size() == samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i != 4 && i != 5) CHECK(same(copies[i], samples[i]));  // those two hold NaN
  }
  CHECK(std::isnan(copies[4].score));
  CHECK(std::isnan(copies[5].wrench[3]));
  CHECK(copy.object(example_hash(2))->name == "a \"quoted\", two\r\nline name");
  CHECK(copy.object(example_hash(2))->attributes.depth_normalised == 0.339);
}

TEST_CASE("CSV: an empty memory exports its header alone, and that imports as nothing") {
  Memory memory = Memory::in_memory();
  const std::string text = exported(memory);
  CHECK(text.starts_with("object_hash,object_name,object_file,width_m,"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 1);
  CHECK(imported(memory, text) == 0);
  CHECK(memory.generation() == 0);
}

TEST_CASE(
    "CSV: a spreadsheet's byte order mark, line ends, blank lines and missing last line end do not matter") {
  const std::string text = one_row();
  std::string other = "\xef\xbb\xbf";
  for (const char c : text) other += c == '\n' ? std::string("\r\n\r\n") : std::string(1, c);
  while (other.back() == '\n' || other.back() == '\r') other.pop_back();
  Memory memory = Memory::in_memory();
  CHECK(imported(memory, other) == 1);
  CHECK(exported(memory) == text);
}

TEST_CASE("CSV: the order of the columns does not matter") {
  const std::string text = one_row();
  std::istringstream lines(text);
  std::string header, row, turned;
  std::getline(lines, header), std::getline(lines, row);
  for (const auto& line : {header, row}) {
    const auto comma = line.find(',');
    turned += line.substr(comma + 1) + "," + line.substr(0, comma) + "\n";
  }
  Memory memory = Memory::in_memory();
  CHECK(imported(memory, turned) == 1);
  CHECK(exported(memory) == text);
}

TEST_CASE("CSV: a bad field is told with source, line, column and text, and nothing is imported") {
  const std::string good = one_row();
  refuse(with_field(good, "plane", "0"), "rows.csv:2: column 'plane' must be 1 or more, got '0'");
  refuse(with_field(good, "plane", "3.5"), "rows.csv:2: column 'plane' must be a whole number, got '3.5'");
  refuse(with_field(good, "symbol", ""), "column 'symbol' must be a whole number, got ''");
  refuse(with_field(good, "virtual_fingers", "99999999999"),
         "column 'virtual_fingers' must be a whole number");
  refuse(with_field(good, "tx", "one"), "rows.csv:2: column 'tx' must be a number, got 'one'");
  refuse(with_field(good, "tx", "1.5 "), "column 'tx' must be a number, got '1.5 '");
  refuse(with_field(good, "depth", "nan"), "column 'depth' must be a finite number, got 'nan'");
  refuse(with_field(good, "score", "inf"), "column 'score' must be a finite number, got 'inf'");
  refuse(with_field(good, "rz", "1e999"), "column 'rz' must be a number, got '1e999'");
  refuse(with_field(good, "provenance", "wrnch"),
         "column 'provenance' cannot be 'wrnch'; did you mean 'wrench'?");
  refuse(with_field(good, "object_hash", "12ab"),
         "column 'object_hash' must be 64 lower-case hex digits, got '12ab'");
  refuse(with_field(good, "object_name", std::string("a\0b", 3)),
         "column 'object_name' contains a zero byte");
}

TEST_CASE("CSV: a fault in the last row leaves none of the rows before it") {
  std::string text = exported(example_memory());
  refuse(text + "1,2,3\n", "3 fields, but the header names 35 columns");
  // A header, thirty rows, and ten of them with a name of two lines.
  refuse(text + "\"open", "rows.csv:42: a quoted field is not closed");
}

TEST_CASE("CSV: a wrong header is told") {
  const std::string good = one_row();
  refuse("", "rows.csv:1: no header line");
  refuse(with(good, ",plane,", ",plan,"), "rows.csv:1: unknown column 'plan'; did you mean 'plane'?");
  refuse(with(good, ",plane,", ",symbol,"), "column 'symbol' stands twice");
  refuse(with(good, ",plane", ""), "rows.csv:1: the header lacks column 'plane'");
}

TEST_CASE("CSV: stray quotes and carriage returns are told") {
  const std::string good = one_row();
  refuse(with(good, "object 1", "obj\"ect"), "rows.csv:2: a quote within a field without quotes");
  refuse(with(good, "object 1", "\"object\" 1"), "rows.csv:2: text after a closing quote");
  refuse(with(good, "object 1", "object\r1"), "rows.csv:2: a carriage return within a line");
}

TEST_CASE("CSV: one hash with two descriptions is told") {
  const std::string good = one_row();
  const std::string row = good.substr(good.find('\n') + 1);
  refuse(good + with(row, "object 1", "object one"),
         "rows.csv:3: its object's name, file or extents differ from line 2");
}

TEST_CASE("CSV: random damage is refused or imported, but never half") {
  const std::string text = exported(example_memory());
  Random random(3);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = text;
    damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    if (i % 3 == 0) damaged.resize(random.below(damaged.size()));
    Memory memory = Memory::in_memory();
    std::int64_t rows = 0;
    try {
      rows = imported(memory, damaged);
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).starts_with("rows.csv:"));
      ++refused;
    }
    CHECK(static_cast<std::int64_t>(memory.samples().size()) == rows);
  }
  CHECK(refused > 100);
}

TEST_SUITE_END();
