return {
  mesh = "toy_plane.obj",
  unit = "U",
  frame = "file",
  summary = "Toy plane with propeller, nose towards +X, fin towards +Y",
}
