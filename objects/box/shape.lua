--- Box, tall and narrow.

local box = require("shapes.box")

local shape = {}

function shape.build()
  return box(1.05, 4.1, 2.03)
end

return shape
