-- The Shadow dexterous hand, right, its wrist at rest: five fingers, 22 joints, four of them coupled. Frame, sources and
-- figures: README.md.

-- H in the palm's frame P (-y out of the palm, z along the stretched fingers): origin on the palm's surface, +Z leaning
-- by `lean` from the palm's normal towards the fingers.
local lean = math.rad(30)
local origin = { 0, -0.012, 0.045 }
local palm_in_H = { lean - math.rad(90), 0, 0 }
local c, s = math.cos(lean), math.sin(lean)
local function to_H(x, y, z)
  x, y, z = x - origin[1], y - origin[2], z - origin[3]
  return { x, c * z + s * y, s * z - c * y }
end

local function joint(name, position, axis, lower, upper, torque)
  return { name = name, position = position, axis = axis, limits = { lower, upper }, torque_limit = torque or 1 }
end

local function capsule(link, from, to, radius)
  return { link = link, from = { 0, 0, from }, to = { 0, 0, to }, radius = radius or 0.009 }
end

-- The joints J4 .. J1 of a forefinger, the knuckle at `position` in the frame before; its tendon draws J1 as much as J2.
local function flexion(name, position, side)
  local distal = joint(name .. "_J1", { 0, 0, 0.025 }, { 1, 0, 0 }, 0, 1.5708)
  distal.follows = { joint = name .. "_J2", ratio = 1 }
  return {
    joint(name .. "_J4", position, { 0, side, 0 }, -0.349066, 0.349066),
    joint(name .. "_J3", { 0, 0, 0 }, { 1, 0, 0 }, -0.261799, 1.5708),
    joint(name .. "_J2", { 0, 0, 0.045 }, { 1, 0, 0 }, 0, 1.5708),
    distal,
  }
end

local function phalanges(first)
  return { capsule(first, 0.005, 0.045), capsule(first + 1, 0, 0.025), capsule(first + 2, 0, 0.018, 0.008) }
end

local function forefinger(name, x, z, side)
  return {
    name = name,
    role = name,
    base = { position = to_H(x, 0, z), rotation = palm_in_H },
    joints = flexion(name, { 0, 0, 0 }, side),
    tip = { 0, 0, 0.026 },
    links = phalanges(2),
  }
end

-- The little finger's metacarpal turns in the palm.
local function little_finger()
  local joints = flexion("little", { 0, 0, 0.06579 }, 1)
  table.insert(joints, 1, joint("little_J5", { 0, 0, 0 }, { 0.573576, 0, 0.819152 }, 0, 0.785398))
  local links = phalanges(3)
  table.insert(links, 1, { link = 1, shape = "box", centre = { 0.002, 0, 0.033 }, half_extents = { 0.011, 0.012, 0.025 } })
  return {
    name = "little",
    role = "little",
    base = { position = to_H(-0.033, 0, 0.02071), rotation = palm_in_H },
    joints = joints,
    tip = { 0, 0, 0.026 },
    links = links,
  }
end

local base = joint("thumb_J5", { 0, 0, 0 }, { 0, 0, -1 }, -1.0472, 1.0472, 3)
base.rotation = { 0, 2 * math.atan(0.382683, 0.92388), 0 }
local distal = joint("thumb_J1", { 0, 0, 0.032 }, { 1, 0, 0 }, -0.261799, 1.5708)
distal.rotation = { 0, 0, math.rad(-90) }

local thumb = {
  name = "thumb",
  role = "thumb",
  base = { position = to_H(0.034, -0.00858, 0.029), rotation = palm_in_H },
  joints = {
    base,
    joint("thumb_J4", { 0, 0, 0 }, { 1, 0, 0 }, 0, 1.22173, 2),
    joint("thumb_J3", { 0, 0, 0.038 }, { 1, 0, 0 }, -0.20944, 0.20944),
    joint("thumb_J2", { 0, 0, 0 }, { 0, -1, 0 }, -0.698132, 0.698132),
    distal,
  },
  tip = { 0, 0, 0.0275 },
  links = {
    { link = 1, shape = "sphere", centre = { 0, 0, 0 }, radius = 0.013 },
    capsule(2, 0.011, 0.029, 0.0105),
    { link = 3, shape = "sphere", centre = { 0, 0, 0 }, radius = 0.011 },
    capsule(4, 0.003, 0.03, 0.0095),
    capsule(5, 0, 0.0185, 0.009),
  },
}

local function box(centre, half_extents)
  return { shape = "box", centre = to_H(table.unpack(centre)), rotation = palm_in_H, half_extents = half_extents }
end

return {
  model = "dh",
  summary = "Shadow dexterous hand, right: five fingers, 22 joints, four of them coupled",
  unit_length = 0.025,
  finger_spacing = 0.022,
  maximum_opening = 0.07,
  base_width = 0.084,
  palm = {
    box({ 0.011, 0.0085, 0.038 }, { 0.031, 0.0035, 0.049 }),
    box({ -0.002, -0.0035, 0.038 }, { 0.018, 0.0085, 0.049 }),
    box({ 0.029, -0.0035, 0.082 }, { 0.013, 0.0085, 0.005 }),
    box({ 0.0315, -0.0085, 0.001 }, { 0.0105, 0.0135, 0.012 }),
    box({ 0.011, 0, 0.089 }, { 0.009, 0.012, 0.002 }),
    box({ -0.03, 0, 0.009 }, { 0.01, 0.012, 0.02 }),
  },
  fingers = {
    thumb,
    forefinger("index", 0.033, 0.095, -1),
    forefinger("middle", 0.011, 0.099, -1),
    forefinger("ring", -0.011, 0.095, 1),
    little_finger(),
  },
}
