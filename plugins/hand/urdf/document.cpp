#include "document.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <string>

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include "preshape/base/error.h"

namespace preshape::urdf_hand {

namespace {

constexpr std::uintmax_t kLargestFile = 64u << 20;
constexpr int kDeepest = 200;

/// Keeps the errors that are logged, instead of printing anything. The handler is the whole process's, hence
/// the lock.
class Silence final : public console_bridge::OutputHandler {
 public:
  Silence() : lock_(mutex()), before_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~Silence() override { console_bridge::useOutputHandler(before_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    errors.push_back(text);
    std::replace(errors.back().begin(), errors.back().end(), '\n', ' ');
  }

  std::vector<std::string> errors;

 private:
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }
  std::lock_guard<std::mutex> lock_;
  console_bridge::OutputHandler* before_;
};

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) refuse(file, fmt::format("cannot be read: {}", error.message()));
  if (size > kLargestFile)
    refuse(file, fmt::format("is larger than a URDF may be, {} bytes of {}", size, kLargestFile));
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.good() && !stream.eof()) refuse(file, "cannot be read");
  if (const auto zero = text.find('\0'); zero != std::string::npos)
    refuse(file, "is not text: it has a byte of value 0");
  return text;
}

/// The XML reader goes one call deeper for each element within another.
void demand_shallow(const std::filesystem::path& file, const std::string& text) {
  int depth = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '<' && text[i + 1] != '/' && text[i + 1] != '!' && text[i + 1] != '?') ++depth;
    if ((text[i] == '<' && text[i + 1] == '/') || (text[i] == '/' && text[i + 1] == '>')) --depth;
    if (depth > kDeepest)
      refuse(file, fmt::format("is no URDF: its elements are nested deeper than {}", kDeepest));
  }
}

/// "xacro:include" of the first element that xacro has still to replace; "" where none is left.
std::string macro_in(const TiXmlElement& element) {
  if (element.ValueStr().starts_with("xacro:")) return element.ValueStr();
  for (const auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (std::string found = macro_in(*child); !found.empty()) return found;
  }
  return {};
}

/// What urdfdom said, as one sentence.
std::string sentence_of(const std::vector<std::string>& errors) {
  std::string sentence;
  for (std::string error : errors) {
    while (error.ends_with('.') || error.ends_with(' ')) error.pop_back();
    sentence += (sentence.empty() ? "" : ": ") + error;
  }
  return sentence.empty() ? "urdfdom refuses it" : sentence;
}

void demand_robot(const std::filesystem::path& file, const std::string& text) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  if (document.Error()) {
    std::string error = document.ErrorDesc();
    while (error.ends_with('.')) error.pop_back();
    refuse(file, fmt::format("is not well-formed XML: {} in line {}; mend the file", error,
                             std::max(1, document.ErrorRow())));
  }
  const TiXmlElement* root = document.RootElement();
  if (!root) refuse(file, "is empty: it has no element <robot>");
  const std::string name = root->Value();
  const std::string macro = macro_in(*root);
  if (name == "robot" && !macro.empty())
    refuse(file, fmt::format("has the element <{}>; expand it first: xacro FILE > hand.urdf", macro));
  if (name == "robot") return;
  const char* other = name == "mujoco" ? " but a MuJoCo model" : name == "sdf" ? " but an SDF model" : "";
  refuse(file,
         fmt::format(
             "is no URDF{}: its first element, in line {}, is <{}>, not <robot>; give a URDF of the hand",
             other, root->Row(), name));
}

/// urdfdom keeps the last of two joints that move a link.
void demand_tree(const std::filesystem::path& file, const urdf::ModelInterface& model) {
  std::map<std::string, std::string> mover;
  for (const auto& [name, joint] : model.joints_) {
    const auto [other, first] = mover.emplace(joint->child_link_name, name);
    if (!first) {
      refuse(
          file,
          fmt::format(
              "is not a tree: link '{}' hangs on joint '{}' and on joint '{}'; a closed loop has to be cut",
              joint->child_link_name, other->second, name));
    }
  }
}

}  // namespace

void refuse(const std::filesystem::path& file, std::string_view sentence) {
  throw InputError(fmt::format("{}: {}", file.string(), sentence));
}

Document read_document(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  demand_shallow(file, text);
  demand_robot(file, text);
  Document document{file, nullptr, {}};
  {
    Silence silence;
    try {
      document.model = urdf::parseURDF(text);
    } catch (const std::exception& error) {
      silence.errors.push_back(error.what());
    }
    document.notes = std::move(silence.errors);
  }
  if (!document.model)
    refuse(file, fmt::format("is no usable URDF: {}; mend the file", sentence_of(document.notes)));
  demand_tree(file, *document.model);
  return document;
}

}  // namespace preshape::urdf_hand
