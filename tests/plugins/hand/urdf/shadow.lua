-- A MuJoCo model: refused with that reason.
return {
  model = "urdf",
  file = "shadow_hand_right/right_hand.xml",
  base = { link = "rh_palm" },
  unit_length = 0.025, finger_spacing = 0.022, maximum_opening = 0.08, base_width = 0.084,
  fingers = { { name = "thumb", role = "thumb", tip = { link = "rh_thdistal" } } },
}
