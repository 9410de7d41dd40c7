-- The BarrettHand: three fingers, eight joints on four drives. Frame, sources and figures: README.md.

-- H in the base's frame P of the published figures: the same directions, origin in the middle of the palm's surface.
local palm_height = 0.079
local function to_H(x, y, z)
  return { x, y, z - palm_height }
end

local quarter = 1.5708  -- a right angle with the digits of the published figures

local function joint(name, position, rotation, lower, upper)
  return { name = name, position = position, rotation = rotation, axis = { 0, 0, 1 }, limits = { lower, upper } }
end

-- The finger's inner and outer link; a worm drive moves both, the outer one a third as much.
local function flexion(name, position, rotation, outer_at)
  local outer = joint(name .. "_outer", outer_at, { 0, 0, 0 }, -0.785, 0)
  outer.follows = { joint = name .. "_inner", ratio = 1 / 3 }
  return joint(name .. "_inner", position, rotation, -2.44, 0), outer
end

-- The fingertip, about 58 mm from the outer joint; the link's capsule ends there.
local tip = { -0.041, 0.041, 0 }

local function links(first)
  return {
    { link = first, from = { -0.008, 0.002, 0.001 }, to = { -0.066, 0.003, 0.001 }, radius = 0.0105 },
    { link = first + 1, from = { 0, 0, 0 }, to = { -0.0346, 0.0346, 0 }, radius = 0.009 },
  }
end

-- A finger that is spread about the palm, from the side of the other two's line; +x one leads, the other mirrors it.
local function spread_finger(name, x, lower, upper, outer_at, follows)
  local spread = joint(name .. "_spread", { 0, 0, 0 }, { 0, 0, -quarter }, lower, upper)
  spread.follows = follows
  local inner, outer = flexion(name, { -0.05, 0, 0.0339 }, { quarter, 0, 0 }, outer_at)
  local solids = links(2)
  table.insert(solids, 1, { link = 1, shape = "box", centre = { -0.029, 0, 0.012 }, half_extents = { 0.035, 0.012, 0.013 } })
  return {
    name = name,
    role = name,
    base = { position = to_H(x, 0, 0.0415) },
    joints = { spread, inner, outer },
    tip = tip,
    links = solids,
  }
end

local function thumb()
  local inner, outer = flexion("thumb", { 0, 0, 0 }, { quarter, 0, quarter }, { -0.069936, 0.003, 0 })
  return {
    name = "thumb",
    role = "thumb",
    base = { position = to_H(0, -0.05, 0.0754) },
    joints = { inner, outer },
    tip = tip,
    links = links(1),
  }
end

local function box(centre, half_extents)
  return { shape = "box", centre = to_H(table.unpack(centre)), half_extents = half_extents }
end

return {
  model = "dh",
  summary = "BarrettHand: three fingers, eight joints on four drives",
  unit_length = 0.035,
  finger_spacing = 0.05,
  maximum_opening = 0.11,
  base_width = 0.1,
  palm = {
    box({ 0, -0.011, 0.054 }, { 0.013, 0.054, 0.013 }),
    box({ 0, 0, 0.072 }, { 0.038, 0.023, 0.007 }),
    box({ 0, 0, 0.021 }, { 0.04, 0.04, 0.021 }),
  },
  fingers = {
    thumb(),
    spread_finger("index", 0.025, -3.14, 0, { -0.069936, 0.003, 0 }),
    spread_finger("middle", -0.025, 0, 3.14, { -0.069917, 0.0034087, 0 }, { joint = "index_spread", ratio = -1 }),
  },
}
