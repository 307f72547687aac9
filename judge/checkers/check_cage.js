#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Checks coordinates of a whole cage against vectors of `cageproof vectors --kinds`; node and check.js beside this file are enough.
//
// usage: node check_cage.js VECTORS.json [BOUND]
// Replace `coordinates`, KIND and QUADS. Exit 0: all vectors within BOUND units (64); 1: not all; 2: the file cannot be read.
'use strict'
const fs = require('fs')
const path = require('path')
const { decimal, exactDifferences, hexadecimal, ratio, units } = require(path.join(__dirname, 'check.js'))

const KIND = 'mean_value' // the kind of your function
const QUADS = false // whether its cages have quads

// Yours. Here: mean value coordinates, one per vertex, in space of triangles and in the plane of segments. Takes lists of numbers, and of indices. Returns
// one list of numbers, block by block.
function coordinates(vertices, faces, point) {
  // Exact differences, as whole numbers: in doubles they cancel next to a cage.
  const { vectors } = exactDifferences(vertices, point)
  let weights = vertices.map(() => 0)
  for (const face of faces) {
    const [found, on] = (face.length === 2 ? ofSegment : ofTriangle)(face.map((i) => vectors[i]))
    if (on) weights = vertices.map(() => 0)
    face.forEach((i, k) => (weights[i] += found[k]))
    if (on) break
  }
  const total = weights.reduce((s, w) => s + w, 0)
  return weights.map((w) => w / total)
}

const dot = (u, v) => u.slice(1).reduce((s, x, i) => s + x * v[i + 1], u[0] * v[0])
const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
const minus = (u, v) => u.map((x, i) => x - v[i])

// The weights of the corners, and whether the point is on the triangle. All have the factor that takes the unit away.
function ofTriangle(d) {
  const sides = [0, 1, 2].map((k) => minus(d[(k + 2) % 3], d[(k + 1) % 3]))
  const normals = [0, 1, 2].map((k) => cross(d[(k + 1) % 3], sides[k]))
  const det = dot(d[0], normals[0])
  if (det === 0n) {
    const across = cross(sides[1], sides[2])
    const areas = normals.map((n) => dot(n, across))
    const all = areas.reduce((s, a) => s + a)
    return areas.every((a) => a >= 0n) ? [areas.map((a) => ratio(a, all)), true] : [[0, 0, 0], false]
  }
  const real = normals.map((n) => n.map((x) => ratio(x, UNIT ** 2n)))
  const mean = [0, 0, 0]
  real.forEach((n, k) => {
    const length = Math.hypot(...n)
    const angle = Math.atan2(length, ratio(dot(d[(k + 1) % 3], d[(k + 2) % 3]), UNIT ** 2n))
    n.forEach((x, i) => (mean[i] += (angle * x) / length))
  })
  const volume = ratio(det, UNIT ** 3n)
  return [real.map((n) => dot(n, mean) / volume), false]
}
const UNIT = 1n << 40n // keeps quotients of long whole numbers in range; any would do

// The same of a segment: tangents of half the angle that it is seen under, over distances.
function ofSegment(d) {
  const area = d[0][0] * d[1][1] - d[0][1] * d[1][0]
  const inner = dot(d[0], d[1])
  const lengths = d.map((x) => Math.hypot(...x.map((t) => ratio(t, UNIT))))
  const sum = lengths[0] + lengths[1]
  if (area === 0n) return inner <= 0n ? [[lengths[1] / sum, lengths[0] / sum], true] : [[0, 0], false]
  const [a, b, product] = [ratio(area, UNIT ** 2n), ratio(inner, UNIT ** 2n), lengths[0] * lengths[1]]
  const tangent = b < 0 ? (product - b) / a : a / (product + b)
  return [lengths.map((length) => tangent / length), false]
}

