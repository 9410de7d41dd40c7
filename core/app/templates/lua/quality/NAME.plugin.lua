-- quality `@NAME@`: how evenly the contacts stand around the object
--
-- One minus the length of the mean of the contacts' inward unit normals: 1 when they cancel, as two fingers that oppose
-- each other do, 0 when all point the same way.

return {
  kind = "quality",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "How far the contact normals cancel",
  capabilities = { "rejects_nonfinite", "frame_invariant", "permutation_invariant", "force_scale_invariant" },
  parameters = {
    {
      name = "power", type = "number", default = 1, minimum = 0.1, maximum = 10, unit = "1",
      text = "of the mean normal's length",
    },
  },
  new = function(p)
    return {
      numbers = { { name = "opposition", unit = "1", lowest = 0, highest = 1 } },
      -- grasp.contacts: p, n, a, t; grasp.wrench_union: a wrench a row
      evaluate = function(grasp)
        local x, y, z = 0, 0, 0
        for _, C in ipairs(grasp.contacts) do
          x, y, z = x + C.n[1], y + C.n[2], z + C.n[3]
        end
        local length = math.sqrt(x * x + y * y + z * z) / math.max(1, #grasp.contacts)
        return math.max(0, 1 - length ^ p.power)
      end,
    }
  end,
}
