-- Question: what does the best preshape of each shipped object look like, and for which task is it?
--
-- For each object the task of the task space whose best grasp, found by an exhaustive search, comes nearest to it. Prints the
-- page of the gallery; the pictures are drawn by the build, which reads the objects, tasks and scores from the page:
--
--   ninja -C build/release preshape_gallery
local page = {}

print("# Gallery\n")
print("Made by `ninja preshape_gallery`: each shipped object with its best preshape, that is the grasp of the task of the task space")
print("that an exhaustive search brings nearest (TFVADI, 6 at most), carried out by the hand `utah_mit` in the simulator `kinematic`.")
print("Where the hand cannot carry it out, the line under the title says why, and the hand is drawn as far as it came.")
print("What the colours mean stands below each picture; arrows of contacts are in one scale, the resultant's in its own.\n")
print("| object | task | TFVADI | picture |")
print("|---|---|---|---|")
for _, object in ipairs(preshape.objects()) do
  local best = { first = -1 }
  for _, task in ipairs(preshape.tasks()) do
    local found = preshape.best({ object = object, task = task.name, explorer = "exhaustive", memory = ":memory:", seed = 1 })
    if found and found.first > best.first then
      best = { first = found.first, task = task.name }
    end
  end
  if best.task then
    print(string.format("| %s | %s | %.2f | ![%s held for %s](gallery/%s.png) |", object, best.task, best.first, object, best.task, object))
    page[#page + 1] = { object = object, task = best.task, score = best.first }
  end
end
return page
