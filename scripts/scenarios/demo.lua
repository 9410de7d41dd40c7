-- Question: which preshape of a four-finger hand lets it pivot a dolphin about the axis between thumb and fingers?
-- The memory starts with the cube alone, so the dolphin is unknown at first: it is explored, learned and served. Run this
-- again, and the dolphin is known.
return preshape.scenario {
  title = "Pivot a dolphin",
  object = "dolphin",
  hand = "utah_mit",
  task = "T1_5",    -- translate along Z and X, rotate about X (preshape tasks)
  memory = "demo",
  seed = 1,
}
