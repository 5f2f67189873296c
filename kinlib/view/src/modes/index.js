// Modes: what a viewer can do beyond showing an arm. Each is a function of a kit, and lives in a file of its own.
import { assign } from './assign.js';
import { assignment } from './assignment.js';
import { curve } from './curve.js';
import { row } from './row.js';

/**
 * model.get('mode') is {} or { kind, ... } with the data that Python made for it. A mode is a function
 * (kit) -> { element?, replacesSliders?, update?(q, T), dress?(), dispose?() } of
 * kit: { model, stage, data (model.get('mode')), state (q(), set(q)), say(text) }
 */
export const MODES = { assign, assignment, curve, row };
