return {
  mesh = "bottle.obj",
  unit = "U",
  frame = "file",
  summary = "Bottle with waist, neck and cap, 6U tall along Y",
}
