#pragma once

#include <vector>

#include "preshape/base/parameters.h"
#include "preshape/grasp/approach_symbols.h"

namespace preshape {

/// How virtual grasps are analysed. Declared by analysis_schema.
struct AnalysisSettings {
  double length_U = 6.0;                ///< characteristic length L over U
  double opposition_angle_deg = 45.0;   ///< most deviation of opposed normals from exact opposition
  bool free_virtual_fingers = false;    ///< let searches choose the finger count, else rules R1 to R3 decide
  double station_step = 0.05;           ///< of the station grid, over the half extent
  std::vector<double> transverse_offsets = {0.0};  ///< that searches try, over the section's half width
  int most_forefingers = 3;             ///< that the hand has: no grasp asks for more
  double ray_margin_U = 0.5;            ///< least distance of the opened fingertips from the object
  ApproachSymbols::Universe universe = ApproachSymbols::Universe::kHalfExtent;

  PRESHAPE_API static AnalysisSettings from(const Parameters& parameters);
};
PRESHAPE_API const ParameterSchema& analysis_schema();

/// The critic's thresholds (spec section 12). Declared by threshold_schema.
struct Thresholds {
  double estimation = 3.0;   ///< similarity that serves a task
  double recognition = 5.5;  ///< similarity at which an object is known
  double search = 0.5;       ///< mode 1 looks at |x - x0| <= (1 - search) * extent

  PRESHAPE_API static Thresholds from(const Parameters& parameters);
};
PRESHAPE_API const ParameterSchema& threshold_schema();

/// How the agent learns. Declared by learning_schema.
struct LearningSettings {
  enum class Policy { kAsk, kLearn };
  enum class Teach { kWrench, kTask, kBoth };
  Policy policy = Policy::kAsk;     ///< of a known object whose new task a grasp would serve
  Teach teach = Teach::kBoth;       ///< which rows a lesson adds
  std::int64_t budget = 20000;      ///< most stations that one exploration evaluates

  PRESHAPE_API static LearningSettings from(const Parameters& parameters);
};
PRESHAPE_API const ParameterSchema& learning_schema();

/// How a grasp is carried out by the simulated hand. Declared by execution_schema.
struct ExecutionSettings {
  int attempts = 4;        ///< next-best stations that are tried when the hand cannot carry out the first
  bool reachable = false;  ///< only grasps that the hand carries out count
  int support_axis = -1;   ///< of O: the object stands on its side there; -1: it hangs in the air
  double support_sign = -1.0;

  PRESHAPE_API static ExecutionSettings from(const Parameters& parameters);
};
PRESHAPE_API const ParameterSchema& execution_schema();

/// What can be set of any explorer beside its own parameters: its budget. A default of 0 leaves it to learning.budget.
PRESHAPE_API const ParameterSchema& exploration_schema();

}  // namespace preshape
