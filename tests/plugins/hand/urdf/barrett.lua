-- The frame H, the tips and the sizes are those of hands/barrett.
local tip = { -0.041, 0.041, 0 }
return {
  model = "urdf",
  file = "barrett_hand/bhand_model.urdf",
  base = { link = "base_link", position = { 0, 0, 0.079 } },
  unit_length = 0.035, finger_spacing = 0.05, maximum_opening = 0.11, base_width = 0.1,
  fingers = {
    { name = "thumb", role = "thumb", tip = { link = "finger_3_dist_link", position = tip } },
    { name = "index", role = "index", tip = { link = "finger_1_dist_link", position = tip } },
    { name = "middle", role = "middle", tip = { link = "finger_2_dist_link", position = tip } },
  },
}
