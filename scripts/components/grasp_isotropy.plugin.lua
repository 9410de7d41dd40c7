-- quality `grasp_isotropy`
--
-- How evenly a grasp can push in all directions of wrench space: the smallest over the largest singular value of the
-- wrench union WU (one unit wrench a row, about O, lengths over L):
--
--     isotropy = sigma_min(WU) / sigma_max(WU)
--
-- 1: all directions alike, 0: there is a motion of the object that no contact resists. Source: the grasp isotropy index
-- [RoaSuarez2015]. The singular values are square roots of the eigenvalues of the 6 x 6 matrix WU' WU, by
-- cyclic Jacobi rotations [GolubVanLoan2013, ch. 8].
--
-- | name | unit | range | default | meaning |
-- |---|---|---|---|---|
-- | rank_tolerance | 1 | 0 .. 0.1 | 1e-06 | isotropy below this counts as none |
--
-- Use:  return { object = "cube", task = "T1_2", quality = { "sta_manu", "grasp_isotropy" } }
--
-- Known failures: it weighs forces against moments over L, so another characteristic length gives another number.
-- Squaring loses half of the digits: isotropy below 1e-7 is noise, hence the tolerance.

--- WU' WU, 6 x 6.
local function gram(rows)
  local g = { {}, {}, {}, {}, {}, {} }
  for i = 1, 6 do
    for j = i, 6 do
      local sum = 0.0
      for k = 1, #rows do
        local row = rows[k]
        sum = sum + row[i] * row[j]
      end
      g[i][j], g[j][i] = sum, sum
    end
  end
  return g
end

--- Turns rows and columns i and j of a symmetric matrix so that its element (i, j) becomes zero.
local function rotate(g, i, j)
  local gi, gj = g[i], g[j]
  local off = gi[j]
  if off == 0 then return end
  local theta = (gj[j] - gi[i]) / (2 * off)
  local t = (theta >= 0 and 1 or -1) / (math.abs(theta) + math.sqrt(theta * theta + 1))
  local c = 1 / math.sqrt(t * t + 1)
  local s = t * c
  for k = 1, 6 do
    if k ~= i and k ~= j then
      local gk = g[k]
      local x, y = gk[i], gk[j]
      local u, v = c * x - s * y, s * x + c * y
      gk[i], gk[j], gi[k], gj[k] = u, v, u, v
    end
  end
  gi[i], gj[j], gi[j], gj[i] = gi[i] - t * off, gj[j] + t * off, 0.0, 0.0
end

--- Whether what is left beside the diagonal is a rounding of it.
local function is_diagonal(g)
  local off, trace = 0.0, 0.0
  for i = 1, 6 do
    trace = trace + math.abs(g[i][i])
    for j = i + 1, 6 do off = off + math.abs(g[i][j]) end
  end
  return off <= 1e-17 * trace
end

--- Smallest and largest eigenvalue of a symmetric 6 x 6 matrix, which is overwritten.
local function extreme_eigenvalues(g)
  for _ = 1, 30 do
    if is_diagonal(g) then break end
    for i = 1, 5 do
      for j = i + 1, 6 do rotate(g, i, j) end
    end
  end
  local least, most = math.huge, -math.huge
  for i = 1, 6 do
    least, most = math.min(least, g[i][i]), math.max(most, g[i][i])
  end
  return least, most
end

return {
  kind = "quality",
  name = "grasp_isotropy",
  version = "1.0.0",
  licence = "BSD-3-Clause",
  author = "the preshape developers",
  summary = "Smallest over largest singular value of the wrench union",
  capabilities = { "rejects_nonfinite", "frame_invariant", "permutation_invariant", "force_scale_invariant" },
  parameters = {
    {
      name = "rank_tolerance", type = "number", default = 1e-6, minimum = 0, maximum = 0.1, unit = "1",
      text = "isotropy below this counts as none",
    },
  },
  new = function(p)
    return {
      numbers = { { name = "isotropy", unit = "1", lowest = 0, highest = 1 } },
      evaluate = function(grasp)
        local least, most = extreme_eigenvalues(gram(grasp.wrench_union))
        if most <= 0 then return 0.0 end
        local isotropy = math.sqrt(math.max(0, least) / most)
        return isotropy < p.rank_tolerance and 0.0 or isotropy
      end,
    }
  end,
}
