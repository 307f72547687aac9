#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Checks one function against vectors of `cageproof vectors`; node, or any JavaScript that reads files, is enough.
//
// usage: node check.js VECTORS.json [BOUND]
// Replace `tensors`, and FORMULA. Exit 0: all vectors within BOUND conditioned units (64); 1: not all; 2: the file cannot be read.
'use strict'
const fs = require('fs')

const FORMULA = 'triangle.solid_angle' // the formula of your function

// Yours. Here: the value of triangle.solid_angle. Takes lists of numbers. Returns [value], [value, gradient] or [value, gradient, Hessian], each a list of
// numbers in the catalogue's order; those that it returns are checked.
function tensors(element, point, parameters) {
  const e = exactDifferences(element, point)
  // The determinant of exact differences: in doubles it cancels far away and on slivers.
  const volume = dot(e.vectors[0], cross(e.vectors[1], e.vectors[2]))
  if (volume === 0n) return [[angleInPlane(e.vectors)]]
  let x = element.map((corner) => corner.map((c, i) => c - point[i]))
  const size = Math.max(...x.map((v) => Math.hypot(...v)))
  x = x.map((v) => v.map((c) => c / size))
  const [a, b, c] = x
  const [la, lb, lc] = x.map((v) => Math.hypot(...v))
  const inner = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
  const below = la * lb * lc + inner(a, b) * lc + inner(b, c) * la + inner(c, a) * lb
  // The exact numbers are whole multiples of 2^exponent.
  const [mantissa, exponent] = exact(size)
  const cube = mantissa ** 3n
  const power = 3 * (exponent - e.exponent)
  const high = power >= 0 ? ratio(volume, cube << BigInt(power)) : ratio(volume << BigInt(-power), cube)
  return [[2 * Math.atan2(high, below)]]
}

// The angle of its plane that a triangle fills around the origin: the limit from inside on it, zero beside it.
function angleInPlane(corners) {
  const minus = (u, v) => u.map((s, i) => s - v[i])
  const normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
  const angles = []
  for (let k = 0; k < 3; ++k) {
    const turn = cross(corners[k], corners[(k + 1) % 3])
    // An edge that the point lies on has the plane on one of its sides only.
    if (turn.every((t) => t === 0n)) continue
    const along = dot(corners[k], corners[(k + 1) % 3])
    const size = [...turn, along].map((t) => (t < 0n ? -t : t)).reduce((s, t) => (t > s ? t : s))
    const angle = Math.atan2(Math.hypot(...turn.map((t) => ratio(t, size))), ratio(along, size))
    angles.push(dot(turn, normal) > 0n ? angle : -angle)
  }
  // Beside the triangle the angles add up to zero, up to rounding.
  const total = angles.reduce((s, t) => s + t, 0)
  return angles.length === 1 || total > 1 ? total : 0
}

// Whole numbers, exactly.
const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]

// A double as [mantissa, exponent]: mantissa * 2^exponent, exactly.
function exact(x) {
  const bits = new DataView(new ArrayBuffer(8))
  bits.setFloat64(0, x)
  const all = bits.getBigUint64(0)
  const field = Number((all >> 52n) & 2047n)
  const fraction = all & ((1n << 52n) - 1n)
  const mantissa = field > 0 ? fraction | (1n << 52n) : fraction
  return [all >> 63n ? -mantissa : mantissa, Math.max(field, 1) - 1075]
}

// Corners minus the point, as whole multiples of one power of two.
function exactDifferences(element, point) {
  const numbers = [...element, point].map((v) => v.map(exact))
  const exponent = Math.min(...numbers.flat().map(([m, e]) => (m === 0n ? 0 : e)))
  const whole = numbers.map((v) => v.map(([m, e]) => (m === 0n ? 0n : m << BigInt(e - exponent))))
  return { exponent, vectors: whole.slice(0, -1).map((v) => v.map((t, i) => t - whole[whole.length - 1][i])) }
}

// The quotient of whole numbers as a double, to 60 bits before it is rounded.
function ratio(a, b) {
  if (a === 0n) return 0
  const negative = a < 0n !== b < 0n
  if (a < 0n) a = -a
  if (b < 0n) b = -b
  const shift = b.toString(2).length - a.toString(2).length + 64
  const quotient = Number(shift >= 0 ? (a << BigInt(shift)) / b : a / (b << BigInt(-shift)))
  // Two steps, so that a denormal result is not lost.
  const half = Math.trunc(-shift / 2)
  return (negative ? -1 : 1) * quotient * 2 ** half * 2 ** (-shift - half)
}

