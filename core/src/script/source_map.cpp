#include "source_map.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "lexer.h"

namespace preshape::lua {

namespace {

/// Constructors by the variable that holds them.
using Variables = std::map<std::string, std::size_t, std::less<>>;

/// A variable and the keys after it: `s.contact["mu"]`.
struct Path {
  struct Key {
    std::string name;
    int line;
  };
  std::string root;
  std::vector<Key> keys;
  std::size_t end;  ///< the token after it
};

/// An open brace, bracket or block.
struct Frame {
  enum class Kind { kTable, kBracket, kBlock } kind = Kind::kBlock;
  std::size_t constructor = 0;  ///< of a table
  bool at_field = false;        ///< of a table: a field begins here
  bool is_argument = false;     ///< of a table: `f{ ... }`
  Variables outer;              ///< of a block: the variables to return to
};

/// Who will hold the constructor that opens at a token: a key of another one, or a variable.
struct Owner {
  std::optional<std::size_t> constructor;
  std::string name;
};

class Mapper {
 public:
  Mapper(std::string_view source, std::size_t first_id)
      : source_(source), first_id_(first_id), tokens_(tokens_of(source)) {}

  SourceMap run() {
    while (tokens_[at_].kind != TokenKind::kEnd) step();
    const bool own_environment = std::any_of(tokens_.begin(), tokens_.end(), [](const Token& t) {
      return t.kind == TokenKind::kName && t.text == "_ENV";
    });
    map_.marked = own_environment ? std::string(source_) : marked();
    return std::move(map_);
  }

 private:
  const Token& token(std::size_t i) const { return tokens_[std::min(i, tokens_.size() - 1)]; }
  bool is_name(std::size_t i) const { return token(i).kind == TokenKind::kName; }
  bool in_table() const { return !frames_.empty() && frames_.back().kind == Frame::Kind::kTable; }
  bool in_block() const { return frames_.empty() || frames_.back().kind == Frame::Kind::kBlock; }

  void step() {
    if (in_table() && frames_.back().at_field && !token(at_).is("}")) {
      frames_.back().at_field = false;
      if (read_field()) return;
    }
    const Token& t = token(at_);
    if (t.kind == TokenKind::kName) return read_name();
    if (t.is("{")) return open_table();
    if (t.is("(") || t.is("[")) {
      frames_.push_back({Frame::Kind::kBracket, 0, false, false, {}});
    } else if (t.is("}") || t.is(")") || t.is("]") || t.is("end") || t.is("until")) {
      close();
    } else if (t.is("function") || t.is("if") || t.is("do") || t.is("repeat")) {
      open_block();
    } else if (t.is("for")) {
      read_loop_names();
    } else if ((t.is(",") || t.is(";")) && in_table()) {
      frames_.back().at_field = true;
    }
    ++at_;
  }

  // --- tables ---

  void open_table() {
    Frame frame{Frame::Kind::kTable, map_.constructors.size(), true, false, {}};
    map_.constructors.push_back({token(at_).line, {}, {}, {}});
    if (const auto owner = owners_.find(at_); owner != owners_.end()) {
      auto& holder =
          owner->second.constructor ? map_.constructors[*owner->second.constructor].inner : variables_;
      holder[owner->second.name] = frame.constructor;
    }
    if (at_ > 0) {
      // After a name, a string or a closing bracket a brace is the argument of a call.
      const Token& before = token(at_ - 1);
      frame.is_argument = before.kind == TokenKind::kName || before.kind == TokenKind::kString ||
                          before.is(")") || before.is("]") || before.is("}");
    }
    insert(token(at_).begin,
           fmt::format("{}__place({},", frame.is_argument ? "(" : "", first_id_ + frame.constructor));
    frames_.push_back(std::move(frame));
    ++at_;
  }

  /// At the begin of a field. True when it has a key that is known, which was passed with its '='.
  bool read_field() {
    ConstructorLines& constructor = map_.constructors[frames_.back().constructor];
    const int line = token(at_).line;
    std::string key;
    if (is_name(at_) && token(at_ + 1).is("=")) {
      key = token(at_).text;
      at_ += 2;
    } else if (token(at_).is("[")) {
      if (token(at_ + 1).kind != TokenKind::kString || !token(at_ + 2).is("]")) return false;
      key = token(at_ + 1).content;
      at_ += 4;
    } else {
      constructor.items.push_back(line);
      return false;
    }
    constructor.keys[key] = map_.last_key[key] = line;
    expect_constructor(at_, {frames_.back().constructor, key});
    return true;
  }

  /// Notes who holds the constructor if the expression that begins at token `i` is one, or passes one first
  /// thing to a call (`preshape.scenario{`, `setmetatable({`).
  bool expect_constructor(std::size_t i, Owner owner) {
    if (is_name(i)) {
      for (++i; (token(i).is(".") || token(i).is(":")) && is_name(i + 1);) i += 2;
      if (token(i).is("(")) ++i;
    }
    if (!token(i).is("{")) return false;
    owners_[i] = std::move(owner);
    return true;
  }

