return {
  mesh = "dolphin.obj",
  unit = "U",
  frame = "file",
  summary = "Dolphin in a leap, snout towards +X, back towards +Y",
}
