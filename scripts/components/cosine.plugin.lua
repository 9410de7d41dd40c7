-- similarity `cosine`
--
-- The cosine of the angle between the crisp six-vectors q of the task and w of the wrench, mapped to 0 .. 1:
--
--     s = ((1 + cos(q, w)) / 2) ^ sharpness,   cos(q, w) = q . w / (|q| |w|)
--
-- 1: the same direction, 0: the opposite one. Lengths do not count, fuzzy sets do not either. A zero vector has no
-- direction and counts as at a right angle to every vector. Components count as they stand, forces and moments alike.
--
-- | name | unit | range | default | meaning |
-- |---|---|---|---|---|
-- | sharpness | 1 | 0.01 .. 100 | 1 | power of the mapped cosine; above 1 it tells small angles better apart |
--
-- Use:  return { object = "cube", task = "T1_2", similarity = "cosine",
--                thresholds = { estimation = 0.75, recognition = 0.9 } }
--
-- Known failures: a wrench of the right direction and next to no strength scores as well as a strong one.

local function dot(x, y)
  local sum = 0.0
  for k = 1, 6 do sum = sum + x[k] * y[k] end
  return sum
end

--- Cosine of the angle between two vectors; 0 where one is zero.
local function cosine(x, y)
  local xx, yy = dot(x, x), dot(y, y)
  if xx == 0 or yy == 0 then return 0.0 end
  return math.max(-1.0, math.min(1.0, dot(x, y) / (math.sqrt(xx) * math.sqrt(yy))))
end

return {
  kind = "similarity",
  name = "cosine",
  version = "1.0.0",
  licence = "BSD-3-Clause",
  author = "the preshape developers",
  summary = "Cosine of the angle between task and wrench",
  capabilities = { "rejects_nonfinite", "symmetric", "permutation_invariant", "scale_invariant", "formula_cosine" },
  parameters = {
    {
      name = "sharpness", type = "number", default = 1, minimum = 0.01, maximum = 100, unit = "1",
      text = "power of the mapped cosine; above 1 it tells small angles better apart",
    },
  },
  new = function(p)
    return {
      scale = { farthest = 0, nearest = 1 },
      compare = function(task, pattern)
        return ((1 + cosine(task.crisp, pattern.crisp)) / 2) ^ p.sharpness
      end,
    }
  end,
}
