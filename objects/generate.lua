--- Regenerates the shipped objects, or checks them.
--
--   lua5.4 objects/generate.lua [--check] [NAME...]
--
-- Writes <name>/<name>.obj for every NAME (all without one). With --check
-- nothing is written: the mesh is built in memory and has to equal the file
-- byte for byte, to bound one solid (closed, wound outwards, one piece) and to
-- have the extents and counts its README states. Prints a line per object;
-- exits 1 if one of them fails.

local here = arg[0]:match("^(.*)/[^/]*$") or "."
package.path = here .. "/?.lua;" .. package.path

local inspect = require("shapes.inspect")
local mesh = require("shapes.mesh")
local obj = require("shapes.obj")

local all = {
  "cube", "box", "sphere", "cylinder", "disc", "cone", "torus",
  "mug", "bottle", "dolphin", "toy_car", "toy_plane", "hammer",
}

local function read(path)
  local file = io.open(path, "rb")
  if not file then
    return nil
  end
  local text = file:read("a")
  file:close()
  return text
end

--- Extents and counts as the README states them.
local function facts_of(self)
  local extents = mesh.extents(self)
  for axis = 1, 3 do
    extents[axis] = string.format("%.4f", extents[axis]):gsub("%.?0+$", "")
  end
  return string.format("%s x %s x %s U, %d vertices, %d normals, %d triangles",
    extents[1], extents[2], extents[3], #self.vertices, #self.normals, #self.triangles)
end

--- Builds one object; returns its line and whether all is well.
local function process(name, check)
  local shape = dofile(here .. "/" .. name .. "/shape.lua")
  local text = obj.format(name, shape.build())
  local path = here .. "/" .. name .. "/" .. name .. ".obj"

  -- What counts is what a reader of the file gets.
  local result = obj.parse(text)
  local found = inspect.solid(result)
  local facts = facts_of(result)
  local faults = found.faults
  if check then
    if read(path) ~= text then
      table.insert(faults, 1, name .. ".obj differs")
    end
    local readme = read(here .. "/" .. name .. "/README.md") or ""
    if not readme:find(facts, 1, true) then
      table.insert(faults, "README.md does not state the extents and counts")
    end
  else
    local file = assert(io.open(path, "wb"))
    file:write(text)
    file:close()
  end
  local verdict = string.format("closed, one piece, genus %d, volume %.4f U^3", found.genus, found.volume)
  if #faults > 0 then
    verdict = "FAULTY: " .. table.concat(faults, "; ", 1, math.min(#faults, 5))
  end
  return string.format("%-10s %s; %s", name, facts, verdict), #faults == 0
end

local check, names = false, {}
for _, word in ipairs(arg) do
  if word == "--check" then
    check = true
  else
    local known = false
    for _, name in ipairs(all) do
      known = known or name == word
    end
    if not known then
      io.stderr:write("usage: generate.lua [--check] [NAME...]\nnames: ", table.concat(all, " "), "\n")
      os.exit(2)
    end
    names[#names + 1] = word
  end
end

local well = true
for _, name in ipairs(#names > 0 and names or all) do
  local line, fine = process(name, check)
  print(line)
  well = well and fine
end
os.exit(well and 0 or 1)
