-- explorer `@NAME@`: random stations
--
-- Draws planes, finger counts, transverse offsets and approach values. The order of the evaluations does not depend on
-- the budget, so that a larger one never ends with a worse station. All randomness comes from the seed.

return {
  kind = "explorer",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "The best of random stations",
  capabilities = { "rejects_nonfinite", "anytime" },
  parameters = {
    {
      name = "starts", type = "integer", default = 400, minimum = 1, maximum = 100000, unit = "stations",
      text = "stations that are drawn",
    },
  },
  new = function(p)
    return {
      -- problem.evaluate gives a score for each station until the budget is spent, then nil; the best one is kept.
      explore = function(problem)
        local low, high = problem.lowest, problem.highest
        local counts, offsets = problem.finger_counts, problem.transverse_offsets
        if problem.planes < 1 or #counts < 1 or #offsets < 1 then
          return nil
        end
        for _ = 1, p.starts do
          local station = {
            plane = math.random(problem.planes),
            approach = low + (high - low) * math.random(),
            virtual_fingers = counts[math.random(#counts)],
            transverse = offsets[math.random(#offsets)],
          }
          if not problem.evaluate({ station }) then
            break
          end
        end
        return nil
      end,
    }
  end,
}
