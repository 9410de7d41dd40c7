--- Triangle mesh held in memory, and the operations all generators share.
--
-- A mesh is a table of three lists:
--   vertices   { x, y, z }            position, unit U
--   normals    { x, y, z }            unit length
--   triangles  { a, b, c, na, nb, nc } indices into vertices and normals,
--                                     counter-clockwise seen from outside

local mesh = {}

--- Text of a number as the OBJ file has it: six decimals, no minus zero.
function mesh.number(value)
  local text = string.format("%.6f", value)
  if text == "-0.000000" then
    text = "0.000000"
  end
  return text
end

local function key_of(x, y, z)
  return mesh.number(x) .. " " .. mesh.number(y) .. " " .. mesh.number(z)
end

--- Builder which holds equal positions and equal normals once each.
-- Two are equal when the file would write them with the same digits.
function mesh.builder()
  local result = { vertices = {}, normals = {}, triangles = {} }
  local vertex_index, normal_index = {}, {}
  local builder = { mesh = result }

  local function intern(list, index, x, y, z)
    local key = key_of(x, y, z)
    local found = index[key]
    if not found then
      found = #list + 1
      list[found] = { x, y, z }
      index[key] = found
    end
    return found
  end

  --- Index of the position (x, y, z), unit U.
  function builder.vertex(x, y, z)
    return intern(result.vertices, vertex_index, x, y, z)
  end

  --- Index of the normal along (x, y, z); any length but zero.
  function builder.normal(x, y, z)
    local length = math.sqrt(x * x + y * y + z * z)
    return intern(result.normals, normal_index, x / length, y / length, z / length)
  end

  --- Adds a triangle unless two of its corners coincide.
  function builder.triangle(a, b, c, na, nb, nc)
    if a ~= b and b ~= c and c ~= a then
      result.triangles[#result.triangles + 1] = { a, b, c, na, nb, nc }
    end
  end

  return builder
end

--- Smallest and largest corner of the bounding box, unit U.
function mesh.bounds(self)
  local low = { math.huge, math.huge, math.huge }
  local high = { -math.huge, -math.huge, -math.huge }
  for _, vertex in ipairs(self.vertices) do
    for axis = 1, 3 do
      low[axis] = math.min(low[axis], vertex[axis])
      high[axis] = math.max(high[axis], vertex[axis])
    end
  end
  return low, high
end

--- Extents of the bounding box as { x, y, z }, unit U.
function mesh.extents(self)
  local low, high = mesh.bounds(self)
  return { high[1] - low[1], high[2] - low[2], high[3] - low[3] }
end

--- Moves the centre of the bounding box to the origin and stretches each axis
-- to the given extents, unit U, by two per cent at most: sampled surfaces miss
-- their outermost points by a little.
function mesh.fit(self, width, height, depth)
  local low, high = mesh.bounds(self)
  local wanted = { width, height, depth }
  local factor, centre = {}, {}
  for axis = 1, 3 do
    factor[axis] = wanted[axis] / (high[axis] - low[axis])
    centre[axis] = (high[axis] + low[axis]) / 2
    if math.abs(factor[axis] - 1) > 0.02 then
      local extent = high[axis] - low[axis]
      error(string.format("fit: axis %d measures %.4f U about %.4f U", axis, extent, centre[axis]))
    end
  end
  for _, vertex in ipairs(self.vertices) do
    for axis = 1, 3 do
      vertex[axis] = (vertex[axis] - centre[axis]) * factor[axis]
    end
  end
  for _, normal in ipairs(self.normals) do
    local x, y, z = normal[1] / factor[1], normal[2] / factor[2], normal[3] / factor[3]
    local length = math.sqrt(x * x + y * y + z * z)
    normal[1], normal[2], normal[3] = x / length, y / length, z / length
  end
  return self
end

return mesh
