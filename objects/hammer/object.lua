return {
  mesh = "hammer.obj",
  unit = "U",
  frame = "file",
  summary = "Claw hammer, handle along X, head across at +X",
}
