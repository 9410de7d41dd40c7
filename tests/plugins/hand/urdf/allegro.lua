-- The frame H and the sizes are those of hands/allegro.
local lean = math.rad(10)
return {
  model = "urdf",
  file = "allegro_hand_right/allegro_hand_right.urdf",
  base = { link = "base_link", position = { 0.0117, 0, -0.04 }, rotation = { math.rad(90) - lean, 0, math.rad(90) } },
  unit_length = 0.0384, finger_spacing = 0.0435, maximum_opening = 0.08, base_width = 0.112,
  fingers = {
    { name = "thumb", role = "thumb", tip = { link = "link_15.0_tip" } },
    { name = "index", role = "index", tip = { link = "link_3.0_tip" } },
    { name = "middle", role = "middle", tip = { link = "link_7.0_tip" } },
    { name = "ring", role = "ring", tip = { link = "link_11.0_tip" } },
  },
}
