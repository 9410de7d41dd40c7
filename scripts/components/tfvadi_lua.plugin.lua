-- similarity `tfvadi_lua`
--
-- Total fuzzy vector approaching degree index (thesis eq. 3.9.7 to 3.9.11): the readable twin of similarity `tfvadi`,
-- which is its C++. Both give the same bits. For each of the six components, with the fuzzy vectors q of the task and w
-- of the wrench:
--
--     ADI(q, w) = min( max_i min(q_i, w_i), 1 - min_i max(q_i, w_i) )
--
-- and the index is their sum: 0 .. 6, higher is nearer. Source: Wang (1983) as the thesis cites it.
--
-- It has no parameters.
--
-- Use:  return { object = "cube", task = "T1_2", similarity = "tfvadi_lua" }
--
-- Known failures: a component that lies between two sets costs up to 0.5 even for equal patterns, see the page of
-- `tfvadi`.

--- Approaching degree of two fuzzy vectors.
local function approaching_degree(q, w)
  local inner, outer = 0.0, 1.0
  for i = 1, #q do
    local a, b = q[i], w[i]
    if a > b then a, b = b, a end
    if a > inner then inner = a end
    if b < outer then outer = b end
  end
  local complement = 1.0 - outer
  return inner < complement and inner or complement
end

return {
  kind = "similarity",
  name = "tfvadi_lua",
  version = "1.0.0",
  licence = "BSD-3-Clause",
  author = "the preshape developers",
  summary = "Sum of approaching degrees over the components (thesis eq. 3.9.11)",
  capabilities = {
    "rejects_nonfinite", "symmetric", "additive", "monotone", "continuous", "crisp_complement", "permutation_invariant",
    "formula_tfvadi",
  },
  new = function()
    return {
      scale = { farthest = 0, nearest = 6 },
      component = approaching_degree,
    }
  end,
}