  // --- blocks and variables ---

  void open_block() {
    const bool is_function = token(at_).is("function");
    std::size_t parameters = at_ + 1;
    if (is_function && is_name(parameters)) {
      Path path = read_path(parameters);
      parameters = path.end;
      if (token(parameters).is(":")) {
        path.keys.push_back({std::string(token(parameters + 1).text), token(parameters + 1).line});
        parameters += 2;
      }
      assign(path, parameters);
    }
    frames_.push_back({Frame::Kind::kBlock, 0, false, false, variables_});
    if (is_function) {
      for (at_ = parameters; !token(at_).is(")"); ++at_) variables_.erase(std::string(token(at_).text));
    } else if (token(at_).is("do")) {
      for (const auto& name : loop_names_) variables_.erase(name);
      loop_names_.clear();
    }
  }

  void read_loop_names() {
    for (std::size_t i = at_ + 1; is_name(i); i += 2) loop_names_.emplace_back(token(i).text);
  }

  void close() {
    if (frames_.empty()) return;
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    if (frame.kind == Frame::Kind::kTable) insert(token(at_).begin + 1, frame.is_argument ? "))" : ")");
    if (frame.kind == Frame::Kind::kBlock) variables_ = frame.outer;
  }

  // --- assignments ---

  void read_name() {
    const bool continues = at_ > 0 && (token(at_ - 1).is(".") || token(at_ - 1).is(":"));
    if (continues && token(at_ + 1).is("=")) map_.last_key[std::string(token(at_).text)] = token(at_).line;
    if (!continues && in_block() && read_assignment()) return;
    ++at_;
  }

  /// `a.b, c = ...` with the '=' passed, or nothing.
  bool read_assignment() {
    std::vector<Path> targets;
    std::size_t i = at_;
    do {
      if (!targets.empty()) ++i;
      if (!is_name(i)) return false;
      targets.push_back(read_path(i));
      i = targets.back().end;
      if (token(i).is("<") && is_name(i + 1) && token(i + 2).is(">")) i += 3;  // local x <const>
    } while (token(i).is(","));
    if (!token(i).is("=")) return false;
    for (const auto& target : targets) assign(target, targets.size() == 1 ? i + 1 : tokens_.size());
    at_ = i + 1;
    return true;
  }

  Path read_path(std::size_t i) const {
    Path path{std::string(token(i).text), {}, i + 1};
    for (;;) {
      const std::size_t k = path.end;
      if (token(k).is(".") && is_name(k + 1)) {
        path.keys.push_back({std::string(token(k + 1).text), token(k + 1).line});
        path.end = k + 2;
      } else if (token(k).is("[") && token(k + 1).kind == TokenKind::kString && token(k + 2).is("]")) {
        path.keys.push_back({std::string(token(k + 1).content), token(k + 1).line});
        path.end = k + 3;
      } else {
        return path;
      }
    }
  }

  /// The constructor that the path leads to without its last `but` keys, if the text shows it.
  std::optional<std::size_t> resolve(const Path& path, std::size_t but) const {
    const auto root = variables_.find(path.root);
    if (root == variables_.end()) return {};
    std::size_t constructor = root->second;
    for (std::size_t k = 0; k + but < path.keys.size(); ++k) {
      const auto& inner = map_.constructors[constructor].inner;
      const auto next = inner.find(path.keys[k].name);
      if (next == inner.end()) return {};
      constructor = next->second;
    }
    return constructor;
  }

  /// `value` is the token at which the value begins.
  void assign(const Path& target, std::size_t value) {
    if (target.keys.empty()) {
      if (expect_constructor(value, {{}, target.root})) return;
      const auto alias = is_name(value) ? resolve(read_path(value), 0) : std::nullopt;
      alias ? void(variables_[target.root] = *alias) : void(variables_.erase(target.root));
      return;
    }
    const auto& [key, line] = target.keys.back();
    map_.last_key[key] = line;
    const auto holder = resolve(target, 1);
    if (!holder) return;
    map_.constructors[*holder].keys[key] = line;
    map_.constructors[*holder].inner.erase(key);
    expect_constructor(value, {holder, key});
  }

  // --- the marked text ---

  void insert(std::size_t offset, std::string text) { insertions_.emplace_back(offset, std::move(text)); }

  std::string marked() const {
    std::string text;
    std::size_t from = 0;
    for (const auto& [offset, insertion] : insertions_) {
      text.append(source_, from, offset - from).append(insertion);
      from = offset;
    }
    return text.append(source_, from);
  }

  std::string_view source_;
  std::size_t first_id_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<Frame> frames_;
  Variables variables_;
  std::map<std::size_t, Owner> owners_;
  std::vector<std::string> loop_names_;
  std::vector<std::pair<std::size_t, std::string>> insertions_;
  SourceMap map_;
};

}  // namespace

SourceMap map_source(std::string_view source, std::size_t first_id) {
  return Mapper(source, first_id).run();
}

}  // namespace preshape::lua
