-- simulator `@NAME@`: fingertips to contacts, by damped least squares
--
-- The hand is put behind the contacts along the approach axis. Then fingertips are brought to their contacts by damped
-- least squares within the joints' limits [Wampler1986], for the open hand to points in front of the contacts, and the
-- hand's base by the mean of what is left, in turns. No mass, no force, no friction, no collision.

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

--- Solves A x = b for three columns A, by Cramer's rule.
local function solve(A, b)
  local det = dot(A[1], cross(A[2], A[3]))
  return { dot(b, cross(A[2], A[3])) / det, dot(A[1], cross(b, A[3])) / det, dot(A[1], cross(A[2], b)) / det }
end

return {
  kind = "simulator",
  name = "@NAME@",
  version = "0.1.0",
  licence = "BSD-3-Clause",
  author = "the @NAME@ authors",
  summary = "Reaches the contacts by damped least squares",
  capabilities = { "rejects_nonfinite" },
  parameters = {
    {
      name = "tolerance", type = "number", default = 5e-4, minimum = 1e-5, maximum = 0.01, unit = "m",
      text = "distance at which a fingertip has reached its contact",
    },
    {
      name = "rounds", type = "integer", default = 40, minimum = 1, maximum = 1000, unit = "rounds",
      text = "most turns of fingers and base",
    },
    {
      name = "damping", type = "number", default = 0.005, minimum = 1e-4, maximum = 1, unit = "m",
      text = "of the least squares, as a length",
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
              reaches[i] = { index = index, finger = finger, target = table.move(task.contacts[i].p, 1, 3, 1, {}) }
              break
            end
          end
          if not reaches[i] then
            local reason = string.format("The hand has no %s left for contact %d.", role, i)
            return { status = "too_few_fingers", reason = reason }
          end
        end
        if #reaches < 2 then
          return { status = "too_few_fingers", reason = "A grasp has at least two contacts." }
        end

        -- The grasp's posture and the open hand's, each with its own reaches.
        local grasp, open = {}, {}
        for j, joint in ipairs(hand.joints) do
          grasp[j] = (joint.lower + joint.upper) / 2
          open[j] = grasp[j]
        end
        for _, reach in ipairs(reaches) do
          reach.posture = grasp
        end
        local function poses(reach)
          local q = {}
          for k = 1, reach.finger.joint_count do
            q[k] = reach.posture[reach.finger.first_joint + k - 1]
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
        --- One step of damped least squares for a finger, cut to its joints' limits.
        local function bend(reach)
          local here, first, J, posture = miss(reach), reach.finger.first_joint, {}, reach.posture
          for k = 1, reach.finger.joint_count do
            local q = posture[first + k - 1]
            posture[first + k - 1] = q + 1e-6
            local there = miss(reach)
            posture[first + k - 1] = q
            J[k] = { (here[1] - there[1]) / 1e-6, (here[2] - there[2]) / 1e-6, (here[3] - there[3]) / 1e-6 }
          end
          local A = { { p.damping ^ 2, 0, 0 }, { 0, p.damping ^ 2, 0 }, { 0, 0, p.damping ^ 2 } }
          for _, column in ipairs(J) do
            for i = 1, 3 do
              for j = 1, 3 do
                A[i][j] = A[i][j] + column[i] * column[j]
              end
            end
          end
          local y = solve(A, here)
          for k, column in ipairs(J) do
            local joint = hand.joints[first + k - 1]
            local q = posture[first + k - 1] + dot(column, y)
            posture[first + k - 1] = math.min(math.max(q, joint.lower), joint.upper)
          end
        end

        --- How far the farthest fingertip of a posture stays from its target.
        local function error_of(posture)
          local largest = 0
          for _, reach in ipairs(reaches) do
            local d = miss(reach)
            largest = math.max(largest, reach.posture == posture and math.sqrt(dot(d, d)) or 0)
          end
          return largest
        end

        local count = #reaches
        for i = 1, count do
          local C = task.contacts[i]
          reaches[count + i] = {
            index = reaches[i].index, finger = reaches[i].finger, posture = open,
            target = { -- n points into the object
              C.p[1] - task.clearance * C.n[1], C.p[2] - task.clearance * C.n[2], C.p[3] - task.clearance * C.n[3],
            },
          }
        end
        for _ = 1, p.rounds do
          for _, reach in ipairs(reaches) do
            bend(reach)
          end
          if math.max(error_of(grasp), error_of(open)) <= p.tolerance then
            break
          end
          for _, reach in ipairs(reaches) do
            local d = miss(reach)
            for k = 1, 3 do
              p_OH[k] = p_OH[k] + d[k] / #reaches
            end
          end
        end
        local error_m, open_error_m = error_of(grasp), error_of(open)

        -- From the open hand to the grasp, all joints evenly, by at most a tenth of a radian a posture.
        local farthest = 0
        for j = 1, #grasp do
          farthest = math.max(farthest, math.abs(grasp[j] - open[j]))
        end
        local steps, path = math.max(1, math.ceil(farthest / 0.1)), {}
        for step = 0, steps do
          path[step + 1] = {}
          for j = 1, #grasp do
            local q = open[j] + (grasp[j] - open[j]) * step / steps
            path[step + 1][j] = math.min(math.max(q, hand.joints[j].lower), hand.joints[j].upper)
          end
        end
        path[steps + 1] = grasp

        local status, reason = "reached", ""
        if error_m > p.tolerance then
          status, reason = "unreachable", string.format("A fingertip stays %.2f mm from its contact.", 1e3 * error_m)
        elseif open_error_m > p.tolerance then
          status, reason = "unreachable", "The hand does not open wide enough in front of the contacts."
        end
        return {
          status = status, reason = reason, X_OH = { R = R, p = p_OH }, path = path, contact_error_m = error_m,
        }
      end,
    }
  end,
}
