-- simulator `@NAME@`: fingertips to contacts, by cyclic coordinate descent
--
-- The hand is put behind the contacts along the approach axis. Then, joint by joint, each finger takes the joint value
-- within its limits that brings its tip nearest to its contact, by golden sections, in turns [WangChen1991]. The hand's
-- base follows what is left. No mass, no force, no friction, no collision.

local ratio = (math.sqrt(5) - 1) / 2

local function minus(x, y)
  return { x[1] - y[1], x[2] - y[2], x[3] - y[3] }
end

local function dot(x, y)
  return x[1] * y[1] + x[2] * y[2] + x[3] * y[3]
end

local function cross(x, y)
  return { x[2] * y[3] - x[3] * y[2], x[3] * y[1] - x[1] * y[3], x[1] * y[2] - x[2] * y[1] }
end

local function unit(x)
  local length = math.sqrt(dot(x, x))
  return { x[1] / length, x[2] / length, x[3] / length }
end

--- Axes a, the part of o across it, and their product.
local function axes(a, o)
  local first = unit(a)
  local along = dot(o, first)
  local second = unit({ o[1] - along * first[1], o[2] - along * first[2], o[3] - along * first[3] })
  return { first, second, cross(first, second) }
end

--- The rotation, row by row, that takes the axes `from` to the axes `to`.
local function rotation(from, to)
  local R = {}
  for i = 1, 3 do
    for j = 1, 3 do
      R[3 * (i - 1) + j] = to[1][i] * from[1][j] + to[2][i] * from[2][j] + to[3][i] * from[3][j]
    end
  end
  return R
end

local function rotated(R, x)
  return {
    R[1] * x[1] + R[2] * x[2] + R[3] * x[3],
    R[4] * x[1] + R[5] * x[2] + R[6] * x[3],
    R[7] * x[1] + R[8] * x[2] + R[9] * x[3],
  }
end

--- Where a function of one number is least between two, to within 1e-7.
local function least(f, low, high)
  local left, right = high - ratio * (high - low), low + ratio * (high - low)
  local at_left, at_right = f(left), f(right)
  while high - low > 1e-7 do
    if at_left < at_right then
      high, right, at_right = right, left, at_left
      left = high - ratio * (high - low)
      at_left = f(left)
    else
      low, left, at_left = left, right, at_right
      right = low + ratio * (high - low)
      at_right = f(right)
    end
  end
  return (low + high) / 2
end

return {
  kind = "simulator",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "Reaches the contacts joint by joint",
  capabilities = { "rejects_nonfinite" },
  parameters = {
    {
      name = "tolerance", type = "number", default = 5e-4, minimum = 1e-5, maximum = 0.01, unit = "m",
      text = "distance at which a fingertip has reached its contact",
    },
    {
      name = "rounds", type = "integer", default = 20, minimum = 1, maximum = 1000, unit = "rounds",
      text = "most turns of fingers and base",
    },
  },
  new = function(p)
    return {
      simulate = function(task)
        local hand, reaches, taken = task.hand, {}, {}
        for i, role in ipairs(task.fingers) do
          for index, finger in ipairs(hand.fingers) do
            if finger.role == role and not taken[index] then
              taken[index] = true
              reaches[i] = { index = index, finger = finger, target = task.contacts[i].p }
              break
            end
          end
          if not reaches[i] then
            return { status = "too_few_fingers", reason = "the hand has no " .. role .. " left for contact " .. i .. "." }
          end
        end
        if #reaches < 2 then
          return { status = "too_few_fingers", reason = "A grasp has at least two contacts." }
        end

        local posture, open = {}, {}
        for j, joint in ipairs(hand.joints) do
          posture[j] = (joint.lower + joint.upper) / 2
          open[j] = joint.lower
        end
        local function poses(reach)
          local q = {}
          for k = 1, reach.finger.joint_count do
            q[k] = posture[reach.finger.first_joint + k - 1]
          end
          return task.forward(reach.index, q)
        end

        -- The hand's own axes: from the forefingers' bases to the thumb's, and from bases to tips.
        local push, ahead, middle, centre = { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }
        for i, reach in ipairs(reaches) do
          local X = poses(reach)
          local base, tip = X[1].p, X[#X].p
          for k = 1, 3 do
            push[k] = push[k] + (i == 1 and base[k] or -base[k] / (#reaches - 1))
            ahead[k] = ahead[k] + tip[k] - base[k]
            middle[k] = middle[k] + tip[k] / #reaches
            centre[k] = centre[k] + reach.target[k] / #reaches
          end
        end
        local own = axes(push, ahead)
        local R = rotation({ own[2], own[1], cross(own[2], own[1]) }, axes(task.approach, task.opposition))
        local p_OH = minus(centre, rotated(R, middle))

        local function miss(reach)
          local X = poses(reach)
          local tip = rotated(R, X[#X].p)
          return minus(reach.target, { p_OH[1] + tip[1], p_OH[2] + tip[2], p_OH[3] + tip[3] })
        end
        local error_m = math.huge
        for _ = 1, p.rounds do
          for _, reach in ipairs(reaches) do
            for j = reach.finger.first_joint, reach.finger.first_joint + reach.finger.joint_count - 1 do
              posture[j] = least(function(q)
                posture[j] = q
                local d = miss(reach)
                return dot(d, d)
              end, hand.joints[j].lower, hand.joints[j].upper)
            end
          end
          error_m = 0
          local shift = { 0, 0, 0 }
          for _, reach in ipairs(reaches) do
            local d = miss(reach)
            error_m = math.max(error_m, math.sqrt(dot(d, d)))
            for k = 1, 3 do
              shift[k] = shift[k] + d[k] / #reaches
            end
          end
          if error_m <= p.tolerance then
            break
          end
          for k = 1, 3 do
            p_OH[k] = p_OH[k] + shift[k]
          end
        end

        local reached = error_m <= p.tolerance
        return {
          status = reached and "reached" or "unreachable",
          reason = reached and "" or string.format("A fingertip stays %.2f mm from its contact.", 1e3 * error_m),
          X_OH = { R = R, p = p_OH },
          path = { open, posture },
          contact_error_m = error_m,
        }
      end,
    }
  end,
}
