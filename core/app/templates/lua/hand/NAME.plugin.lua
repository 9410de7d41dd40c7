-- hand `@NAME@`: a gripper given by its lengths
--
-- A thumb and one to three forefingers of two links each, which close towards each other. Frame H has its origin in the
-- middle of the palm, +Z away from the palm, +Y from the thumb to the forefingers; at q = 0 every finger is stretched
-- along +Z, and a positive q bends it inwards.

local radius = 0.007 -- [m] of the links

--- A capsule along x of the frame of a link; `cut` shortens it at the far end.
local function capsule(finger, link, length, cut)
  return {
    finger = finger, link = link, shape = "capsule", radius = radius, half_length = (length - cut) / 2,
    X_LS = { R = { 0, 0, 1, 1, 0, 0, 0, 1, 0 }, p = { (length - cut) / 2, 0, 0 } },
  }
end

return {
  kind = "hand",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "Gripper of a thumb and one to three forefingers",
  capabilities = { "identical_fingers" },
  parameters = {
    {
      name = "forefingers", type = "integer", default = 2, minimum = 1, maximum = 3, unit = "fingers",
      text = "fingers that oppose the thumb",
    },
    {
      name = "proximal", type = "number", default = 0.06, minimum = 0.02, maximum = 0.5, unit = "m",
      text = "length of the link at the palm",
    },
    {
      name = "distal", type = "number", default = 0.045, minimum = 0.02, maximum = 0.5, unit = "m",
      text = "length of the link with the fingertip",
    },
    {
      name = "half_width", type = "number", default = 0.05, minimum = 0.02, maximum = 0.5, unit = "m",
      text = "finger bases from the middle of the palm",
    },
  },
  new = function(p)
    local spacing, open, bend = 0.03, -0.5, 1.7
    local fingers, solids = {}, {}

    --- @param inward 1 or -1: the way along H's y in which the finger bends
    local function add(name, x, inward)
      fingers[#fingers + 1] = {
        name = name,
        role = name,
        base = { R = { 0, 0, -inward, 0, inward, 0, 1, 0, 0 }, p = { x, -inward * p.half_width, 0 } },
        joints = {
          { name = name .. "_proximal", lower = open, upper = bend },
          -- With `follows = { joint = name .. "_proximal", ratio = 0.7, offset = 0.4 }` the finger has one drive, as with a tendon.
          { name = name .. "_distal", lower = 0, upper = bend, X_PJ = { p = { p.proximal, 0, 0 } } },
        },
        tip = { p = { p.distal, 0, 0 } },
      }
      solids[#solids + 1] = capsule(name, 1, p.proximal, 0)
      solids[#solids + 1] = capsule(name, 2, p.distal, radius)
    end

    add("thumb", 0, 1)
    for i, name in ipairs({ "index", "middle", "ring" }) do
      if i <= p.forefingers then
        add(name, ((p.forefingers + 1) / 2 - i) * spacing, -1)
      end
    end
    -- The palm, just clear of the finger bases.
    solids[#solids + 1] = {
      shape = "box", half_extents = { p.half_width, p.half_width + radius, 0.01 },
      X_LS = { p = { 0, 0, -0.01 - 1.5 * radius } },
    }
    return {
      dimensions = {
        unit_length = 0.03, finger_spacing = spacing, base_width = 2 * p.half_width,
        maximum_opening = p.half_width + (p.proximal + p.distal) * math.sin(-open),
      },
      fingers = fingers,
      solids = solids,
    }
  end,
}
