-- From the tower, so that the wrist is every finger's first joint.
return {
  model = "urdf",
  file = "orca_hand_right/orcahand_right.urdf",
  base = { link = "right_tower", position = { 0.04, 0.02, 0.16 }, rotation = { math.rad(90), 0, math.rad(180) } },
  unit_length = 0.046, finger_spacing = 0.022, maximum_opening = 0.08, base_width = 0.09,
  fingers = {
    { name = "thumb", role = "thumb", tip = { link = "right_thumb_fingertip" } },
    { name = "index", role = "index", tip = { link = "right_index_fingertip" } },
    { name = "middle", role = "middle", tip = { link = "right_middle_fingertip" } },
    { name = "ring", role = "ring", tip = { link = "right_ring_fingertip" } },
    { name = "pinky", role = "little", tip = { link = "right_pinky_fingertip" } },
  },
}
