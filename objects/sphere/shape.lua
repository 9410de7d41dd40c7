--- Ball of diameter 2.4 U.

local icosphere = require("shapes.icosphere")

local shape = {}

function shape.build()
  return icosphere(1.2, 2)
end

return shape
