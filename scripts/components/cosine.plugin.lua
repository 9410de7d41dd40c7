-- similarity `cosine`
--
-- The cosine of the angle between the crisp six-vectors q of the task and w of the wrench, mapped to 0 .. 1:
--
--     s = ((1 + cos(q, w)) / 2) ^ sharpness,   cos(q, w) = q . w / (|q| |w|)
--
-- 1: the same direction, 0: the opposite one. Lengths do not count, fuzzy sets do not either. Two zero vectors are
-- equal (1); a zero vector is at a right angle to any other. Components count as they stand in the task, forces and
-- moments alike.
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

--- Cosine of the angle between two vectors; 1 for two zero vectors, 0 for one.
local function cosine(x, y)
  local xx, yy = dot(x, x), dot(y, y)
  if xx == 0 and yy == 0 then return 1.0 end
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
  capabilities = { "deterministic", "symmetric", "scale_invariant" },
  parameters = {
    {
      name = "sharpness", type = "number", default = 1, minimum = 0.01, maximum = 100, unit = "1",
      text = "power of the mapped cosine; above 1 it tells small angles better apart",
    },
  },
  new = function(p)
    local function score(x, y)
      return ((1 + cosine(x, y)) / 2) ^ p.sharpness
    end
    return {
      scale = { farthest = 0, nearest = 1 },
      compare = function(task, pattern) return score(task.crisp, pattern.crisp) end,
      -- Of one component alone: whether the signs agree.
      components = function(task, pattern)
        local scores = {}
        for k = 1, 6 do
          local product = task.crisp[k] * pattern.crisp[k]
          local both_zero = task.crisp[k] == 0 and pattern.crisp[k] == 0
          scores[k] = (product > 0 or both_zero) and 1.0 or product < 0 and 0.0 or 0.5 ^ p.sharpness
        end
        return scores
      end,
    }
  end,
}
