// A field for a joint value, as people type it: 1.57, 1,57, pi/2, 90°, 90 deg. A number of radians that is more than a turn
// is probably meant in degrees, so the field asks.
import { button, formatNumber, h, NO_SHORTCUTS } from '../dom.js';

const DEGREE = Math.PI / 180;
const TURN = 2 * Math.PI;
const TYPED =
  /^(?<sign>[-+\u2212]?)(?<number>\d*[.,]?\d+(?:e[-+]?\d+)?|\d+[.,])?\*?(?<pi>pi|\u03c0)?(?:\/(?<below>\d+(?:\.\d+)?))?(?<unit>\u00b0|deg|degrees?|rad|radians?|m)?$/;

/** Read a typed number: { value, unit }, where the unit is 'deg', 'rad', 'm' or ''; nothing if it is no number. */
function readTyped(text) {
  const found = TYPED.exec(text.toLowerCase().replace(/\s/g, ''))?.groups;
  if (!found || (found.number === undefined && !found.pi)) return null;
  const number = Number((found.number ?? '1').replace(',', '.'));
  const size = (number * (found.pi ? Math.PI : 1)) / Number(found.below ?? 1);
  const unit = { '\u00b0': 'deg', d: 'deg', r: 'rad', m: 'm' }[found.unit?.[0]] ?? (found.pi ? 'rad' : '');
  const value = /[-\u2212]/.test(found.sign) ? -size : size;
  return Number.isFinite(value) ? { value, unit } : null;
}

/** @param set is given the value, in radians or metres. @returns { element, hint, show(value) } */
export function typedNumber(isAngle, label, current, set) {
  const hint = h('span', { class: 'kv-ask', role: 'status' });
  let asked = ''; // what the question is about: when the focus moves to its button, it must stay
  const say = (...content) => {
    hint.replaceChildren(...content);
    asked = '';
  };
  const apply = () => {
    if (asked && field.value === asked) return;
    say();
    const typed = readTyped(field.value);
    if (!typed) show(current());
    else if (!isAngle && ['deg', 'rad'].includes(typed.unit)) say('a length, in m');
    else if (!isAngle || typed.unit === 'rad') set(typed.value);
    else if (typed.unit === 'deg') set(typed.value * DEGREE);
    else if (typed.unit === 'm') say('an angle: 1.57, pi/2 or 90°');
    else if (Math.abs(typed.value) <= TURN) set(typed.value);
    else {
      const degrees = button(`${typed.value}°?`, () => {
        say();
        set(typed.value * DEGREE);
        field.focus();
      });
      say(degrees, ` or ${typed.value} rad`);
      asked = field.value;
    }
  };
  const field = h('input', {
    ...NO_SHORTCUTS,
    class: 'kv-number',
    type: 'text',
    inputmode: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-label': `${label}, as a number`,
    onchange: apply,
    onkeydown: (event) => {
      if (event.key !== 'Enter') return;
      event.preventDefault();
      event.stopPropagation(); // JupyterLab would take it
      apply();
    },
  });
  const show = (value) => {
    field.value = formatNumber(value, 3);
  };
  return {
    element: field,
    hint,
    show(value) {
      if (document.activeElement !== field || readTyped(field.value)?.value !== value) show(value);
    },
  };
}
