-- classifier `@NAME@`: nearest neighbour
--
-- A pattern has the bits of the learned row that is nearest to it, of equally near ones the first that was learned
-- [CoverHart1967]. With `scaled` the difference in each feature is taken over the feature's range.

--- One over the range of each feature among the rows; 1 where they do not differ.
local function weights_of(rows)
  local weights = {}
  for k = 1, #rows[1] do
    local least, most = math.huge, -math.huge
    for i = 1, #rows do
      least, most = math.min(least, rows[i][k]), math.max(most, rows[i][k])
    end
    local weight = 1 / (most - least)
    weights[k] = weight > 0 and weight < math.huge and weight or 1
  end
  return weights
end

return {
  kind = "classifier",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "The bits of the nearest learned row",
  capabilities = { "rejects_nonfinite", "nonlinear", "interpolating", "seedless" },
  parameters = {
    { name = "scaled", type = "boolean", default = true, text = "take differences over each feature's range" },
  },
  new = function(p)
    return {
      -- What fit returns is the model: plain data, which preshape saves and loads.
      fit = function(inputs, targets)
        local weights
        if p.scaled then
          weights = weights_of(inputs)
        end
        return { inputs = inputs, targets = targets, weights = weights }
      end,
      predict = function(model, row)
        local best, least = 1, math.huge
        for i, known in ipairs(model.inputs) do
          local squares = 0
          for k = 1, #row do
            local d = (known[k] - row[k]) * (model.weights and model.weights[k] or 1)
            squares = squares + d * d
          end
          if squares < least then
            best, least = i, squares
          end
        end
        return model.targets[best]
      end,
    }
  end,
}
