-- The Allegro hand, right: four fingers of four joints. Frame, sources and figures: README.md.

-- H in the palm's frame P (x out of the palm, z along the stretched fingers): origin on the palm's surface, +Z leaning
-- by `lean` from the palm's normal towards the fingers.
local lean = math.rad(10)
local origin = { 0.0117, 0, -0.04 }
local palm_in_H = { 0, lean - math.rad(90), math.rad(-90) }
local c, s = math.cos(lean), math.sin(lean)
local function to_H(x, y, z)
  x, y, z = x - origin[1], y - origin[2], z - origin[3]
  return { y, c * z - s * x, c * x + s * z }
end

local radius = 0.0115  -- of a link: a box of 19.6 mm x 27.5 mm

local function capsule(link, length)
  return { link = link, from = { 0, 0, 0 }, to = { 0, 0, length }, radius = radius }
end

-- The tip is the foremost point of a ball of 12 mm.
local function fingertip(link, length)
  return { link = link, from = { 0, 0, 0 }, to = { 0, 0, length - 0.012 }, radius = 0.012 }
end

local function joint(name, position, axis, lower, upper, rotation)
  return { name = name, position = position, rotation = rotation, axis = axis, limits = { lower, upper } }
end

-- A forefinger whose abduction axis stands at (0, y, z) in P and leans by `roll` about x.
local function forefinger(name, y, z, roll)
  return {
    name = name,
    role = name,
    base = { position = to_H(0, y, z), rotation = palm_in_H },
    joints = {
      joint(name .. "_abduction", { 0, 0, 0 }, { 0, 0, 1 }, -0.47, 0.47, { roll, 0, 0 }),
      joint(name .. "_proximal", { 0, 0, 0.0164 }, { 0, 1, 0 }, -0.196, 1.61),
      joint(name .. "_middle", { 0, 0, 0.054 }, { 0, 1, 0 }, -0.174, 1.709),
      joint(name .. "_distal", { 0, 0, 0.0384 }, { 0, 1, 0 }, -0.227, 1.618),
    },
    tip = { 0, 0, 0.0387 },
    links = { capsule(1, 0.0164), capsule(2, 0.054), capsule(3, 0.0384), fingertip(4, 0.0387) },
  }
end

local thumb = {
  name = "thumb",
  role = "thumb",
  base = { position = to_H(-0.0182, 0.019333, -0.045987), rotation = palm_in_H },
  joints = {
    joint("thumb_opposition", { 0, 0, 0 }, { -1, 0, 0 }, 0.263, 1.396, { 0, -1.65806278845, -1.5707963259 }),
    joint("thumb_rotation", { -0.027, 0.005, 0.0399 }, { 0, 0, 1 }, -0.105, 1.163),
    joint("thumb_proximal", { 0, 0, 0.0177 }, { 0, 1, 0 }, -0.189, 1.644),
    joint("thumb_distal", { 0, 0, 0.0514 }, { 0, 1, 0 }, -0.162, 1.719),
  },
  tip = { 0, 0, 0.0543 },
  links = {
    { link = 1, shape = "box", centre = { -0.0179, 0.009, 0.0145 }, half_extents = { 0.0179, 0.017, 0.02275 } },
    capsule(2, 0.0177),
    capsule(3, 0.0514),
    fingertip(4, 0.0543),
  },
}

local function box(centre, half_extents)
  return { shape = "box", centre = to_H(table.unpack(centre)), rotation = palm_in_H, half_extents = half_extents }
end

return {
  model = "dh",
  summary = "Allegro hand, right: four fingers, sixteen joints",
  unit_length = 0.0384,
  finger_spacing = 0.0435,
  maximum_opening = 0.08,
  base_width = 0.112,
  palm = {
    box({ -0.009, 0, -0.023 }, { 0.0207, 0.056, 0.0224 }),
    box({ -0.009, -0.0253, -0.0667 }, { 0.0207, 0.0269, 0.0214 }),
    box({ -0.0093, -0.00557, -0.08874 }, { 0.0207, 0.036, 0.0065 }),
  },
  fingers = {
    thumb,
    forefinger("index", 0.0435, -0.001542, -0.08726646255),
    forefinger("middle", 0, 0.0007, 0),
    forefinger("ring", -0.0435, -0.001542, 0.08726646255),
  },
}