// A decimal number as [numerator, denominator].
function decimal(text) {
  const match = /^(-?)(\d+)(?:\.(\d+))?(?:[eE]([-+]?\d+))?$/.exec(text)
  if (!match) throw new Error(`'${text}' is no decimal number`)
  const [, sign, whole, fraction = '', power = '0'] = match
  const exponent = Number(power) - fraction.length
  const digits = BigInt(sign + whole + fraction)
  return exponent >= 0 ? [digits * 10n ** BigInt(exponent), 1n] : [digits, 10n ** BigInt(-exponent)]
}

// "0x1.8p-3" as a double.
function hexadecimal(text) {
  const match = /^(-?)0x([0-9a-f]+)(?:\.([0-9a-f]*))?p([-+]?\d+)$/i.exec(text)
  if (!match) throw new Error(`'${text}' is no hexadecimal number`)
  const [, sign, whole, fraction = '', power] = match
  const digits = BigInt(`0x${whole}${fraction}`)
  const exponent = Number(power) - 4 * fraction.length
  const value = exponent >= 0 ? ratio(digits << BigInt(exponent), 1n) : ratio(digits, 1n << BigInt(-exponent))
  if (!Number.isFinite(value)) throw new Error(`'${text}' is beyond doubles`)
  return sign ? -value : value
}

// The error over the conditioned denominator, in roundings. Differences from the truth are exact.
function units(found, truth, denominator, unit) {
  if (found.length !== truth.length || !found.every(Number.isFinite)) return Infinity
  const [below, scale] = denominator
  const parts = found.map((x, i) => {
    const [mantissa, exponent] = exact(x)
    const [a, b] = exponent >= 0 ? [mantissa << BigInt(exponent), 1n] : [mantissa, 1n << BigInt(-exponent)]
    const [c, d] = truth[i]
    const off = a * d - c * b
    if (off === 0n) return 0
    return below === 0n ? Infinity : ratio(off * scale, b * d * below)
  })
  return Math.hypot(...parts) / unit
}

// The file's vectors with numbers for texts: inputs of the function, truths with their denominators by order, flags.
function vectorsOf(data) {
  const keys = ['value', 'gradient', 'hessian']
  const numbers = (list) => list.map(hexadecimal)
  if (!data.vectors.length) throw new Error('the file has no vectors')
  return data.vectors.map((v) => {
    if (!v.value || !Array.isArray(v.defects)) throw new Error('a vector has no value, or no list of defects')
    return {
      inputs: [v.element.map(numbers), numbers(v.point), numbers(v.parameters)],
      truths: keys.filter((key) => key in v).map((key) => [v[key].map(decimal), decimal(v[`${key}_denominator`])]),
      flags: v.defects,
    }
  })
}

// The largest error of the tensors that the function returns; infinite where it fails.
function worstError(inputs, truths, unit) {
  try {
    const found = tensors(...inputs).slice(0, truths.length)
    return found.length ? Math.max(...found.map((tensor, order) => units(tensor, ...truths[order], unit))) : Infinity
  } catch {
    return Infinity // yours: whatever it throws, it has no answer
  }
}

function main() {
  let data, bound, unit, vectors
  try {
    data = JSON.parse(fs.readFileSync(process.argv[2], 'ascii'))
    bound = process.argv.length > 3 ? Number(process.argv[3]) : data.bound
    unit = hexadecimal(data.unit)
    vectors = vectorsOf(data)
    if (!(bound > 0 && bound < Infinity)) throw new Error('BOUND is not a positive number')
    if (data.formula !== FORMULA) throw new Error(`it has ${data.formula}, and the function is of ${FORMULA}`)
  } catch (error) {
    console.error(`check.js: cannot read vectors: ${error.message}; usage: node check.js VECTORS.json [BOUND]`)
    return 2
  }
  const tally = new Map()
  let worst = -1, at = null
  vectors.forEach(({ inputs, truths, flags }, number) => {
    const error = worstError(inputs, truths, unit)
    if (error > worst) [worst, at] = [error, number]
    for (const flag of [...flags, 'all']) {
      const [passed, asked] = tally.get(flag) ?? [0, 0]
      tally.set(flag, [passed + (error <= bound ? 1 : 0), asked + 1])
    }
  })
  for (const [flag, [passed, asked]] of [...tally].sort()) console.log(`${flag}: ${passed} of ${asked} within ${bound} units`)
  const { element, point } = data.vectors[at]
  console.log(`worst: ${worst.toPrecision(3)} units, vector ${at}: ${JSON.stringify({ element, point })}`)
  const [passed, asked] = tally.get('all')
  return passed === asked ? 0 : 1
}

module.exports = { decimal, exactDifferences, hexadecimal, ratio, units }
if (require.main === module) process.exitCode = main()
