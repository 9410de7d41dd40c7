--- Wavefront OBJ text of a mesh, and back.

local mesh = require("shapes.mesh")

local obj = {}

--- Text of the mesh. Every distinct normal is written once.
function obj.format(name, self)
  local lines = {
    "# " .. name .. ", lengths in U (middle phalanx of the middle finger)",
    "# regenerate: lua5.4 objects/generate.lua " .. name,
    "o " .. name,
  }
  local function add(tag, triple)
    local text = mesh.number(triple[1]) .. " " .. mesh.number(triple[2]) .. " " .. mesh.number(triple[3])
    lines[#lines + 1] = tag .. " " .. text
    return text
  end
  for _, vertex in ipairs(self.vertices) do
    add("v", vertex)
  end
  local place, written, count = {}, {}, 0
  for index, normal in ipairs(self.normals) do
    local text = mesh.number(normal[1]) .. " " .. mesh.number(normal[2]) .. " " .. mesh.number(normal[3])
    if not written[text] then
      count = count + 1
      written[text] = count
      lines[#lines + 1] = "vn " .. text
    end
    place[index] = written[text]
  end
  for _, t in ipairs(self.triangles) do
    lines[#lines + 1] = string.format("f %d//%d %d//%d %d//%d",
      t[1], place[t[4]], t[2], place[t[5]], t[3], place[t[6]])
  end
  lines[#lines + 1] = ""
  return table.concat(lines, "\n")
end

--- Mesh in the text; reads what obj.format writes, nothing more.
function obj.parse(text)
  local result = { vertices = {}, normals = {}, triangles = {} }
  for line in text:gmatch("[^\n]+") do
    local tag, rest = line:match("^(%S+)%s+(.*)$")
    if tag == "v" or tag == "vn" then
      local x, y, z = rest:match("^(%S+) (%S+) (%S+)$")
      local list = tag == "v" and result.vertices or result.normals
      list[#list + 1] = { tonumber(x), tonumber(y), tonumber(z) }
    elseif tag == "f" then
      local a, na, b, nb, c, nc = rest:match("^(%d+)//(%d+) (%d+)//(%d+) (%d+)//(%d+)$")
      assert(a, "obj: not a triangle: " .. line)
      local t = { a, b, c, na, nb, nc }
      for i = 1, 6 do
        t[i] = math.tointeger(tonumber(t[i]))
      end
      result.triangles[#result.triangles + 1] = t
    end
  end
  return result
end

return obj
