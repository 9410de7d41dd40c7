-- similarity `@NAME@`: fuzzy Jaccard index
--
-- For each of the six components, with the fuzzy vectors q of the task and w of the wrench,
--   J(q, w) = sum_i min(q_i, w_i) / sum_i max(q_i, w_i),   1 where both are zero,
-- to the power of `sharpness`, summed. Higher is nearer; a pattern is as near to itself as can be.

return {
  kind = "similarity",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "Sum of fuzzy Jaccard indices over the components",
  capabilities = {
    "rejects_nonfinite", "symmetric", "additive", "reflexive", "separating", "monotone", "crisp_complement",
  },
  parameters = {
    {
      name = "sharpness", type = "number", default = 1, minimum = 0.1, maximum = 10, unit = "1",
      text = "power of the index; above 1 only near patterns count",
    },
  },
  new = function(p)
    return {
      scale = { farthest = 0, nearest = 6 },
      -- q, w: the memberships of one component, a number for each fuzzy set
      component = function(q, w)
        local common, either = 0.0, 0.0
        for i = 1, #q do
          local a, b = q[i], w[i]
          if a > b then
            a, b = b, a
          end
          common, either = common + a, either + b
        end
        return either > 0 and (common / either) ^ p.sharpness or 1.0
      end,
    }
  end,
}
