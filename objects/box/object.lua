return {
  mesh = "box.obj",
  unit = "U",
  frame = "file",
  summary = "Box of 1.05U x 4.1U x 2.03U, tall and narrow",
}
