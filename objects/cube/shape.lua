--- Cube of side 2 U.

local box = require("shapes.box")

local shape = {}

function shape.build()
  return box(2, 2, 2)
end

return shape
