-- Question: which preshape of a four-finger hand lets it pivot a mug about the axis between thumb and fingers?
-- The memory starts with the cube alone, so the mug is unknown at first: it is explored, learned, and served. Run it
-- again and the mug is known.
return preshape.scenario {
  title = "Pivot a mug",
  object = "mug",
  hand = "utah_mit",
  task = "T1_2",        -- translate along X and Y, rotate about Y (preshape tasks)
  memory = "demo",
  seed = 1,
}
