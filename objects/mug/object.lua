return {
  mesh = "mug.obj",
  unit = "U",
  frame = "file",
  summary = "Mug with a handle towards +X and a hollow bowl open towards +Y",
}
