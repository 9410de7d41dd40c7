#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/geometry/object.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/features.h"

namespace preshape {

/// An object that the agent has met.
struct MemoryObject {
  std::string hash;  ///< SHA-256 of its content, 64 lower-case hex digits (object_hash)
  std::string name, file;
  std::array<double, 3> extents_m{};  ///< width, height, depth [m]
  ObjectAttributes attributes;
  std::int64_t first_seen = 0;  ///< 1, 2, 3 .. in the order of meeting; the memory gives it
  std::string first_seen_utc;   ///< a time in words, or ""; informative only
};

/// What a sample's six task components stand for.
enum class Provenance : std::int32_t {
  kPretrain,  ///< a resultant wrench of the pretraining set
  kWrench,    ///< the resultant wrench of the grasp that was learned
  kTask       ///< the task as it was asked
};

PRESHAPE_API std::string_view provenance_name(Provenance provenance);

/// One row that the classifier is trained on (thesis sec. 3.10, appendix A).
struct Sample {
  std::int64_t id = 0;  ///< the memory gives it: ascending, never used again
  std::string object;   ///< its object's hash
  Provenance provenance = Provenance::kTask;
  Features inputs{};                               ///< finite
  int plane = 0, symbol = 0, virtual_fingers = 0;  ///< the target, each from 1
  double approach_m = 0.0;                         ///< the exact approach value x [m]
  double approach_ratio = 0.0;                     ///< x over the object's half extent along a
  std::array<double, 6> wrench{};  ///< resultant of the taught grasp, normalised; NaN where unknown
  double score = std::numeric_limits<double>::quiet_NaN();  ///< similarity when taught; NaN where unknown
  std::string task;                                         ///< its task's name, or ""
  std::int64_t session = 0;  ///< of the learning that added it; the memory gives it
};

/// A trained classifier. It has learned every sample up to `last_sample`.
struct ClassifierState {
  std::int64_t id = 0;    ///< the memory gives it
  std::string component;  ///< "mlp"
  std::string parameters_json;
  std::string bytes;  ///< Classifier::save()
  std::int64_t last_sample = 0;
  TrainingOutcome outcome;
  std::uint64_t seed = 0;
  std::int64_t session = 0;  ///< of the learning that stored it; the memory gives it
};

struct MemoryStatistics {
  std::int64_t objects = 0, pretrain_samples = 0, wrench_samples = 0, task_samples = 0, states = 0;
  std::int64_t sessions = 0;  ///< learnings committed so far
  std::int64_t schema_version = 0;
  std::int64_t bytes = 0;
  std::int64_t samples() const { return pretrain_samples + wrench_samples + task_samples; }
};

/// What a `forget` took away.
struct Forgotten {
  std::int64_t samples = 0, states = 0;
};

class Learning;
struct MemoryParts;

/// The agent's memory (thesis sec. 3.1): objects, samples and classifier states in one SQLite file, which any
/// SQLite tool can read. One Memory serves one thread at a time. Several processes may use one file at once:
/// readers never wait, learnings come one after the other. All changes go through a Learning, and one that
/// was committed is still there after the process is killed or the power fails (write-ahead log,
/// synchronous=FULL). The file must be on a local disk: the log needs shared memory, which network file
/// systems lack.
/// @throws InputError from every call when the file is damaged, full, or in use beyond the time-out
class PRESHAPE_API Memory {
 public:
  enum class Mode {
    kReadWrite,  ///< the file must exist
    kCreate,     ///< makes it where it is absent or empty
    kReadOnly
  };

  /// @param busy_timeout_s how long to wait for another process' learning to end
  /// @throws InputError when the file is absent, not a memory, damaged, of a newer schema, or not permitted.
  ///         A file that is not a memory is only looked at, never changed.
  static Memory open(const std::filesystem::path& path, Mode mode, double busy_timeout_s = 30.0);
  /// Lives as long as the object does.
  static Memory in_memory();
  /// In no file, with what a file holds now.
  /// @throws InputError as open
  static Memory copy_of(const std::filesystem::path& path);

  Memory(Memory&&) noexcept;
  Memory& operator=(Memory&&) noexcept;
  ~Memory();

  /// In the order of first meeting.
  std::vector<MemoryObject> objects() const;
  std::optional<MemoryObject> object(std::string_view hash) const;
  /// In the order of learning, those after sample `after`.
  std::vector<Sample> samples(std::int64_t after = 0) const;
  std::vector<Sample> samples_of(std::string_view object_hash) const;
  /// The newest state of a component ("mlp"), or none.
  std::optional<ClassifierState> latest_state(std::string_view component) const;
  std::optional<std::string> note(std::string_view key) const;
  MemoryStatistics statistics() const;

  /// Number of the last committed learning, whoever did it: what was read before is stale once it changes.
  std::int64_t generation() const;

  /// Until it is destroyed, all that is read is of one moment, whatever other processes commit meanwhile.
  class PRESHAPE_API Snapshot {
   public:
    ~Snapshot();
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;

   private:
    friend class Memory;
    explicit Snapshot(MemoryParts& parts);
    MemoryParts& parts_;
  };
  /// At most one at a time, and not during a Learning.
  Snapshot snapshot() const;

  /// Takes the write lock at once, so that what is read from now on cannot change before commit.
  /// @param utc a time in words to note with the session, or ""
  Learning begin_learning(std::string_view utc = {});

  /// SQLite's own check of the whole file: empty when it is sound, else what is wrong.
  std::vector<std::string> integrity_faults() const;

  /// The path, or "(in memory)".
  const std::string& name() const;

 private:
  explicit Memory(std::unique_ptr<MemoryParts> parts);
  std::unique_ptr<MemoryParts> parts_;
};

/// One learning: all of it is committed or nothing. Undone when it is destroyed without commit. What it has
/// added can be read through its Memory at once; other processes see it after commit.
class PRESHAPE_API Learning {
 public:
  Learning(Learning&& other) noexcept;
  Learning& operator=(Learning&&) = delete;
  ~Learning();

  std::int64_t session() const { return session_; }

  /// @returns false when the hash is known; the first record of an object stays
  bool add_object(const MemoryObject& object);
  /// Its id and session are given by the memory. Minus zero is stored as zero.
  /// @returns the id
  /// @throws InputError when its object is unknown or a number is not finite (see Sample)
  std::int64_t add_sample(const Sample& sample);
  /// Of each component the newest kStatesKept states stay.
  /// @returns the id
  std::int64_t store_state(const ClassifierState& state);
  static constexpr int kStatesKept = 8;
  /// A word about the memory as a whole; "" removes it.
  void set_note(std::string_view key, std::string_view value);

  /// Takes an object away with its samples. States that have learned one of them go too: a classifier cannot
  /// unlearn a row, so it is fitted anew from what is left (an older state without them stays).
  Forgotten forget_object(std::string_view hash);
  Forgotten forget_samples(std::span<const std::int64_t> ids);

  void commit();

 private:
  friend class Memory;
  Learning(MemoryParts& parts, std::string_view utc);
  MemoryParts& open() const;
  MemoryParts* parts_;  ///< null once committed
  std::int64_t session_ = 0;
};

}  // namespace preshape