// The largest error of a block; infinite where the function fails.
function worstError(data, vector, unit) {
  const vertices = data.vertices.map((v) => v.map(hexadecimal))
  const [point, truth] = [vector.point.map(hexadecimal), vector.value.map(decimal)]
  const denominators = vector.denominators.map(decimal)
  let found
  try {
    found = coordinates(vertices, data.faces, point)
  } catch {
    return Infinity // yours: whatever it throws, it has no answer
  }
  if (found.length !== truth.length) return Infinity
  let begin = 0
  return Math.max(
    ...data.blocks.map((block, b) => {
      const end = begin + block.size
      const error = units(found.slice(begin, end), truth.slice(begin, end), denominators[b], unit)
      begin = end
      return error
    }),
  )
}

// Throws where the file is not whole: what is left of it would pass unchecked.
function refuseDamage(data) {
  const sizes = data.blocks.map((b) => b.size)
  const corners = data.vertices[0].length
  const whole = (n, least, below) => Number.isInteger(n) && n >= least && n < below
  if (data.format !== 'cageproof cage vectors 1') throw new Error(`its format is ${data.format}`)
  const stated = data.candidates - data.without_truth - data.without_defect
  if (data.vectors.length !== stated) throw new Error(`${data.vectors.length} vectors, not ${stated}`)
  const most = 36 * (data.vertices.length + data.faces.length) + 1
  if (!sizes.length || !sizes.every((n) => whole(n, 1, most))) throw new Error(`its blocks have sizes ${sizes}`)
  for (const face of data.faces) {
    if ((face.length !== corners && !(QUADS && face.length === 4)) || !face.every((i) => whole(i, 0, data.vertices.length))) throw new Error(`a face is ${JSON.stringify(face)}`)
  }
  const all = sizes.reduce((a, b) => a + b)
  data.vectors.forEach((v, number) => {
    if (v.value.length !== all || !v.value.every((x) => typeof x === 'string')) throw new Error(`vector ${number} has other values than the blocks ${sizes}`)
    if (v.denominators.length !== sizes.length || !v.denominators.every((x) => typeof x === 'string' && Number(x) > 0)) {
      throw new Error(`vector ${number} has denominators ${v.denominators}`)
    }
    if (!v.defects.length || !v.defects.every((d) => d in data.defects)) throw new Error(`vector ${number} names the defects ${v.defects}`)
  })
}

function main() {
  let data, bound, errors
  try {
    data = JSON.parse(fs.readFileSync(process.argv[2], 'ascii'))
    bound = process.argv.length > 3 ? Number(process.argv[3]) : data.bound
    const unit = hexadecimal(data.unit)
    refuseDamage(data)
    if (data.unit.match(/^0x0p/) || data.bound === true || !(bound > 0 && bound < Infinity)) throw new Error('BOUND or the unit is not a positive number')
    if (data.kind !== KIND) throw new Error(`it has ${data.kind}, and the function is of ${KIND}`)
    if (!data.vectors.length || !data.vectors.every((v) => Array.isArray(v.defects))) throw new Error('the file has no vectors')
    errors = data.vectors.map((v) => worstError(data, v, unit))
  } catch (error) {
    console.error(`check_cage.js: cannot read vectors: ${error.message}; usage: node check_cage.js VECTORS.json [BOUND]`)
    return 2
  }
  const tally = new Map()
  errors.forEach((error, number) => {
    for (const flag of [...data.vectors[number].defects, 'all']) {
      const [passed, asked] = tally.get(flag) ?? [0, 0]
      tally.set(flag, [passed + (error <= bound ? 1 : 0), asked + 1])
    }
  })
  for (const [flag, [passed, asked]] of [...tally].sort()) console.log(`${flag}: ${passed} of ${asked} within ${bound} units`)
  const at = errors.indexOf(Math.max(...errors))
  console.log(`worst: ${errors[at].toPrecision(3)} units, vector ${at}: ${JSON.stringify(data.vectors[at].point)}`)
  const [passed, asked] = tally.get('all')
  return passed === asked ? 0 : 1
}

process.exitCode = main()
